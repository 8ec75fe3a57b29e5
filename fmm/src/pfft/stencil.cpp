#include "pfft/stencil.hpp"

#include <array>
#include <cmath>

namespace floe::fmm::pfft {

Index stencil_begin(double position, int stencil) {
  const double shifted = stencil % 2 == 0 ? position : position + 0.5;
  return static_cast<Index>(std::floor(shifted)) - (stencil - 1) / 2;
}

void stencil_weights(double position, int stencil, double* weight) {
  for (int a = 0; a < stencil; ++a) {
    double product = 1.0;
    for (int b = 0; b < stencil; ++b)
      if (b != a) product *= (position - b) / (a - b);
    weight[a] = product;
  }
}

double stencil_wave_error(int stencil, double phase) {
  constexpr int kSamples = 16;
  double sum = 0.0;
  std::array<double, 16> weight;
  for (int s = 0; s < kSamples; ++s) {
    const double position = 0.5 * (stencil - 1) + (s + 0.5) / kSamples - 0.5;
    stencil_weights(position, stencil, weight.data());
    Complex error = -1.0;
    for (int a = 0; a < stencil; ++a)
      error += weight[static_cast<std::size_t>(a)] * std::polar(1.0, phase * (a - position));
    sum += std::norm(error);
  }
  return std::sqrt(2.0 * sum / kSamples);
}

}  // namespace floe::fmm::pfft
