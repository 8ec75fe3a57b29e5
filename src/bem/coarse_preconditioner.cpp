#include "bem/plate_grid.hpp"
#include "bem/wave_grid.hpp"

#include <floe/bem/coarse_preconditioner.hpp>
#include <floe/bem/element_integrals.hpp>
#include <floe/fmm/even_spectrum.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/dense_lu.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace floe::bem {
namespace {

// Cells so near that the kernel is integrated over them
constexpr Index kNear = 3;

// κ∫G over a cell, seen from the middle of another, by their offset (i, j) ≥ 0
MatXcd cell_kernel(const green::GreenTable& green, double step, Index nx, Index ny) {
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);

  // Far cells by their middle; the value at no distance is replaced below
  MatXcd kernel(nx, ny);
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < ny; ++j) {
    std::vector<double> distance(static_cast<std::size_t>(nx));
    for (Index i = 0; i < nx; ++i)
      distance[static_cast<std::size_t>(i)] =
          step * std::max(0.5, std::hypot(double(i), double(j)));
    green.evaluate(distance, {kernel.col(j).data(), static_cast<std::size_t>(nx)});
    kernel.col(j) *= kappa * step * step;
  }

  // Near cells as an element of constant pressure
  const mesh::Q8Mesh cell = mesh::make_rectangle({.length = step, .width = step, .nx = 1, .ny = 1});
  const ElementIntegrals integrals(cell, {.tolerance = 1e-5});
  VecXcd row(8);
  for (Index j = 0; j < std::min(ny, kNear + 1); ++j)
    for (Index i = 0; i < std::min(nx, kNear + 1); ++i) {
      integrals.point_row({step * double(i), step * double(j)}, green, row);
      kernel(i, j) = kappa * row.sum();
    }
  return kernel;
}

// I + K W on the active points, W the covered shares of their cells
MatXcd coarse_matrix(const PlateGrid& grid, const MatXcd& kernel) {
  const auto n = static_cast<Index>(grid.active().size());
  const Index nx = grid.nx();
  MatXcd matrix(n, n);
#pragma omp parallel for schedule(static)
  for (Index c = 0; c < n; ++c) {
    const Index source = grid.active()[static_cast<std::size_t>(c)];
    for (Index r = 0; r < n; ++r) {
      const Index target = grid.active()[static_cast<std::size_t>(r)];
      matrix(r, c) = grid.share()[c] * kernel(std::abs(target % nx - source % nx),
                                              std::abs(target / nx - source / nx));
    }
    matrix(c, c) += 1.0;
  }
  return matrix;
}

}  // namespace

struct CoarsePreconditioner::Level {
  PlateGrid grid;
  fmm::EvenSpectrum spectrum;  // of κ∫G over a cell
  numeric::DenseLu factors;    // of I + K W
};

CoarsePreconditioner::CoarsePreconditioner(const mesh::Q8Mesh& mesh, const green::GreenTable& green,
                                           const CoarseOptions& options)
    : size_(mesh.node_count()) {
  const double k = green.exact().wavenumber();
  const double step = grid_step(mesh, k, options.points_per_wavelength,
                                std::sqrt(mesh.area() / double(options.max_unknowns)));
  points_per_wavelength_ = 2.0 * std::numbers::pi / (k * step);
  PlateGrid grid(mesh, step);
  const MatXcd kernel = cell_kernel(green, step, grid.nx(), grid.ny());
  fmm::EvenSpectrum spectrum(grid.padded(), [&](Index i, Index j) { return kernel(i, j); });
  numeric::DenseLu factors(coarse_matrix(grid, kernel));
  level_ = std::make_unique<const Level>(
      Level{std::move(grid), std::move(spectrum), std::move(factors)});
}

CoarsePreconditioner::~CoarsePreconditioner() = default;

Index CoarsePreconditioner::unknowns() const {
  return static_cast<Index>(level_->grid.active().size());
}

void CoarsePreconditioner::apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const {
  const PlateGrid& grid = level_->grid;
  MatXcd value = grid.restrict_to_points(x);
  level_->factors.solve(value);
  VecXcd field(grid.point_count());
  fmm::PaddedGrid::Workspace workspace;
  const fmm::InputLattice input{field.data(), grid.nx(), grid.ny()};
  const fmm::OutputLattice output{field.data(), grid.nx(), grid.ny()};
  for (Index column = 0; column < x.cols(); ++column) {
    field.setZero();
    for (std::size_t a = 0; a < grid.active().size(); ++a)
      field[grid.active()[a]] =
          -grid.share()[static_cast<Index>(a)] * value(static_cast<Index>(a), column);
    grid.padded().apply({&input, 1}, {&output, 1}, level_->spectrum, &workspace);
    y.col(column) = x.col(column);
    grid.interpolate_add(field.data(), y.col(column).data());
  }
}

}  // namespace floe::bem
