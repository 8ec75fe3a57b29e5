#include "padded_grid_plans.hpp"

#include <floe/fmm/even_spectrum.hpp>
#include <floe/fmm/fft_plan.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/simd.hpp>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::fmm {
namespace {

constexpr Index kBlock = kSpectralBlock;

// All products of even kernels: outputs[a] = Σ_b kernels[a·inputs + b] · inputs[b]
class KernelMatrix final : public SpectralFilter {
 public:
  explicit KernelMatrix(std::span<const EvenSpectrum* const> kernels, Index padded_ny)
      : kernels_(kernels), padded_ny_(padded_ny) {}

  void filter(const SpectralBlock& block, std::span<const double* const> inputs,
              std::span<double* const> outputs) const override {
    for (std::size_t a = 0; a < outputs.size(); ++a) {
      bool written = false;
      for (std::size_t b = 0; b < inputs.size(); ++b) {
        const EvenSpectrum* const kernel = kernels_[a * inputs.size() + b];
        if (!kernel) continue;
        if (written)
          kernel->multiply_add(block, inputs[b], outputs[a]);
        else
          kernel->multiply(block, inputs[b], outputs[a]);
        written = true;
      }
      if (!written) std::fill_n(outputs[a], 2 * padded_ny_ * kBlock, 0.0);
    }
  }

 private:
  std::span<const EvenSpectrum* const> kernels_;  // view
  Index padded_ny_;
};

// Rows go through the transforms along x four at a time: a group is padded_nx elements of kBlock
// rows, as the columns of a spectral block are padded_ny elements of kBlock wavenumbers
constexpr Index kElement = ColumnFft::kElement;
static_assert(ColumnFft::kLanes == kBlock);

Index group_count(Index rows) { return (rows + kBlock - 1) / kBlock; }
Index group_stride(Index padded_nx) { return (padded_nx + 2) * kElement; }  // no power of two

double* reals(const FftBuffer& buffer) { return reinterpret_cast<double*>(buffer.data()); }

// e^{πi m/length} of each bin
std::vector<Complex> half_step_phases(Index length) {
  std::vector<Complex> phase;
  for (Index bin = 0; bin < length; ++bin) {
    const Index m = bin > length / 2 ? bin - length : bin;
    const double angle = std::numbers::pi * static_cast<double>(m) / static_cast<double>(length);
    phase.emplace_back(std::cos(angle), std::sin(angle));
  }
  return phase;
}

// Multiplies element n by phase[n], or by its conjugate when direction < 0
FLOE_SIMD_CLONES void multiply_elements(double* data, const Complex* phase, Index count,
                                        int direction) {
  for (Index n = 0; n < count; ++n) {
    const double c = phase[n].real(), s = direction * phase[n].imag();
    double* const re = data + n * kElement;
    double* const im = re + kBlock;
    double turned[kElement];
    for (Index k = 0; k < kBlock; ++k) {
      turned[k] = c * re[k] - s * im[k];
      turned[kBlock + k] = c * im[k] + s * re[k];
    }
    for (Index k = 0; k < kElement; ++k) re[k] = turned[k];
  }
}

using Vector = double __attribute__((vector_size(8 * kBlock)));

// Four vectors from `from`, `step` doubles apart, to `to`, transposed
[[gnu::always_inline]] inline void transpose(const double* from, Index step, double* to,
                                             Index to_step) {
  Vector a, b, c, d;
  __builtin_memcpy(&a, from, sizeof(Vector));
  __builtin_memcpy(&b, from + step, sizeof(Vector));
  __builtin_memcpy(&c, from + 2 * step, sizeof(Vector));
  __builtin_memcpy(&d, from + 3 * step, sizeof(Vector));
  const Vector ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Vector ba = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Vector cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Vector dc = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  const Vector rows[] = {
      __builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ba, dc, 0, 1, 4, 5),
      __builtin_shufflevector(ab, cd, 2, 3, 6, 7), __builtin_shufflevector(ba, dc, 2, 3, 6, 7)};
  for (Index k = 0; k < kBlock; ++k) __builtin_memcpy(to + k * to_step, &rows[k], sizeof(Vector));
}

// Bin of the row spectra for slot c of a block
Index bin_of(const SpectralBlock& block, Index c, Index padded_nx) {
  const Index m = (block.first + c) % padded_nx;
  return block.sign > 0 || m == 0 ? m : padded_nx - m;
}
bool is_padding(const SpectralBlock& block, Index c, Index padded_nx) {
  const Index m = block.first + c;
  return block.sign > 0 ? 2 * m > padded_nx : m == 0 || 2 * m >= padded_nx;
}

// The block's columns, from the spectra of `rows` rows; zeros behind
FLOE_SIMD_CLONES void gather(const double* groups, Index rows, const SpectralBlock& block,
                             Index padded_nx, Index padded_ny, double* columns) {
  const Index stride = group_stride(padded_nx);
  double element[kBlock * kElement];
  for (Index g = 0; g < group_count(rows); ++g) {
    for (Index c = 0; c < kBlock; ++c)
      __builtin_memcpy(element + c * kElement,
                       groups + g * stride + bin_of(block, c, padded_nx) * kElement,
                       kElement * sizeof(double));
    double* const to = columns + g * kBlock * kElement;
    transpose(element, kElement, to, kElement);
    transpose(element + kBlock, kElement, to + kBlock, kElement);
  }
  std::fill(columns + rows * kElement, columns + (padded_ny + kBlock) * kElement, 0.0);
}

FLOE_SIMD_CLONES void scatter(const double* columns, Index rows, const SpectralBlock& block,
                              Index padded_nx, double* groups) {
  const Index stride = group_stride(padded_nx);
  double element[kBlock * kElement];
  for (Index g = 0; g < group_count(rows); ++g) {
    const double* const from = columns + g * kBlock * kElement;
    transpose(from, kElement, element, kElement);
    transpose(from + kBlock, kElement, element + kBlock, kElement);
    for (Index c = 0; c < kBlock; ++c)
      if (!is_padding(block, c, padded_nx))
        __builtin_memcpy(groups + g * stride + bin_of(block, c, padded_nx) * kElement,
                         element + c * kElement, kElement * sizeof(double));
  }
}

// One row of a group
void put_row(const Complex* row, Index count, Index lane, double* group) {
  for (Index i = 0; i < count; ++i) {
    group[i * kElement + lane] = row[i].real();
    group[i * kElement + kBlock + lane] = row[i].imag();
  }
}
void take_row(const double* group, Index count, Index lane, Complex* row) {
  for (Index i = 0; i < count; ++i)
    row[i] = {group[i * kElement + lane], group[i * kElement + kBlock + lane]};
}

}  // namespace

Index fast_fft_length(Index length) {
  for (Index n = std::max<Index>(2, length + length % 2);; n += 2) {
    Index rest = n;
    for (const Index factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1 || rest == 7) return n;
  }
}

PaddedGrid::Plans::Plans(Index padded_nx, Index padded_ny)
    : x(padded_nx),
      y(padded_ny),
      phase_x(half_step_phases(padded_nx)),
      phase_y(half_step_phases(padded_ny)) {}

PaddedGrid::PaddedGrid(Index nx, Index ny) : nx_(nx), ny_(ny) {
  FLOE_VALIDATE(nx > 0 && ny > 0,
                "invalid grid size = " << nx << " x " << ny << " (must be positive)");
  padded_nx_ = fast_fft_length(2 * nx);
  padded_ny_ = fast_fft_length(2 * ny);
  plans_ = std::make_unique<const Plans>(padded_nx_, padded_ny_);
}
PaddedGrid::~PaddedGrid() = default;
PaddedGrid::PaddedGrid(PaddedGrid&&) noexcept = default;
PaddedGrid& PaddedGrid::operator=(PaddedGrid&&) noexcept = default;

Index PaddedGrid::block_count() const { return padded_nx_ / 2 / kBlock + 1; }

double* PaddedGrid::Workspace::reserve(Index count) {
  if (count > count_) {
    buffer_ = FftBuffer(count / 2 + 1);
    count_ = count;
  }
  return reals(buffer_);
}

void PaddedGrid::transform_rows(const InputLattice& input, double* groups) const {
  const ColumnFft& fft = plans_->x;
#pragma omp parallel
  {
    const FftBuffer scratch(padded_nx_ * kBlock), row(input.nx);
#pragma omp for schedule(static)
    for (Index g = 0; g < group_count(input.ny); ++g) {
      // The transform ends in the group's own memory
      double* const group = groups + g * group_stride(padded_nx_);
      double* const start = fft.swaps() ? reals(scratch) : group;
      double* const other = fft.swaps() ? group : reals(scratch);
      std::fill_n(start, padded_nx_ * kElement, 0.0);
      bool any = false;
      for (Index lane = 0; lane < kBlock && g * kBlock + lane < input.ny; ++lane) {
        const Index j = g * kBlock + lane;
        const Complex* values = input.rows ? row.data() : input.data + j * input.nx;
        if (input.rows && !input.rows->read(j, row.data())) continue;
        put_row(values, input.nx, lane, start);
        any = true;
      }
      if (any)
        fft.execute(ColumnFft::Direction::forward, start, other);
      else
        std::fill_n(group, padded_nx_ * kElement, 0.0);
      if (input.half_x) multiply_elements(group, plans_->phase_x.data(), padded_nx_, -1);
    }
  }
}

void PaddedGrid::restore_rows(double* groups, const OutputLattice& output) const {
  const ColumnFft& fft = plans_->x;
#pragma omp parallel
  {
    const FftBuffer scratch(padded_nx_ * kBlock), row(output.nx);
#pragma omp for schedule(static)
    for (Index g = 0; g < group_count(output.ny); ++g) {
      double* const group = groups + g * group_stride(padded_nx_);
      if (output.half_x) multiply_elements(group, plans_->phase_x.data(), padded_nx_, 1);
      fft.execute(ColumnFft::Direction::backward, group, reals(scratch));
      const double* const result = fft.swaps() ? reals(scratch) : group;
      for (Index lane = 0; lane < kBlock && g * kBlock + lane < output.ny; ++lane) {
        const Index j = g * kBlock + lane;
        take_row(result, output.nx, lane, output.rows ? row.data() : output.data + j * output.nx);
        if (output.rows) output.rows->write(j, row.data());
      }
    }
  }
}

void PaddedGrid::transform_columns(std::span<const InputLattice> inputs,
                                   std::span<const OutputLattice> outputs,
                                   const SpectralFilter& filter,
                                   std::span<double* const> groups) const {
  const ColumnFft& fft = plans_->y;
  const Index size = (padded_ny_ + kBlock) * kElement;  // whole groups of rows
  const std::size_t count = inputs.size() + outputs.size();
#pragma omp parallel
  {
    const FftBuffer buffer(size / 2 * static_cast<Index>(count + 1));
    double* const scratch = reals(buffer);
    std::vector<double*> in, out;
    for (std::size_t k = 0; k < count; ++k)
      (k < inputs.size() ? in : out).push_back(scratch + size * static_cast<Index>(k + 1));

#pragma omp for schedule(static)
    for (Index number = 0; number < block_count(); ++number)
      for (const int sign : {1, -1}) {
        const SpectralBlock block{number, number * kBlock, sign};

        // Transform the inputs' columns
        for (std::size_t k = 0; k < inputs.size(); ++k) {
          double* const start = fft.swaps() ? scratch : in[k];
          double* const other = fft.swaps() ? in[k] : scratch;
          gather(groups[k], inputs[k].ny, block, padded_nx_, padded_ny_, start);
          fft.execute(ColumnFft::Direction::forward, start, other);
          if (inputs[k].half_y) multiply_elements(in[k], plans_->phase_y.data(), padded_ny_, -1);
        }

        filter.filter(block, {in.data(), in.size()}, out);

        // Transform the outputs' columns back
        for (std::size_t k = 0; k < outputs.size(); ++k) {
          if (outputs[k].half_y) multiply_elements(out[k], plans_->phase_y.data(), padded_ny_, 1);
          fft.execute(ColumnFft::Direction::backward, out[k], scratch);
          scatter(fft.swaps() ? scratch : out[k], outputs[k].ny, block, padded_nx_, groups[k]);
        }
      }
  }
}

void PaddedGrid::apply(std::span<const InputLattice> inputs, std::span<const OutputLattice> outputs,
                       const SpectralFilter& filter, Workspace* workspace) const {
  [[maybe_unused]] const auto fits = [this](const auto& lattice) {
    return lattice.nx <= padded_nx_ && lattice.ny <= padded_ny_;
  };
  FLOE_EXPECT(std::all_of(inputs.begin(), inputs.end(), fits));
  FLOE_EXPECT(std::all_of(outputs.begin(), outputs.end(), fits));

  // Lay out the row spectra; a lattice that goes in shares its rows with one that comes out
  Index row_count = 0;
  for (const auto& input : inputs) row_count = std::max(row_count, input.ny);
  for (const auto& output : outputs) row_count = std::max(row_count, output.ny);
  const Index size = group_count(row_count) * group_stride(padded_nx_);
  const auto count = static_cast<Index>(std::max(inputs.size(), outputs.size()));
  Workspace own;
  double* const memory = (workspace ? *workspace : own).reserve(count * size);
  std::vector<double*> groups;
  for (Index k = 0; k < count; ++k) groups.push_back(memory + k * size);

  for (std::size_t k = 0; k < inputs.size(); ++k) transform_rows(inputs[k], groups[k]);
  transform_columns(inputs, outputs, filter, groups);
  for (std::size_t k = 0; k < outputs.size(); ++k) restore_rows(groups[k], outputs[k]);
}

void PaddedGrid::convolve(std::span<const InputLattice> inputs,
                          std::span<const OutputLattice> outputs,
                          std::span<const EvenSpectrum* const> kernels,
                          Workspace* workspace) const {
  FLOE_EXPECT(kernels.size() == inputs.size() * outputs.size());
  apply(inputs, outputs, KernelMatrix(kernels, padded_ny_), workspace);
}

}  // namespace floe::fmm
