#include "bem/lattice_tables.hpp"

#include "bem/offset_kernels.hpp"

#include <floe/numeric/simd.hpp>

#include <cstdlib>
#include <numbers>
#include <span>

namespace floe::bem {
namespace {

using Local = ElementLattice::Local;

constexpr Index kBlock = fmm::kSpectralBlock;
constexpr Index kRow = kSources * kNodeLattices * kBlock;  // values a bin

Complex* row_of(Complex* bin, int source, int target) {
  return bin + (source * kNodeLattices + target) * kBlock;
}

// What the element to the upper right of a source node contributes, seen from the node: a kernel at
// offsets of both signs, wrapped around the padded grid. Those to the other sides are its mirror
// images
class SideKernel final : public fmm::RowReader {
 public:
  SideKernel(const OffsetKernels& kernels, const LatticePlan& plan, int source_lattice,
             int target_lattice)
      : kernels_(kernels),
        elements_nx_(plan.nx),
        elements_ny_(plan.ny),
        padded_nx_(plan.grid.padded_nx()),
        padded_ny_(plan.grid.padded_ny()),
        centre_x_(source_lattice == kHorizontalSides ? 0 : 1),
        centre_y_(source_lattice == kVerticalSides ? 0 : 1),
        half_x_(kHalfX[source_lattice] != kHalfX[target_lattice]),
        half_y_(kHalfY[source_lattice] != kHalfY[target_lattice]),
        source_lattice_(source_lattice) {}

  fmm::InputLattice lattice() const {
    return {nullptr, padded_nx_, padded_ny_, half_x_, half_y_, this};
  }

  bool read(Index j, Complex* row) const override {
    const Index y = half_steps(j, padded_ny_, half_y_) - centre_y_;
    if (std::abs(y) >= 2 * elements_ny_) return false;
    for (Index i = 0; i < padded_nx_; ++i) {
      const Index x = half_steps(i, padded_nx_, half_x_) - centre_x_;
      row[i] = std::abs(x) < 2 * elements_nx_
                   ? kernels_(mirrored_node(x < 0, y < 0),
                              std::abs(x) / 2 + elements_nx_ * (std::abs(y) / 2))
                   : Complex(0.0, 0.0);
    }
    return true;
  }

 private:
  // Offset at a wrapped position
  static Index half_steps(Index position, Index length, bool half) {
    return 2 * (2 * position < length ? position : position - length) + (half ? 1 : 0);
  }

  // The local node which sees a target at |x|, |y| as the source node sees it at x, y
  int mirrored_node(bool left, bool below) const {
    if (source_lattice_ == kHorizontalSides) return below ? Local::kUpper : Local::kLower;
    if (source_lattice_ == kVerticalSides) return left ? Local::kRight : Local::kLeft;
    if (below) return left ? Local::kCorner11 : Local::kCorner01;
    return left ? Local::kCorner10 : Local::kCorner00;
  }

  const OffsetKernels& kernels_;  // view
  Index elements_nx_, elements_ny_, padded_nx_, padded_ny_;
  Index centre_x_, centre_y_;  // the element's centre, in half steps from the node
  bool half_x_, half_y_;
  int source_lattice_;
};

// Collects the spectra of the side kernels, at wavenumbers of all signs, and combines them to those
// of even and odd sums over the sides
class SpectrumWriter final : public fmm::SpectralFilter {
 public:
  SpectrumWriter(const fmm::PaddedGrid& grid, double factor, int target, Complex* spectrum)
      : padded_nx_(grid.padded_nx()),
        padded_ny_(grid.padded_ny()),
        norm_(factor / static_cast<double>(padded_nx_ * padded_ny_)),
        target_(target),
        spectrum_(spectrum) {}

  void filter(const fmm::SpectralBlock& block, std::span<const Complex* const> inputs,
              std::span<Complex* const>) const override {
    for (Index n = 0; n <= padded_ny_ / 2; ++n) {
      Complex* const bin = spectrum_ + (block.number * (padded_ny_ / 2 + 1) + n) * kRow;
      for (Index c = 0; c < kBlock; ++c) {
        const Index m = block.first + c;
        for (int s = 0; s < kNodeLattices; ++s) {
          if (block.sign > 0 || (m > 0 && 2 * m < padded_nx_))
            store_signs_of_y(inputs[s], block.sign, s, n, c, bin);
          else
            mirror_in_x(s, m, c, bin);
        }
        if (block.sign < 0) combine(bin, c);
      }
    }
  }

 private:
  // Places of the values at (±m_x, ±m_y) until they are combined
  static int place(int lattice, bool negative_x, bool negative_y) {
    if (lattice == kHorizontalSides) return negative_y ? 6 : 1;
    if (lattice == kVerticalSides) return negative_x ? 7 : 2;
    return negative_y ? (negative_x ? 5 : 4) : (negative_x ? 3 : 0);
  }
  Complex& at(Complex* bin, int lattice, bool negative_x, bool negative_y, Index c) const {
    return row_of(bin, place(lattice, negative_x, negative_y), target_)[c];
  }

  // NOTE: at the highest wavenumber both signs share a bin, but a half step turns their phases
  // opposite ways
  void store_signs_of_y(const Complex* input, int sign, int lattice, Index n, Index c,
                        Complex* bin) const {
    const bool left = sign < 0;
    if (left && lattice == kHorizontalSides) return;
    at(bin, lattice, left, false, c) = input[n * kBlock + c];
    if (lattice == kVerticalSides) return;
    const bool turned = 2 * n == padded_ny_ && kHalfY[lattice] != kHalfY[target_];
    const Complex mirrored = input[(padded_ny_ - n) % padded_ny_ * kBlock + c];
    at(bin, lattice, left, true, c) = turned ? -mirrored : mirrored;
  }
  void mirror_in_x(int lattice, Index m, Index c, Complex* bin) const {
    if (lattice == kHorizontalSides) return;
    const bool turned = 2 * m == padded_nx_ && kHalfX[lattice] != kHalfX[target_];
    for (const bool below : {false, true}) {
      if (below && lattice == kVerticalSides) continue;
      const Complex value = at(bin, lattice, false, below, c);
      at(bin, lattice, true, below, c) = turned ? -value : value;
    }
  }

  // Sums over the sides, with the signs of x and y where odd
  void combine(Complex* bin, Index c) const {
    Complex value[kSources];
    for (int p = 0; p < kSources; ++p) value[p] = norm_ * row_of(bin, p, target_)[c];
    const auto set = [&](int p, Complex sum) { row_of(bin, p, target_)[c] = sum; };
    set(0, value[0] + value[3] + value[4] + value[5]);
    set(3, value[0] - value[3] + value[4] - value[5]);
    set(4, value[0] + value[3] - value[4] - value[5]);
    set(5, value[0] - value[3] - value[4] + value[5]);
    set(1, value[1] + value[6]);
    set(6, value[1] - value[6]);
    set(2, value[2] + value[7]);
    set(7, value[2] - value[7]);
  }

  Index padded_nx_, padded_ny_;
  double norm_;
  int target_;
  Complex* spectrum_;  // view
};

// kSpectralBlock complex values
using Double8 = double __attribute__((vector_size(64)));

inline void load(const Complex* from, Double8& to) { __builtin_memcpy(&to, from, sizeof(to)); }

// The source's spectrum in one row of a block
inline void load_source(const LatticeTables::BlockSource& source, double sign, Index n,
                        Double8& value) {
  if (source.values) {
    load(source.values + n * kBlock, value);
    value *= sign;
    return;
  }
  value = Double8{};
  for (Index t = 0; t < source.count; ++t) {
    Double8 u, iu;
    load(source.u + t * 2 * kBlock, u);
    load(source.u + t * 2 * kBlock + kBlock, iu);
    const Complex v = source.v[n * source.count + t];
    value += v.real() * u + v.imag() * iu;
  }
}

inline void multiply_row(const Complex* table, const double* sign,
                         const LatticeTables::BlockSources& sources, Index n,
                         Complex* const* outputs) {
  // Σ K Re S and Σ K Im S: turning the latter by i is left to the end
  Double8 by_re[kNodeLattices] = {}, by_im[kNodeLattices] = {};
  for (int p = 0; p < kSources; ++p) {
    Double8 s;
    load_source(sources[p], sign[p], n, s);
    const Double8 re = __builtin_shufflevector(s, s, 0, 0, 2, 2, 4, 4, 6, 6);
    const Double8 im = __builtin_shufflevector(s, s, 1, 1, 3, 3, 5, 5, 7, 7);
    for (int a = 0; a < kNodeLattices; ++a) {
      Double8 k;
      load(table + (p * kNodeLattices + a) * kBlock, k);
      by_re[a] += k * re;
      by_im[a] += k * im;
    }
  }
  constexpr Double8 kTurn{-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0};
  for (int a = 0; a < kNodeLattices; ++a) {
    const Double8 turned = __builtin_shufflevector(by_im[a], by_im[a], 1, 0, 3, 2, 5, 4, 7, 6);
    const Double8 sum = by_re[a] + kTurn * turned;
    __builtin_memcpy(reinterpret_cast<double*>(outputs[a] + n * kBlock), &sum, sizeof(sum));
  }
}

FLOE_SIMD_CLONES void multiply_block(const Complex* table, Index padded_ny, bool negative_x,
                                     const LatticeTables::BlockSources& sources,
                                     Complex* const* outputs) {
  double above[kSources], below[kSources];
  for (int p = 0; p < kSources; ++p) {
    above[p] = kSource[p].odd_x && negative_x ? -1.0 : 1.0;
    below[p] = kSource[p].odd_y ? -above[p] : above[p];
  }
  for (Index n = 0; n <= padded_ny / 2; ++n) {
    multiply_row(table + n * kRow, above, sources, n, outputs);
    if (n != 0 && 2 * n != padded_ny)
      multiply_row(table + n * kRow, below, sources, padded_ny - n, outputs);
  }
}

}  // namespace

LatticeTables::LatticeTables(const LatticePlan& plan, const green::GreenTable& green)
    : padded_ny_(plan.grid.padded_ny()),
      spectrum_(static_cast<std::size_t>(plan.grid.block_count() * (padded_ny_ / 2 + 1) * kRow)) {
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  fmm::PaddedGrid::Workspace workspace;
  for (int target = 0; target < kNodeLattices; ++target) {
    // Targets as seen from an element's centre lie on half steps where its nodes do not
    const OffsetKernels kernels = offset_kernels(
        plan.element, plan.tolerance,
        {plan.step_x, plan.step_y, plan.nx, plan.ny, !kHalfX[target], !kHalfY[target]}, green);
    const SideKernel sides[] = {{kernels, plan, kCorners, target},
                                {kernels, plan, kHorizontalSides, target},
                                {kernels, plan, kVerticalSides, target}};
    const fmm::InputLattice inputs[] = {sides[0].lattice(), sides[1].lattice(), sides[2].lattice()};
    const SpectrumWriter writer(plan.grid, kappa, target, spectrum_.data());
    plan.grid.apply(inputs, {}, writer, &workspace);
  }
}

void LatticeTables::multiply(const fmm::SpectralBlock& block, const BlockSources& sources,
                             Complex* const* outputs) const {
  const Complex* const table = spectrum_.data() + block.number * (padded_ny_ / 2 + 1) * kRow;
  multiply_block(table, padded_ny_, block.sign < 0, sources, outputs);
}

}  // namespace floe::bem
