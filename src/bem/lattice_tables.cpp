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
constexpr Index kRow = kSources * kNodeLattices * 2 * kBlock;  // doubles a bin

// A value of a bin, or of an element of a block: kBlock real parts, then kBlock imaginary parts
Complex get(const double* at) { return {at[0], at[kBlock]}; }
void set(double* at, Complex value) {
  at[0] = value.real();
  at[kBlock] = value.imag();
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
  SpectrumWriter(const fmm::PaddedGrid& grid, double factor, int target, double* spectrum)
      : padded_nx_(grid.padded_nx()),
        padded_ny_(grid.padded_ny()),
        norm_(factor / static_cast<double>(padded_nx_ * padded_ny_)),
        target_(target),
        spectrum_(spectrum) {}

  void filter(const fmm::SpectralBlock& block, std::span<const double* const> inputs,
              std::span<double* const>) const override {
    for (Index n = 0; n <= padded_ny_ / 2; ++n) {
      double* const bin = spectrum_ + (block.number * (padded_ny_ / 2 + 1) + n) * kRow;
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
  double* at(double* bin, int source, Index c) const {
    return bin + (source * kNodeLattices + target_) * 2 * kBlock + c;
  }

  // NOTE: at the highest wavenumber both signs share a bin, but a half step turns their phases
  // opposite ways
  void store_signs_of_y(const double* input, int sign, int lattice, Index n, Index c,
                        double* bin) const {
    const bool left = sign < 0;
    if (left && lattice == kHorizontalSides) return;
    set(at(bin, place(lattice, left, false), c), get(input + 2 * n * kBlock + c));
    if (lattice == kVerticalSides) return;
    const bool turned = 2 * n == padded_ny_ && kHalfY[lattice] != kHalfY[target_];
    const Complex mirrored = get(input + 2 * ((padded_ny_ - n) % padded_ny_) * kBlock + c);
    set(at(bin, place(lattice, left, true), c), turned ? -mirrored : mirrored);
  }
  void mirror_in_x(int lattice, Index m, Index c, double* bin) const {
    if (lattice == kHorizontalSides) return;
    const bool turned = 2 * m == padded_nx_ && kHalfX[lattice] != kHalfX[target_];
    for (const bool below : {false, true}) {
      if (below && lattice == kVerticalSides) continue;
      const Complex value = get(at(bin, place(lattice, false, below), c));
      set(at(bin, place(lattice, true, below), c), turned ? -value : value);
    }
  }

  // Sums over the sides, with the signs of x and y where odd
  void combine(double* bin, Index c) const {
    Complex side[kSources];
    for (int p = 0; p < kSources; ++p) side[p] = norm_ * get(at(bin, p, c));
    set(at(bin, 0, c), side[0] + side[3] + side[4] + side[5]);
    set(at(bin, 3, c), side[0] - side[3] + side[4] - side[5]);
    set(at(bin, 4, c), side[0] + side[3] - side[4] - side[5]);
    set(at(bin, 5, c), side[0] - side[3] - side[4] + side[5]);
    set(at(bin, 1, c), side[1] + side[6]);
    set(at(bin, 6, c), side[1] - side[6]);
    set(at(bin, 2, c), side[2] + side[7]);
    set(at(bin, 7, c), side[2] - side[7]);
  }

  Index padded_nx_, padded_ny_;
  double norm_;
  int target_;
  double* spectrum_;  // view
};

using Vector = double __attribute__((vector_size(8 * kBlock)));

// kBlock complex values
struct Element {
  Vector re, im;
};
[[gnu::always_inline]] inline void load(const double* from, Element& to) {
  __builtin_memcpy(&to.re, from, sizeof(Vector));
  __builtin_memcpy(&to.im, from + kBlock, sizeof(Vector));
}
[[gnu::always_inline]] inline void multiply_add(const Element& a, const Element& b, Element& sum) {
  sum.re += a.re * b.re;
  sum.im += a.re * b.im;
  sum.re -= a.im * b.im;
  sum.im += a.im * b.re;
}

// The source's spectrum in one row of a block
[[gnu::always_inline]] inline void load_source(const LatticeTables::BlockSource& source,
                                               double sign, Index n, Element& value) {
  if (source.values) {
    load(source.values + 2 * n * kBlock, value);
    value.re *= sign;
    value.im *= sign;
    return;
  }
  value = Element{};
  for (Index t = 0; t < source.count; ++t) {
    Element u;
    load(source.u + t * 2 * kBlock, u);
    const double re = source.v[n * source.count + t].real();
    const double im = source.v[n * source.count + t].imag();
    value.re += re * u.re;
    value.im += re * u.im;
    value.re -= im * u.im;
    value.im += im * u.re;
  }
}

[[gnu::always_inline]] inline void multiply_row(const double* table, const double* sign,
                                                const LatticeTables::BlockSources& sources, Index n,
                                                double* const* outputs) {
  Element sum[kNodeLattices] = {};
  for (int p = 0; p < kSources; ++p) {
    Element source;
    load_source(sources[p], sign[p], n, source);
    for (int a = 0; a < kNodeLattices; ++a) {
      Element kernel;
      load(table + (p * kNodeLattices + a) * 2 * kBlock, kernel);
      multiply_add(kernel, source, sum[a]);
    }
  }
  for (int a = 0; a < kNodeLattices; ++a) {
    __builtin_memcpy(outputs[a] + 2 * n * kBlock, &sum[a].re, sizeof(Vector));
    __builtin_memcpy(outputs[a] + (2 * n + 1) * kBlock, &sum[a].im, sizeof(Vector));
  }
}

FLOE_SIMD_CLONES void multiply_block(const double* table, Index padded_ny, bool negative_x,
                                     const LatticeTables::BlockSources& sources,
                                     double* const* outputs) {
  double above[kSources], below[kSources];
  for (int p = 0; p < kSources; ++p) {
    above[p] = kSource[p].odd_x && negative_x ? -1.0 : 1.0;
    below[p] = kSource[p].odd_y ? -above[p] : above[p];
  }
  for (Index n = 0; n <= padded_ny / 2; ++n) {
    // The second sign finds the table in the cache: fetch the next block's meanwhile
    if (negative_x)
      for (Index k = 0; k < kRow; k += 8)
        __builtin_prefetch(table + (padded_ny / 2 + 1 + n) * kRow + k, 0, 2);
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
                             double* const* outputs) const {
  const double* const table = spectrum_.data() + block.number * (padded_ny_ / 2 + 1) * kRow;
  multiply_block(table, padded_ny_, block.sign < 0, sources, outputs);
}

}  // namespace floe::bem
