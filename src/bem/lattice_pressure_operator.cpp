#include "bem/column_threads.hpp"
#include "bem/lattice_tables.hpp"
#include "bem/node_lattices.hpp"
#include "bem/outline_spectra.hpp"

#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace floe::bem {
namespace {

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

// Sources of one kernel, as a lattice: nodal values times their moments
class SourceRows final : public fmm::RowReader {
 public:
  SourceRows(const NodeLattices& nodes, int source, const Complex* x)
      : lattice_(nodes.lattice[kSource[source].lattice]),
        outline_(nodes.outline[source]),
        odd_(source >= kNodeLattices),
        x_(x) {}

  bool read(Index j, Complex* row) const override {
    const auto line = std::lower_bound(outline_.line.begin(), outline_.line.end(), j);
    const bool in_outline = line != outline_.line.end() && *line == j;
    if (odd_) {
      if (!in_outline) return false;
      std::fill_n(row, lattice_.nx, Complex(0.0, 0.0));
    } else {
      const std::int32_t* const node = lattice_.node.data() + lattice_.nx * j;
      for (Index i = 0; i < lattice_.nx; ++i)
        row[i] = node[i] < 0 ? Complex(0.0, 0.0) : x_[node[i]];
    }
    if (!in_outline) return true;
    const auto t = line - outline_.line.begin();
    for (Index k = outline_.line_begin[t]; k < outline_.line_begin[t + 1]; ++k)
      row[outline_.node[k].place] = outline_.node[k].moment * x_[outline_.node[k].node];
    return true;
  }

 private:
  const NodeLattice& lattice_;   // view
  const OutlineNodes& outline_;  // view
  bool odd_;
  const Complex* x_;  // view
};

// y = x + values, at the nodes of one lattice
class TargetRows final : public fmm::RowWriter {
 public:
  TargetRows(const NodeLattice& lattice, const Complex* x, Complex* y)
      : lattice_(lattice), x_(x), y_(y) {}

  void write(Index j, const Complex* row) const override {
    const std::int32_t* const node = lattice_.node.data() + lattice_.nx * j;
    for (Index i = 0; i < lattice_.nx; ++i)
      if (node[i] >= 0) y_[node[i]] = x_[node[i]] + row[i];
  }

 private:
  const NodeLattice& lattice_;  // view
  const Complex* x_;            // view
  Complex* y_;                  // view
};

// The sources of one column, and what multiplies their spectra
class ColumnFilter final : public fmm::SpectralFilter {
 public:
  ColumnFilter(const LatticePlan& plan, const LatticeTables& tables, const Complex* x)
      : tables_(tables) {
    for (int p = 0; p < kSources; ++p) {
      const OutlineNodes& outline = plan.nodes->outline[p];
      if (p < kNodeLattices || !outline.few_lines())
        whole_.push_back(p);
      else
        products_[p] = line_products(outline, kSource[p], *plan.along_x, *plan.along_y, x);
    }
  }

  /// Sources that are transformed as lattices.
  const std::vector<int>& whole() const { return whole_; }

  void filter(const fmm::SpectralBlock& block, std::span<const double* const> inputs,
              std::span<double* const> outputs) const override {
    LatticeTables::BlockSources sources;
    for (int p = 0; p < kSources; ++p) {
      const LineProducts& products = products_[p];
      const Index task = 2 * block.number + (block.sign < 0 ? 1 : 0);
      sources[p] = {nullptr, products.count,
                    products.u.data() + task * products.count * 2 * fmm::kSpectralBlock,
                    products.v.data()};
    }
    for (std::size_t k = 0; k < whole_.size(); ++k) sources[whole_[k]].values = inputs[k];
    tables_.multiply(block, sources, outputs.data());
  }

 private:
  const LatticeTables& tables_;  // view
  std::vector<int> whole_;
  std::array<LineProducts, kSources> products_;
};

void apply_column(const LatticePlan& plan, const LatticeTables& tables, const Complex* x,
                  Complex* y, fmm::PaddedGrid::Workspace& workspace) {
  const NodeLattices& nodes = *plan.nodes;
  const ColumnFilter filter(plan, tables, x);

  std::vector<SourceRows> sources;
  for (const int p : filter.whole()) sources.emplace_back(nodes, p, x);
  std::vector<fmm::InputLattice> inputs;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const int s = kSource[filter.whole()[k]].lattice;
    inputs.push_back(
        {nullptr, nodes.lattice[s].nx, nodes.lattice[s].ny, kHalfX[s], kHalfY[s], &sources[k]});
  }

  std::vector<TargetRows> targets;
  for (const NodeLattice& lattice : nodes.lattice) targets.emplace_back(lattice, x, y);
  std::vector<fmm::OutputLattice> outputs;
  for (int a = 0; a < kNodeLattices; ++a)
    outputs.push_back(
        {nullptr, nodes.lattice[a].nx, nodes.lattice[a].ny, kHalfX[a], kHalfY[a], &targets[a]});
  plan.grid.apply(inputs, outputs, filter, &workspace);
}

}  // namespace

LatticePlan::LatticePlan(const mesh::Q8Mesh& mesh, const IntegralOptions& options)
    : LatticePlan(mesh, options, require_element_lattice(mesh)) {}

// The grid reaches one step beyond the cells, as the kernels do
LatticePlan::LatticePlan(const mesh::Q8Mesh& mesh, const IntegralOptions& options,
                         const ElementLattice& elements)
    : node_count(mesh.node_count()),
      step_x(elements.step_x),
      step_y(elements.step_y),
      nx(elements.nx),
      ny(elements.ny),
      element(cell_mesh(elements)),
      tolerance(options.tolerance),
      grid(nx + 1, ny + 1),
      nodes(std::make_shared<const NodeLattices>(elements)),
      along_x(std::make_shared<const AxisTransform>(grid.padded_nx())),
      along_y(std::make_shared<const AxisTransform>(grid.padded_ny())) {}

double LatticePlan::memory() const { return nodes->memory(); }

LatticePressureOperator::LatticePressureOperator(std::shared_ptr<const LatticePlan> plan,
                                                 const green::GreenTable& green)
    : plan_(std::move(plan)), tables_(std::make_shared<const LatticeTables>(*plan_, green)) {}

double LatticePressureOperator::memory() const { return tables_->memory(); }

void LatticePressureOperator::apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const {
  FLOE_EXPECT(x.rows() == size() && y.rows() == size() && x.cols() == y.cols());
  for_columns(size(), x.cols(), [&](Index begin, Index end) {
    fmm::PaddedGrid::Workspace workspace;
    for (Index column = begin; column < end; ++column)
      apply_column(*plan_, *tables_, x.col(column).data(), y.col(column).data(), workspace);
  });
}

}  // namespace floe::bem
