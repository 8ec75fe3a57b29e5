#pragma once

#include <floe/fmm/fft_plan.hpp>
#include <floe/numeric/types.hpp>

#include <memory>
#include <span>

namespace floe::fmm {

/// Smallest length ≥ `length` of the form 2^a 3^b 5^c 7^d (d ≤ 1), even.
Index fast_fft_length(Index length);

/// Values of a lattice that do not lie side by side, handed over row by row; must be thread-safe.
class RowReader {
 public:
  virtual ~RowReader() = default;
  /// Fills the nx values of row j; returns false, and need not fill them, where all are zero.
  virtual bool read(Index j, Complex* row) const = 0;
};
class RowWriter {
 public:
  virtual ~RowWriter() = default;
  /// Takes the nx values of row j.
  virtual void write(Index j, const Complex* row) const = 0;
};

/// Complex data on a lattice of nx × ny points, x fastest: value (i, j) at data[i + nx·j], or where
/// `rows` says. Its points lie at (i + half_x/2, j + half_y/2) steps, so that lattices shifted by
/// half a step can be coupled. A view: the caller keeps the data.
template <class Value, class Rows>
struct LatticeView {
  Value* data;
  Index nx, ny;
  bool half_x = false, half_y = false;
  const Rows* rows = nullptr;  ///< view; instead of `data`
};
using InputLattice = LatticeView<const Complex, RowReader>;
using OutputLattice = LatticeView<Complex, RowWriter>;

/// A piece of the spectrum: columns of kSpectralBlock wavenumbers in x by all in y. Element (n, c)
/// has its real part at 2n·kSpectralBlock + c, its imaginary part kSpectralBlock further on, and
/// the wavenumber numbers
///   m_x = sign·(first + c),   m_y = n, or n - padded_ny() when n > padded_ny()/2,
/// that is m/(padded length · step) cycles a metre. Elements with first + c > padded_nx()/2, or
/// with sign < 0 and m_x = 0 or padded_nx()/2, are padding; they are finite and their value does
/// not matter.
struct SpectralBlock {
  Index number;  ///< blocks are numbered by `first`; both signs have the same number
  Index first;
  int sign;
};
inline constexpr Index kSpectralBlock = 4;

/// What happens to spectra between the transforms; must be thread-safe.
class SpectralFilter {
 public:
  virtual ~SpectralFilter() = default;

  /// Fills every output's block from the inputs' blocks, padded_ny() × kSpectralBlock each. The
  /// thread that filters a block of positive sign filters the negative one next.
  virtual void filter(const SpectralBlock& block, std::span<const double* const> inputs,
                      std::span<double* const> outputs) const = 0;
};

/// A spectrum even in both wavenumbers, of which a quarter is stored:
/// 4·padded_nx()·padded_ny() bytes.
class EvenSpectrum;

/// Zero-padded 2-D FFT on the plane, pruned and fused (F.4): x-transforms of non-zero rows only,
/// four at a time, then for few columns at a time, which stay in cache, y-transform, filter,
/// inverse y-transform, and inverse x-transforms of the rows that are wanted. The full spectrum is
/// never stored. Convolutions are linear (nothing wraps around) for lattices up to nx × ny; larger
/// ones, up to the padded size, serve to find the spectrum of a kernel. Execution is const,
/// thread-safe, parallel over rows and columns, and has the same bits for any number of threads.
/// Put the long side on x.
class PaddedGrid {
 public:
  /// Throws InputError unless both sizes are positive.
  PaddedGrid(Index nx, Index ny);
  ~PaddedGrid();
  PaddedGrid(PaddedGrid&&) noexcept;
  PaddedGrid& operator=(PaddedGrid&&) noexcept;

  Index nx() const { return nx_; }
  Index ny() const { return ny_; }
  Index padded_nx() const { return padded_nx_; }  ///< ≥ 2 nx
  Index padded_ny() const { return padded_ny_; }  ///< ≥ 2 ny
  Index block_count() const;                      ///< spectral blocks of one sign

  /// Transforms the inputs, filters their spectra, transforms back to the outputs. Outputs may be
  /// the inputs' memory. Spectra belong to lattices at integer positions: the phases of half steps
  /// are taken out of inputs before the filter and put into outputs after it, so that an even
  /// kernel has a real-symmetric, quarter-stored spectrum whatever the shifts. `workspace` (any
  /// object of the caller's, one a thread that calls) keeps memory between calls.
  class Workspace {
   public:
    /// Memory for `count` doubles, aligned to cache lines; what it held is lost.
    double* reserve(Index count);

   private:
    FftBuffer buffer_{0};
    Index count_ = 0;
  };
  void apply(std::span<const InputLattice> inputs, std::span<const OutputLattice> outputs,
             const SpectralFilter& filter, Workspace* workspace = nullptr) const;

  /// outputs[a] = Σ_b kernels[a·inputs + b] * inputs[b]; a null kernel couples nothing.
  void convolve(std::span<const InputLattice> inputs, std::span<const OutputLattice> outputs,
                std::span<const EvenSpectrum* const> kernels, Workspace* workspace = nullptr) const;

 private:
  friend class EvenSpectrum;
  struct Plans;

  void transform_rows(const InputLattice& input, double* groups) const;
  void transform_columns(std::span<const InputLattice> inputs,
                         std::span<const OutputLattice> outputs, const SpectralFilter& filter,
                         std::span<double* const> groups) const;
  void restore_rows(double* groups, const OutputLattice& output) const;

  Index nx_, ny_, padded_nx_, padded_ny_;
  std::unique_ptr<const Plans> plans_;
};

}  // namespace floe::fmm
