#include "padded_grid_plans.hpp"

#include <floe/fmm/even_spectrum.hpp>
#include <floe/fmm/fft_plan.hpp>
#include <floe/numeric/error.hpp>

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

  void filter(const SpectralBlock& block, std::span<const Complex* const> inputs,
              std::span<Complex* const> outputs) const override {
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
      if (!written) std::fill_n(outputs[a], padded_ny_ * kBlock, Complex(0.0, 0.0));
    }
  }

 private:
  std::span<const EvenSpectrum* const> kernels_;  // view
  Index padded_ny_;
};

// Column of the row spectra for slot c of a block; -1 for padding
Index column_of(const SpectralBlock& block, Index c, Index padded_nx) {
  const Index m = block.first + c;
  if (block.sign > 0) return m <= padded_nx / 2 ? m : -1;
  return m >= 1 && m < padded_nx - m ? padded_nx - m : -1;
}

// e^{πi m/length}, the phase of half a step
Complex half_step_phase(Index m, Index length) {
  const double angle = std::numbers::pi * static_cast<double>(m) / static_cast<double>(length);
  return {std::cos(angle), std::sin(angle)};
}

Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// Phases e^{±πi m_x/padded_nx} of the columns of a block
struct ColumnPhases {
  Complex value[kBlock];
  ColumnPhases(const SpectralBlock& block, Index padded_nx, int direction) {
    for (Index c = 0; c < kBlock; ++c)
      value[c] = half_step_phase(direction * block.sign * (block.first + c), padded_nx);
  }
};

// Rows of the block: row spectra to buffer, zeros behind
void gather(const Complex* rows, Index stride, Index count, const SpectralBlock& block,
            Index padded_nx, Index padded_ny, Complex* buffer) {
  Index column[kBlock];
  bool whole = block.sign > 0;
  for (Index c = 0; c < kBlock; ++c) {
    column[c] = column_of(block, c, padded_nx);
    whole = whole && column[c] >= 0;
  }
  if (whole)
    for (Index j = 0; j < count; ++j)
      std::copy_n(rows + j * stride + block.first, kBlock, buffer + j * kBlock);
  else
    for (Index j = 0; j < count; ++j)
      for (Index c = 0; c < kBlock; ++c)
        buffer[j * kBlock + c] = column[c] < 0 ? Complex(0.0, 0.0) : rows[j * stride + column[c]];
  std::fill(buffer + count * kBlock, buffer + padded_ny * kBlock, Complex(0.0, 0.0));
}

void scatter(const Complex* buffer, Index stride, Index count, const SpectralBlock& block,
             Index padded_nx, Complex* rows) {
  for (Index c = 0; c < kBlock; ++c) {
    const Index column = column_of(block, c, padded_nx);
    if (column < 0) continue;
    for (Index j = 0; j < count; ++j) rows[j * stride + column] = buffer[j * kBlock + c];
  }
}

void multiply_columns(Complex* buffer, Index rows, const ColumnPhases& phases) {
  for (Index j = 0; j < rows; ++j)
    for (Index c = 0; c < kBlock; ++c)
      buffer[j * kBlock + c] = times(buffer[j * kBlock + c], phases.value[c]);
}

// Multiplies row m_y by e^{±πi m_y/padded_ny}; `phase` has the positive ones up to padded_ny/2
void multiply_rows(Complex* buffer, const std::vector<Complex>& phase, Index padded_ny,
                   int direction) {
  for (Index n = 0; n < padded_ny; ++n) {
    const bool upper = n > padded_ny / 2;
    Complex factor = phase[upper ? padded_ny - n : n];
    if (upper == (direction > 0)) factor = std::conj(factor);
    for (Index c = 0; c < kBlock; ++c)
      buffer[n * kBlock + c] = times(buffer[n * kBlock + c], factor);
  }
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
    : forward_x(padded_nx, 1, FFTW_FORWARD, FftPlan::Place::out_of),
      backward_x(padded_nx, 1, FFTW_BACKWARD, FftPlan::Place::out_of),
      forward_y(padded_ny, kBlock, FFTW_FORWARD, FftPlan::Place::out_of),
      backward_y(padded_ny, kBlock, FFTW_BACKWARD, FftPlan::Place::out_of) {
  for (Index n = 0; n <= padded_ny / 2; ++n) phase_y.push_back(half_step_phase(n, padded_ny));
}

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

void PaddedGrid::transform_rows(const InputLattice& input, Complex* rows) const {
#pragma omp parallel
  {
    const FftBuffer row(padded_nx_);
    std::fill_n(row.data(), padded_nx_, Complex(0.0, 0.0));
#pragma omp for schedule(static)
    for (Index j = 0; j < input.ny; ++j) {
      Complex* const spectrum = rows + j * row_stride();
      if (!input.rows) {
        std::copy_n(input.data + j * input.nx, input.nx, row.data());
      } else if (!input.rows->read(j, row.data())) {
        std::fill_n(spectrum, padded_nx_, Complex(0.0, 0.0));
        continue;
      }
      // NOTE: an out-of-place plan keeps its input, but for c2r; the zeros behind stay
      plans_->forward_x.execute(row.data(), spectrum);
    }
  }
}

void PaddedGrid::restore_rows(const Complex* rows, const OutputLattice& output) const {
#pragma omp parallel
  {
    const FftBuffer row(padded_nx_);
#pragma omp for schedule(static)
    for (Index j = 0; j < output.ny; ++j) {
      plans_->backward_x.execute(const_cast<Complex*>(rows + j * row_stride()), row.data());
      if (output.rows)
        output.rows->write(j, row.data());
      else
        std::copy_n(row.data(), output.nx, output.data + j * output.nx);
    }
  }
}

void PaddedGrid::transform_columns(std::span<const InputLattice> inputs,
                                   std::span<const OutputLattice> outputs,
                                   const SpectralFilter& filter,
                                   std::span<Complex* const> rows) const {
  const Index size = padded_ny_ * kBlock;
#pragma omp parallel
  {
    const FftBuffer buffer(size * static_cast<Index>(inputs.size() + outputs.size() + 1));
    Complex* const plane = buffer.data();
    std::vector<Complex*> in, out;
    for (std::size_t k = 0; k < inputs.size() + outputs.size(); ++k)
      (k < inputs.size() ? in : out).push_back(plane + size * static_cast<Index>(k + 1));

#pragma omp for schedule(static)
    for (Index number = 0; number < block_count(); ++number)
      for (const int sign : {1, -1}) {
        const SpectralBlock block{number, number * kBlock, sign};

        // Transform the inputs' columns
        for (std::size_t k = 0; k < inputs.size(); ++k) {
          gather(rows[k], row_stride(), inputs[k].ny, block, padded_nx_, padded_ny_, plane);
          if (inputs[k].half_x)
            multiply_columns(plane, inputs[k].ny, ColumnPhases(block, padded_nx_, -1));
          plans_->forward_y.execute(plane, in[k]);
          if (inputs[k].half_y) multiply_rows(in[k], plans_->phase_y, padded_ny_, -1);
        }

        filter.filter(block, {in.data(), in.size()}, out);

        // Transform the outputs' columns back
        for (std::size_t k = 0; k < outputs.size(); ++k) {
          if (outputs[k].half_y) multiply_rows(out[k], plans_->phase_y, padded_ny_, 1);
          plans_->backward_y.execute(out[k], plane);
          if (outputs[k].half_x)
            multiply_columns(plane, outputs[k].ny, ColumnPhases(block, padded_nx_, 1));
          scatter(plane, row_stride(), outputs[k].ny, block, padded_nx_, rows[k]);
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
  const std::size_t count = std::max(inputs.size(), outputs.size());
  Index row_count = 0;
  for (const auto& input : inputs) row_count = std::max(row_count, input.ny);
  for (const auto& output : outputs) row_count = std::max(row_count, output.ny);
  const Index size = row_count * row_stride() + 8;
  Workspace own;
  Workspace& memory = workspace ? *workspace : own;
  if (memory.size() < count * static_cast<std::size_t>(size))
    memory.resize(count * static_cast<std::size_t>(size));
  const auto misfit = reinterpret_cast<std::uintptr_t>(memory.data()) % 128 / sizeof(Complex);
  std::vector<Complex*> rows;
  for (std::size_t k = 0; k < count; ++k)
    rows.push_back(memory.data() + (8 - misfit) % 8 + k * static_cast<std::size_t>(size - 8));

  for (std::size_t k = 0; k < inputs.size(); ++k) transform_rows(inputs[k], rows[k]);
  transform_columns(inputs, outputs, filter, rows);
  for (std::size_t k = 0; k < outputs.size(); ++k) restore_rows(rows[k], outputs[k]);
}

void PaddedGrid::convolve(std::span<const InputLattice> inputs,
                          std::span<const OutputLattice> outputs,
                          std::span<const EvenSpectrum* const> kernels,
                          Workspace* workspace) const {
  FLOE_EXPECT(kernels.size() == inputs.size() * outputs.size());
  apply(inputs, outputs, KernelMatrix(kernels, padded_ny_), workspace);
}

}  // namespace floe::fmm
