#include "bem/column_threads.hpp"
#include "bem/plate_grid.hpp"
#include "bem/wave_grid.hpp"

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>

namespace floe::bem {
namespace {

// A bounding box that is hardly filled is not to cost more than the operator does
double least_step(const mesh::Q8Mesh& mesh, double points_per_node) {
  const double box = (mesh.upper() - mesh.lower()).prod();
  return std::sqrt(box / (points_per_node * double(mesh.node_count())));
}

}  // namespace

DampedWavePreconditioner::DampedWavePreconditioner(const mesh::Q8Mesh& mesh,
                                                   const green::GreenFunction& green,
                                                   const DampedWaveOptions& options)
    : size_(mesh.node_count()),
      grid_(std::make_unique<const PlateGrid>(
          mesh, grid_step(mesh, green.wavenumber(), options.points_per_wavelength,
                          least_step(mesh, options.points_per_node)))) {
  width_ = grid_->width();
  spectrum_ = std::make_unique<const fmm::EvenSpectrum>(
      damped_wave_spectrum(grid_->padded(), grid_->step(), green, width_, options));
}

DampedWavePreconditioner::~DampedWavePreconditioner() = default;

Index DampedWavePreconditioner::grid_points() const { return grid_->point_count(); }

void DampedWavePreconditioner::apply(const Eigen::Ref<const MatXcd>& x,
                                     Eigen::Ref<MatXcd> y) const {
  FLOE_EXPECT(x.rows() == size() && y.rows() == size() && x.cols() == y.cols());
  const MatXcd value = grid_->restrict_to_points(x);
  for_columns(size(), x.cols(), [&](Index begin, Index end) {
    VecXcd field(grid_->point_count());
    fmm::PaddedGrid::Workspace workspace;
    const fmm::InputLattice input{field.data(), grid_->nx(), grid_->ny()};
    const fmm::OutputLattice output{field.data(), grid_->nx(), grid_->ny()};
    for (Index column = begin; column < end; ++column) {
      field.setZero();
      for (std::size_t a = 0; a < grid_->active().size(); ++a)
        field[grid_->active()[a]] = value(static_cast<Index>(a), column);
      grid_->padded().apply({&input, 1}, {&output, 1}, *spectrum_, &workspace);
      y.col(column) = x.col(column);
      grid_->interpolate_add(field.data(), y.col(column).data());
    }
  });
}

}  // namespace floe::bem
