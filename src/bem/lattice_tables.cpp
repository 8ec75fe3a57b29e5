#include "bem/lattice_tables.hpp"

#include <floe/fmm/fft_plan.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/simd.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::bem {
namespace {

constexpr Index kBlock = fmm::kSpectralBlock;
constexpr Index kRow = kTargets * kSymmetries * 2 * kBlock;  // doubles a y wavenumber

// Where targets lie as seen from an element's centre, in half steps: 1 where offsets are i + 1/2
struct TargetShift {
  bool half_x, half_y;
};
constexpr TargetShift kShift[kTargets] = {{true, true}, {false, true}, {true, false}};

// Spectrum of a function that is even or odd, sampled at offsets i or i + 1/2, 0 ≤ i < count: one
// complex FFT of the mirrored samples
class SymmetricTransform {
 public:
  SymmetricTransform(Index length, bool half, bool odd)
      : length_(length),
        half_(half),
        odd_(odd),
        plan_(length, 1, -1, fmm::FftPlan::Place::in),
        buffer_(length) {}

  template <class Sample, class Store>
  void transform(Index count, const Sample& sample, const Store& store) const {
    Complex* const data = buffer_.data();
    std::fill_n(data, length_, Complex(0.0, 0.0));
    const Index mirror = half_ ? length_ - 1 : length_;
    for (Index i = 0; i < count; ++i) {
      const Complex value = odd_ && !half_ && i == 0 ? Complex(0.0, 0.0) : sample(i);
      data[i] = value;
      if (mirror - i < length_) data[mirror - i] = odd_ ? -value : value;
    }
    plan_.execute(data, data);
    for (Index m = 0; m <= length_ / 2; ++m) store(m, data[m] * phase(m));
  }

 private:
  // What the FFT gives for samples at i, moved to i + 1/2
  Complex phase(Index m) const {
    return half_ ? std::polar(1.0, -std::numbers::pi * static_cast<double>(m) /
                                       static_cast<double>(length_))
                 : Complex(1.0, 0.0);
  }

  Index length_;
  bool half_, odd_;
  fmm::FftPlan plan_;
  fmm::FftBuffer buffer_;
};

// The kernels of one kind of target at all offsets ≥ 0: column i + nx·j, rows the symmetries
Eigen::Matrix<Complex, kSymmetries, Eigen::Dynamic> offset_kernels(
    const LatticePlan& plan, const ElementIntegrals& integrals, const green::GreenTable& green,
    TargetShift shift) {
  const ElementLattice& lattice = plan.lattice;
  Eigen::Matrix<Complex, kSymmetries, Eigen::Dynamic> kernels(kSymmetries, lattice.nx * lattice.ny);
#pragma omp parallel for schedule(dynamic, 1)
  for (Index j = 0; j < lattice.ny; ++j) {
    VecXcd row(8);
    for (Index i = 0; i < lattice.nx; ++i) {
      const Point2 offset((static_cast<double>(i) + (shift.half_x ? 0.5 : 0.0)) * lattice.step_x,
                          (static_cast<double>(j) + (shift.half_y ? 0.5 : 0.0)) * lattice.step_y);
      integrals.point_row(offset, green, row);
      std::array<Complex, 8> local;
      std::copy(row.begin(), row.end(), local.begin());
      const auto combined = combine(local);
      std::copy(combined.begin(), combined.end(), kernels.col(i + lattice.nx * j).begin());
    }
  }
  return kernels;
}

// output_A(m) = Σ_p sign_p K̂_Ap(|m|) input_p(m) for one row of a block; the signs are those of the
// kernels that are odd
inline void multiply_row(const double* spectrum, const double* sign, const Complex* const* inputs,
                         Complex* const* outputs, Index row) {
  double re[kTargets][kBlock] = {}, im[kTargets][kBlock] = {};
  for (int p = 0; p < kSymmetries; ++p) {
    const double* input = reinterpret_cast<const double*>(inputs[p] + row * kBlock);
    double x[kBlock], y[kBlock];
    for (Index c = 0; c < kBlock; ++c) {
      x[c] = sign[p] * input[2 * c];
      y[c] = sign[p] * input[2 * c + 1];
    }
    for (int a = 0; a < kTargets; ++a) {
      const double* k = spectrum + (a * kSymmetries + p) * 2 * kBlock;
      for (Index c = 0; c < kBlock; ++c) {
        re[a][c] += k[c] * x[c] - k[kBlock + c] * y[c];
        im[a][c] += k[c] * y[c] + k[kBlock + c] * x[c];
      }
    }
  }
  for (int a = 0; a < kTargets; ++a) {
    double* output = reinterpret_cast<double*>(outputs[a] + row * kBlock);
    for (Index c = 0; c < kBlock; ++c) {
      output[2 * c] = re[a][c];
      output[2 * c + 1] = im[a][c];
    }
  }
}

FLOE_SIMD_CLONES void multiply_block(const double* spectrum, Index padded_ny, bool negative_x,
                                     const Complex* const* inputs, Complex* const* outputs) {
  double above[kSymmetries], below[kSymmetries];
  for (int p = 0; p < kSymmetries; ++p) {
    above[p] = kOddX[p] && negative_x ? -1.0 : 1.0;
    below[p] = kOddY[p] ? -above[p] : above[p];
  }
  for (Index n = 0; n <= padded_ny / 2; ++n) {
    multiply_row(spectrum + n * kRow, above, inputs, outputs, n);
    if (n != 0 && 2 * n != padded_ny)
      multiply_row(spectrum + n * kRow, below, inputs, outputs, padded_ny - n);
  }
}

}  // namespace

std::array<Complex, kSymmetries> combine(const std::array<Complex, 8>& local) {
  using Lattice = ElementLattice;
  const Complex a = local[Lattice::kCorner00], b = local[Lattice::kCorner10],
                c = local[Lattice::kCorner11], d = local[Lattice::kCorner01];
  const double root = std::numbers::sqrt2 / 2.0;
  return {0.5 * (a + b + c + d),
          0.5 * (b + c - a - d),
          0.5 * (c + d - a - b),
          0.5 * (a - b + c - d),
          root * (local[Lattice::kUpper] + local[Lattice::kLower]),
          root * (local[Lattice::kUpper] - local[Lattice::kLower]),
          root * (local[Lattice::kRight] + local[Lattice::kLeft]),
          root * (local[Lattice::kRight] - local[Lattice::kLeft])};
}

LatticeTables::LatticeTables(const LatticePlan& plan, const green::GreenTable& green)
    : padded_ny_(plan.grid.padded_ny()), half_ny_(padded_ny_ / 2 + 1) {
  const Index nx = plan.lattice.nx, ny = plan.lattice.ny, half_nx = plan.grid.padded_nx() / 2 + 1;
  spectrum_.assign(static_cast<std::size_t>(plan.grid.block_count() * half_ny_ * kRow), 0.0);
  // The grid's transforms are not normalised
  const double scale = 1.0 / static_cast<double>(plan.grid.padded_nx() * padded_ny_);
  const ElementIntegrals integrals(plan.element, {.tolerance = plan.tolerance});
  for (int a = 0; a < kTargets; ++a) {
    const auto kernels = offset_kernels(plan, integrals, green, kShift[a]);
#pragma omp parallel for schedule(dynamic, 1)
    for (int p = 0; p < kSymmetries; ++p) {
      // Transform along x, then along y, and store by blocks
      const SymmetricTransform along_x(plan.grid.padded_nx(), kShift[a].half_x, kOddX[p]);
      const SymmetricTransform along_y(padded_ny_, kShift[a].half_y, kOddY[p]);
      MatXcd rows(ny, half_nx);
      for (Index j = 0; j < ny; ++j)
        along_x.transform(
            nx, [&](Index i) { return kernels(p, i + nx * j); },
            [&](Index m, Complex value) { rows(j, m) = value; });
      for (Index mx = 0; mx < half_nx; ++mx)
        along_y.transform(
            ny, [&](Index j) { return rows(j, mx); },
            [&](Index my, Complex value) {
              double* at = spectrum_.data() + ((mx / kBlock) * half_ny_ + my) * kRow +
                           (a * kSymmetries + p) * 2 * kBlock + mx % kBlock;
              at[0] = scale * value.real();
              at[kBlock] = scale * value.imag();
            });
    }
  }
}

void LatticeTables::filter(const fmm::SpectralBlock& block, std::span<const Complex* const> inputs,
                           std::span<Complex* const> outputs) const {
  const double* spectrum = spectrum_.data() + block.number * half_ny_ * kRow;
  multiply_block(spectrum, padded_ny_, block.sign < 0, inputs.data(), outputs.data());
}

}  // namespace floe::bem
