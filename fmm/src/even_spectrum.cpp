#include "padded_grid_plans.hpp"

#include <floe/fmm/even_spectrum.hpp>
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
  for (Index c = 0; c < 2 * kBlock; c += 2) {
    const double re = value[c] * input[c] - value[c + 1] * input[c + 1];
    const double im = value[c] * input[c + 1] + value[c + 1] * input[c];
    output[c] = Add ? output[c] + re : re;
    output[c + 1] = Add ? output[c + 1] + im : im;
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

const double* reals(const Complex* value) { return reinterpret_cast<const double*>(value); }
double* reals(Complex* value) { return reinterpret_cast<double*>(value); }

}  // namespace

EvenSpectrum::EvenSpectrum(const PaddedGrid& grid)
    : padded_nx_(grid.padded_nx()),
      padded_ny_(grid.padded_ny()),
      value_(static_cast<std::size_t>(grid.block_count() * (padded_ny_ / 2 + 1) * kBlock)) {}

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
        [&](Index n, Complex value) { at(m, n) = norm * value; });
}

EvenSpectrum EvenSpectrum::from_symbol(const PaddedGrid& grid, const Function& symbol) {
  EvenSpectrum spectrum(grid);
  const double norm = 1.0 / static_cast<double>(grid.padded_nx() * grid.padded_ny());
  for (Index n = 0; n <= grid.padded_ny() / 2; ++n)
    for (Index m = 0; m <= grid.padded_nx() / 2; ++m) spectrum.at(m, n) = norm * symbol(m, n);
  return spectrum;
}

Complex& EvenSpectrum::at(Index mx, Index my) {
  const Index block = mx / kBlock;
  return value_[static_cast<std::size_t>((block * (padded_ny_ / 2 + 1) + my) * kBlock +
                                         mx % kBlock)];
}

void EvenSpectrum::multiply(const SpectralBlock& block, const Complex* input,
                            Complex* output) const {
  const Complex* const value = value_.data() + block.number * (padded_ny_ / 2 + 1) * kBlock;
  multiply_block_set(reals(value), padded_ny_, reals(input), reals(output));
}

void EvenSpectrum::multiply_add(const SpectralBlock& block, const Complex* input,
                                Complex* output) const {
  const Complex* const value = value_.data() + block.number * (padded_ny_ / 2 + 1) * kBlock;
  multiply_block_add(reals(value), padded_ny_, reals(input), reals(output));
}

void EvenSpectrum::filter(const SpectralBlock& block, std::span<const Complex* const> inputs,
                          std::span<Complex* const> outputs) const {
  multiply(block, inputs[0], outputs[0]);
}

}  // namespace floe::fmm
