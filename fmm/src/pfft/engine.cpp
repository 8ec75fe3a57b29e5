#include "pfft/engine.hpp"

#include "pfft/lane_convolution.hpp"
#include "pfft/near_part.hpp"
#include "pfft/near_table.hpp"
#include "pfft/projection.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace floe::fmm::pfft {
namespace {

// Im G of coincident points. It is even and smooth, so two distances that the kernel can be asked
// for tell it to the fourth power of what they are in wavelengths.
double imag_at_zero(const RadialKernel& kernel, double spacing) {
  const double distance[] = {0.01 * spacing, 0.02 * spacing};
  Complex value[2];
  kernel.evaluate(distance, value);
  return (4.0 * value[0].imag() - value[1].imag()) / 3.0;
}

// The kernel at the grid's offsets (i, j) ≥ 0, x fastest, with the near values fitted
std::vector<Complex> make_table(const Geometry& geometry, const RadialKernel& kernel,
                                double coincident_imag) {
  const Grid& grid = geometry.grid;
  std::vector<Complex> table(static_cast<std::size_t>(grid.nx * grid.ny));
#pragma omp parallel
  {
    std::vector<double> distance(static_cast<std::size_t>(grid.nx));
#pragma omp for schedule(static)
    for (Index j = 0; j < grid.ny; ++j) {
      for (Index i = 0; i < grid.nx; ++i)
        distance[i] = grid.spacing * std::hypot(static_cast<double>(i), static_cast<double>(j));
      if (j == 0) distance[0] = 0.5 * grid.spacing;
      kernel.evaluate(distance, {table.data() + grid.nx * j, static_cast<std::size_t>(grid.nx)});
    }
  }
  table[0].imag(coincident_imag);
  fit_near_table(grid, geometry.near, kernel, table);
  return table;
}

template <class Real>
class TypedEngine final : public Engine {
 public:
  TypedEngine(const Geometry& geometry, const RadialKernel& kernel, bool with_near,
              double coincident_imag)
      : TypedEngine(geometry, make_table(geometry, kernel, coincident_imag), coincident_imag) {
    if (with_near) near_.emplace(geometry, real_, kernel);
  }

  void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials,
             bool with_near) const override;
  bool has_near() const override { return near_.has_value(); }
  void far_values(Index target, std::span<const Index> sources,
                  std::span<Complex> values) const override;
  double memory() const override { return convolution_.memory() + (near_ ? near_->memory() : 0.0); }

 private:
  TypedEngine(const Geometry& geometry, const std::vector<Complex>& table, double coincident_imag)
      : geometry_(geometry),
        coincident_imag_(static_cast<Real>(coincident_imag)),
        convolution_(geometry.grid.nx, geometry.grid.ny, table),
        real_(geometry, [&](Index i, Index j) { return table[i + geometry.grid.nx * j].real(); }),
        imag_(geometry, [&](Index i, Index j) { return table[i + geometry.grid.nx * j].imag(); }) {}

  const Geometry& geometry_;  // view
  Real coincident_imag_;
  LaneConvolution<Real> convolution_;
  Precorrection<Real> real_, imag_;
  std::optional<NearPart<Real>> near_;
};

template <class Real>
void TypedEngine<Real>::apply(const Eigen::Ref<const MatXcd>& charges,
                              Eigen::Ref<MatXcd> potentials, bool with_near) const {
  // Bring the charges into the order of the cells
  const Grid& grid = geometry_.grid;
  const VecXd scale = column_scales(charges);
  const SortedColumns<Real> q(geometry_.sources, charges, scale);
  const SortedColumns<Real> u(geometry_.targets().count(), charges.cols());

  GridData<Real> values(grid.nx, grid.ny);
  const LaneBuffer<Real> workspace(convolution_.workspace_size());
  for (Index column = 0; column < charges.cols(); ++column) {
    // Project charges onto the grid
    project(grid, geometry_.sources, q.re(column), q.im(column), values);

    // Convolve with the stored kernel spectrum
    convolution_.apply(values, workspace.data());

    // Interpolate grid potentials to targets
    interpolate(grid, geometry_.targets(), values, u.re(column), u.im(column));
  }

  // Replace the grid's share of close pairs by G(R)
  if (with_near) {
    near_->multiply_add(geometry_, q, u);
    for (Index column = 0; column < charges.cols(); ++column)
      for (const auto& [target, source] : geometry_.coincident) {
        u.re(column)[target] += coincident_imag_ * q.im(column)[source];
        u.im(column)[target] -= coincident_imag_ * q.re(column)[source];
      }
  }

  u.restore(geometry_.targets(), scale, potentials);
}

template <class Real>
void TypedEngine<Real>::far_values(Index target, std::span<const Index> sources,
                                   std::span<Complex> values) const {
  constexpr std::size_t kChunk = 128;  // on the stack: nothing is allocated a target
  typename Precorrection<Real>::Box real_box(real_), imag_box(imag_);
  real_box.fill(geometry_.targets().sorted[target]);
  imag_box.fill(geometry_.targets().sorted[target]);
  for (std::size_t first = 0; first < sources.size(); first += kChunk) {
    const std::size_t count = std::min(kChunk, sources.size() - first);
    std::int32_t sorted[kChunk];
    Real re[kChunk], im[kChunk];
    for (std::size_t k = 0; k < count; ++k)
      sorted[k] = geometry_.sources.sorted[sources[first + k]];
    real_box.values({sorted, count}, re);
    imag_box.values({sorted, count}, im);
    for (std::size_t k = 0; k < count; ++k) values[first + k] = Complex(re[k], im[k]);
  }
}

}  // namespace

std::unique_ptr<const Engine> make_engine(const Geometry& geometry, const RadialKernel& kernel,
                                          bool with_near) {
  const double coincident_imag = imag_at_zero(kernel, geometry.grid.spacing);
  if (geometry.precision == Precision::single)
    return std::make_unique<TypedEngine<float>>(geometry, kernel, with_near, coincident_imag);
  return std::make_unique<TypedEngine<double>>(geometry, kernel, with_near, coincident_imag);
}

}  // namespace floe::fmm::pfft
