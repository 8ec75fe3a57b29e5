#include "bem/outline_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::bem {
namespace {

constexpr Index kBlock = fmm::kSpectralBlock;

// Values of one factor at all bins, term by term: the spectrum along the line or the line's phase
std::vector<Complex> spectra_along(const OutlineNodes& outline, const AxisTransform& axis,
                                   bool half, const Complex* x) {
  const Index length = axis.length();
  const auto lines = static_cast<Index>(outline.line.size());
  std::vector<Complex> spectra(static_cast<std::size_t>(lines * length));
  const fmm::FftBuffer values(length), spectrum(length);
  for (Index t = 0; t < lines; ++t) {
    std::fill_n(values.data(), length, Complex(0.0, 0.0));
    for (Index k = outline.line_begin[t]; k < outline.line_begin[t + 1]; ++k)
      values.data()[outline.node[k].place] = outline.node[k].moment * x[outline.node[k].node];
    axis.transform(values.data(), half, spectrum.data());
    std::copy_n(spectrum.data(), length, spectra.begin() + t * length);
  }
  return spectra;
}

std::vector<Complex> phases_across(const OutlineNodes& outline, const AxisTransform& axis,
                                   bool half) {
  std::vector<Complex> phases;
  for (const Index line : outline.line)
    for (Index bin = 0; bin < axis.length(); ++bin) phases.push_back(axis.phase(line, half, bin));
  return phases;
}

// Orders factors in x by spectral blocks
std::vector<double> pack_blocks(const std::vector<Complex>& factor, Index count, Index length,
                                bool odd) {
  const Index blocks = length / 2 / kBlock + 1;
  std::vector<double> packed(static_cast<std::size_t>(2 * blocks * count * 2 * kBlock));
  for (Index task = 0; task < 2 * blocks; ++task)
    for (Index t = 0; t < count; ++t)
      for (Index c = 0; c < kBlock; ++c) {
        const bool negative = task % 2 == 1;
        const Index m = (task / 2 * kBlock + c) % length;
        const Complex value = factor[t * length + (negative ? (length - m) % length : m)];
        const double sign = odd && negative ? -1.0 : 1.0;
        double* const at = packed.data() + (task * count + t) * 2 * kBlock + c;
        at[0] = sign * value.real();
        at[kBlock] = sign * value.imag();
      }
  return packed;
}

std::vector<Complex> pack_rows(const std::vector<Complex>& factor, Index count, Index length,
                               bool odd) {
  std::vector<Complex> packed(factor.size());
  for (Index bin = 0; bin < length; ++bin)
    for (Index t = 0; t < count; ++t) {
      const Complex value = factor[t * length + bin];
      packed[bin * count + t] = odd && bin > length / 2 ? -value : value;
    }
  return packed;
}

}  // namespace

AxisTransform::AxisTransform(Index length)
    : length_(length), plan_(length, 1, FFTW_FORWARD, fmm::FftPlan::Place::out_of) {
  for (Index k = 0; k < 2 * length; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(length);
    root_.emplace_back(std::cos(angle), -std::sin(angle));
  }
}

Complex AxisTransform::phase(Index place, bool half, Index bin) const {
  const Index m = bin > length_ / 2 ? bin + length_ : bin;  // modulo twice the length
  return root_[m * (2 * place + (half ? 1 : 0)) % (2 * length_)];
}

void AxisTransform::transform(Complex* values, bool half, Complex* spectrum) const {
  plan_.execute(values, spectrum);
  if (!half) return;
  for (Index bin = 0; bin < length_; ++bin) spectrum[bin] *= phase(0, true, bin);
}

LineProducts line_products(const OutlineNodes& outline, const SourceKind& source,
                           const AxisTransform& along_x, const AxisTransform& along_y,
                           const Complex* x) {
  const auto count = static_cast<Index>(outline.line.size());
  const bool half_x = kHalfX[source.lattice], half_y = kHalfY[source.lattice];
  const bool rows = outline.lines_along_x;
  const auto u =
      rows ? spectra_along(outline, along_x, half_x, x) : phases_across(outline, along_x, half_x);
  const auto v =
      rows ? phases_across(outline, along_y, half_y) : spectra_along(outline, along_y, half_y, x);
  return {count, pack_blocks(u, count, along_x.length(), source.odd_x),
          pack_rows(v, count, along_y.length(), source.odd_y)};
}

}  // namespace floe::bem
