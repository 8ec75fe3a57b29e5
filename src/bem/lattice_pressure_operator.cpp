#include "bem/lattice_tables.hpp"

#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <numbers>
#include <utility>

namespace floe::bem {
namespace {

ElementLattice require_lattice(const mesh::Q8Mesh& mesh) {
  auto lattice = find_element_lattice(mesh);
  FLOE_VALIDATE_AS(
      MeshError, lattice.has_value(),
      "method = lattice on this mesh (must have equal rectangular elements, parallel to "
      "the axes, on one lattice)");
  return std::move(*lattice);
}

// One cell, its nodes numbered by ElementLattice::Local
mesh::Q8Mesh cell_mesh(const ElementLattice& lattice) {
  const mesh::Q8Mesh cell =
      mesh::make_rectangle({.length = lattice.step_x, .width = lattice.step_y, .nx = 1, .ny = 1});
  const auto found = find_element_lattice(cell);
  Points2 nodes(2, 8);
  mesh::Connectivity elements(8, 1);
  for (int local = 0; local < 8; ++local) {
    const Index node = found->connectivity(local, 0);
    nodes.col(local) = cell.nodes().col(node);
    for (int a = 0; a < 8; ++a)
      if (cell.elements()(a, 0) == node) elements(a, 0) = local;
  }
  return {std::move(nodes), std::move(elements)};
}

// Kernels reach one lattice step beyond the cells
fmm::PaddedGrid padded_grid(const ElementLattice& lattice) {
  return {lattice.nx + 1, lattice.ny + 1};
}

// Kind of target and place on its lattice of each local node
struct TargetPlace {
  int target, dx, dy;
};
constexpr TargetPlace kPlace[8] = {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1},
                                   {1, 0, 0}, {1, 0, 1}, {2, 0, 0}, {2, 1, 0}};

}  // namespace

LatticePlan::LatticePlan(const mesh::Q8Mesh& mesh, const IntegralOptions& options)
    : lattice(require_lattice(mesh)),
      node_count(mesh.node_count()),
      element(cell_mesh(lattice)),
      tolerance(options.tolerance),
      grid(padded_grid(lattice)) {}

LatticePressureOperator::LatticePressureOperator(std::shared_ptr<const LatticePlan> plan,
                                                 const green::GreenTable& green)
    : plan_(std::move(plan)),
      tables_(std::make_shared<const LatticeTables>(*plan_, green)),
      kappa_(green.exact().nu() / (4.0 * std::numbers::pi)) {}

double LatticePressureOperator::memory() const { return tables_->memory(); }

void LatticePressureOperator::apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const {
  FLOE_EXPECT(x.rows() == size() && y.rows() == size() && x.cols() == y.cols());
  for (Index column = 0; column < x.cols(); ++column)
    apply_column(x.col(column).data(), y.col(column).data());
}

void LatticePressureOperator::apply_column(const Complex* x, Complex* y) const {
  const ElementLattice& lattice = plan_->lattice;
  const Index nx = lattice.nx, ny = lattice.ny, cells = nx * ny, elements = lattice.cell.cols();

  // Spread nodal values to the symmetry combinations of each cell; empty cells hold nothing
  MatXcd sources = MatXcd::Zero(cells, kSymmetries);
#pragma omp parallel for schedule(static)
  for (Index e = 0; e < elements; ++e) {
    std::array<Complex, 8> local;
    for (int l = 0; l < 8; ++l) local[l] = x[lattice.connectivity(l, e)];
    const auto combined = combine(local);
    const Index cell = lattice.cell(0, e) + nx * lattice.cell(1, e);
    for (int p = 0; p < kSymmetries; ++p) sources(cell, p) = combined[p];
  }

  // Convolve them with the kernels to the lattices of corners and of mid-sides
  std::array<fmm::InputLattice, kSymmetries> inputs;
  for (int p = 0; p < kSymmetries; ++p) inputs[p] = {sources.col(p).data(), nx, ny, true, true};
  VecXcd corners((nx + 1) * (ny + 1)), horizontal(nx * (ny + 1)), vertical((nx + 1) * ny);
  const std::array<fmm::OutputLattice, kTargets> outputs{
      fmm::OutputLattice{corners.data(), nx + 1, ny + 1, false, false},
      fmm::OutputLattice{horizontal.data(), nx, ny + 1, true, false},
      fmm::OutputLattice{vertical.data(), nx + 1, ny, false, true}};
  plan_->grid.apply(inputs, outputs, *tables_);

  // Gather at the nodes. Nodes shared by elements are written more than once, with the same value
  for (Index e = 0; e < elements; ++e)
    for (int l = 0; l < 8; ++l) {
      const TargetPlace place = kPlace[l];
      const Index i = lattice.cell(0, e) + place.dx, j = lattice.cell(1, e) + place.dy;
      const fmm::OutputLattice& lattice_of_target = outputs[place.target];
      const Index node = lattice.connectivity(l, e);
      y[node] = x[node] + kappa_ * lattice_of_target.data[i + lattice_of_target.nx * j];
    }
}

}  // namespace floe::bem
