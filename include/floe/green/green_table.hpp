#pragma once

#include <floe/fmm/radial_kernel.hpp>
#include <floe/green/green_function.hpp>

#include <cstdint>
#include <vector>

namespace floe::green {

/// G(R) as a table: piecewise polynomials of degree 7 of the whole complex function, on panels an
/// eighth of an octave wide up to a quarter to half a wavelength and equally wide beyond (G.9).
/// Relative error of G below 1e-10 between `min_distance` and `max_distance` (measured: 1e-12);
/// other distances are evaluated exactly, that is a thousand times slower. Immutable, thread-safe.
class GreenTable final : public fmm::RadialKernel {
 public:
  /// Tabulates `green` for R up to `max_distance` [m] and down to 2⁻⁴⁸ of it. Same bits for any
  /// number of threads. Throws InputError unless max_distance is positive and finite.
  GreenTable(const GreenFunction& green, double max_distance);

  void evaluate(std::span<const double> distance, std::span<Complex> value) const override;
  fmm::WaveTerm wave() const override { return green_.wave(); }

  const GreenFunction& exact() const { return green_; }
  double min_distance() const { return min_distance_; }  ///< [m]
  double max_distance() const { return max_distance_; }  ///< [m]
  /// Largest relative error of the table at `samples` distances, log-uniform, against the exact G.
  double sampled_error(int samples) const;

 private:
  GreenFunction green_;
  double min_distance_;
  double max_distance_;
  double uniform_from_;              // start of the panels of equal width [m]
  double panels_per_metre_;          // inverse of that width
  std::int64_t first_octave_;        // bit pattern of min_distance, shifted to eighths of an octave
  std::int64_t uniform_first_;       // index of the first panel of equal width
  std::vector<double> coefficient_;  // 16 a panel: re, im of each power of t in [-1, 1]
};

}  // namespace floe::green
