#include <floe/fmm/grid_convolution.hpp>

#include <utility>

namespace floe::fmm {

GridConvolution::GridConvolution(std::shared_ptr<const PaddedGrid> grid, EvenSpectrum spectrum)
    : grid_(std::move(grid)), spectrum_(std::move(spectrum)) {}

void GridConvolution::apply(Complex* data, PaddedGrid::Workspace* workspace) const {
  const InputLattice input{data, grid_->nx(), grid_->ny()};
  const OutputLattice output{data, grid_->nx(), grid_->ny()};
  grid_->apply({&input, 1}, {&output, 1}, spectrum_, workspace);
}

}  // namespace floe::fmm
