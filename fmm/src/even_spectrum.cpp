#include "padded_grid_plans.hpp"

#include <floe/fmm/even_spectrum.hpp>
#include <floe/fmm/fft_plan.hpp>
#include <floe/numeric/simd.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::fmm {
namespace {

constexpr Index kBlock = kSpectralBlock;

// output = (Add ? output : 0) + value · input for one row of a block
template <bool Add>
inline void multiply_row(const double* value, const double* input, double* output) {
  for (Index c = 0; c < kBlock; ++c) {
    const double re = value[c] * input[c] - value[kBlock + c] * input[kBlock + c];
    const double im = value[c] * input[kBlock + c] + value[kBlock + c] * input[c];
    output[c] = Add ? output[c] + re : re;
    output[kBlock + c] = Add ? output[kBlock + c] + im : im;
  }
}

template <bool Add>
inline void multiply_block(const double* value, Index padded_ny, const double* input,
                           double* output) {
  constexpr Index kRow = 2 * kBlock;
  for (Index n = 0; n <= padded_ny / 2; ++n) {
    multiply_row<Add>(value + n * kRow, input + n * kRow, output + n * kRow);
    if (n == 0 || 2 * n == padded_ny) continue;
    const Index mirror = (padded_ny - n) * kRow;
    multiply_row<Add>(value + n * kRow, input + mirror, output + mirror);
  }
}

FLOE_SIMD_CLONES
void multiply_block_set(const double* value, Index padded_ny, const double* input, double* output) {
  multiply_block<false>(value, padded_ny, input, output);
}

FLOE_SIMD_CLONES
void multiply_block_add(const double* value, Index padded_ny, const double* input, double* output) {
  multiply_block<true>(value, padded_ny, input, output);
}

// Transforms samples of an even function, 0 ≤ i < count, to its spectrum, 0 ≤ m ≤ length/2
class EvenTransform {
 public:
  EvenTransform(Index length, EvenSpectrum::Centre centre)
      : length_(length),
        centre_(centre),
        plan_(length, 1, FFTW_FORWARD, FftPlan::Place::in),
        buffer_(length) {}

  template <class Sample, class Store>
  void transform(Index count, const Sample& sample, const Store& store) const {
    Complex* const data = buffer_.data();
    std::fill_n(data, length_, Complex(0.0, 0.0));
    const Index mirror = centre_ == EvenSpectrum::Centre::half ? length_ - 1 : length_;
    for (Index i = 0; i < count; ++i) {
      data[i] = sample(i);
      if (mirror - i < length_) data[mirror - i] = data[i];
    }
    plan_.execute(data, data);
    for (Index m = 0; m <= length_ / 2; ++m) store(m, data[m] * phase(m));
  }

 private:
  // Samples at i + 1/2: e^{-πi m/length} is taken out of what the FFT gives for samples at i
  Complex phase(Index m) const {
    if (centre_ == EvenSpectrum::Centre::integer) return 1.0;
    const double angle = std::numbers::pi * static_cast<double>(m) / static_cast<double>(length_);
    return {std::cos(angle), -std::sin(angle)};
  }

  Index length_;
  EvenSpectrum::Centre centre_;
  FftPlan plan_;
  FftBuffer buffer_;
};

}  // namespace

EvenSpectrum::EvenSpectrum(const PaddedGrid& grid)
    : padded_nx_(grid.padded_nx()),
      padded_ny_(grid.padded_ny()),
      value_(static_cast<std::size_t>(grid.block_count() * (padded_ny_ / 2 + 1) * 2 * kBlock)) {}

EvenSpectrum::EvenSpectrum(const PaddedGrid& grid, const Function& kernel, Centre x, Centre y)
    : EvenSpectrum(grid) {
  // Rows to wavenumbers in x, kept transposed: one column after the other
  const Index half = padded_nx_ / 2, ny = grid.ny();
  std::vector<Complex> columns(static_cast<std::size_t>((half + 1) * ny));
  const EvenTransform along_x(padded_nx_, x), along_y(padded_ny_, y);
  for (Index j = 0; j < ny; ++j)
    along_x.transform(
        grid.nx(), [&](Index i) { return kernel(i, j); },
        [&](Index m, Complex value) { columns[static_cast<std::size_t>(m * ny + j)] = value; });

  // Columns to wavenumbers in y, with the norm of the inverse transform
  const double norm = 1.0 / static_cast<double>(padded_nx_ * padded_ny_);
  for (Index m = 0; m <= half; ++m)
    along_y.transform(
        ny, [&](Index j) { return columns[static_cast<std::size_t>(m * ny + j)]; },
        [&](Index n, Complex value) { set(m, n, norm * value); });
}

EvenSpectrum EvenSpectrum::from_symbol(const PaddedGrid& grid, const Function& symbol) {
  EvenSpectrum spectrum(grid);
  const double norm = 1.0 / static_cast<double>(grid.padded_nx() * grid.padded_ny());
  for (Index n = 0; n <= grid.padded_ny() / 2; ++n)
    for (Index m = 0; m <= grid.padded_nx() / 2; ++m) spectrum.set(m, n, norm * symbol(m, n));
  return spectrum;
}

void EvenSpectrum::set(Index mx, Index my, Complex value) {
  const Index bin = mx / kBlock * (padded_ny_ / 2 + 1) + my;
  double* const at = value_.data() + bin * 2 * kBlock + mx % kBlock;
  at[0] = value.real();
  at[kBlock] = value.imag();
}

void EvenSpectrum::multiply(const SpectralBlock& block, const double* input, double* output) const {
  const double* const value = value_.data() + block.number * (padded_ny_ / 2 + 1) * 2 * kBlock;
  multiply_block_set(value, padded_ny_, input, output);
}

void EvenSpectrum::multiply_add(const SpectralBlock& block, const double* input,
                                double* output) const {
  const double* const value = value_.data() + block.number * (padded_ny_ / 2 + 1) * 2 * kBlock;
  multiply_block_add(value, padded_ny_, input, output);
}

void EvenSpectrum::filter(const SpectralBlock& block, std::span<const double* const> inputs,
                          std::span<double* const> outputs) const {
  multiply(block, inputs[0], outputs[0]);
}

}  // namespace floe::fmm
