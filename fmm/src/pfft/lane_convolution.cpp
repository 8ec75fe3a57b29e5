#include "pfft/lane_convolution.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

// kLanes rows of a grid, the part along x from i on, become elements i … of a transform
template <class Real>
FLOE_INLINE void rows_to_elements(const Real* rows, Index stride, Index row_count, Index count,
                                  Real* elements) {
  constexpr Index kL = kLanes<Real>;
  for (Index i = 0; i < count; i += kL) {
    Lanes<Real> v[kL];
    for (Index l = 0; l < kL; ++l) {
      v[l] = Lanes<Real>{};
      if (l < row_count) load(v[l], rows + l * stride + i);
    }
    transpose(v);
    for (Index l = 0; l < kL; ++l) store(elements + 2 * kL * (i + l), v[l]);
  }
}

template <class Real>
FLOE_INLINE void elements_to_rows(const Real* elements, Index stride, Index row_count, Index count,
                                  Real* rows) {
  constexpr Index kL = kLanes<Real>;
  for (Index i = 0; i < count; i += kL) {
    Lanes<Real> v[kL];
    for (Index l = 0; l < kL; ++l) load(v[l], elements + 2 * kL * (i + l));
    transpose(v);
    for (Index l = 0; l < row_count; ++l) store(rows + l * stride + i, v[l]);
  }
}

// Place of wavenumber ±(first + l) among the elements; wavenumbers that do not exist are padding
struct Wavenumbers {
  Index first, length;
  int sign;
  bool exists(Index l) const {
    const Index m = first + l;
    return sign > 0 ? 2 * m <= length : m >= 1 && 2 * m < length;
  }
  Index place(Index l) const {
    const Index m = (first + l) % length;
    return sign > 0 || m == 0 ? m : length - m;
  }
};

// Elements of a transform along x to the rows of a block: lanes were rows, become wavenumbers
template <class Real>
FLOE_INLINE void elements_to_block(const Real* elements, const Wavenumbers& m, Real* block) {
  constexpr Index kL = kLanes<Real>;
  for (Index part = 0; part < 2; ++part) {
    Lanes<Real> v[kL];
    for (Index l = 0; l < kL; ++l) load(v[l], elements + 2 * kL * m.place(l) + part * kL);
    transpose(v);
    for (Index l = 0; l < kL; ++l) store(block + 2 * kL * l + part * kL, v[l]);
  }
}

template <class Real>
FLOE_INLINE void block_to_elements(const Real* block, const Wavenumbers& m, Real* elements) {
  constexpr Index kL = kLanes<Real>;
  for (Index part = 0; part < 2; ++part) {
    Lanes<Real> v[kL];
    for (Index l = 0; l < kL; ++l) load(v[l], block + 2 * kL * l + part * kL);
    transpose(v);
    for (Index l = 0; l < kL; ++l)
      if (m.exists(l)) store(elements + 2 * kL * m.place(l) + part * kL, v[l]);
  }
}

// Several blocks of the same kLanes rows, both signs
template <class Real>
FLOE_INLINE void all_to_blocks(const Real* elements, Index length, Index blocks, Index block_size,
                               Real* workspace) {
  for (Index b = 0; b < 2 * blocks; ++b)
    elements_to_block(elements, {b / 2 * kLanes<Real>, length, b % 2 == 0 ? 1 : -1},
                      workspace + b * block_size);
}

template <class Real>
FLOE_INLINE void all_from_blocks(const Real* workspace, Index length, Index blocks,
                                 Index block_size, Real* elements) {
  for (Index b = 0; b < 2 * blocks; ++b)
    block_to_elements(workspace + b * block_size,
                      {b / 2 * kLanes<Real>, length, b % 2 == 0 ? 1 : -1}, elements);
}

// Elements n and length - n have the same factor
template <class Real>
FLOE_INLINE void multiply_all(const Real* spectrum, Index length, Real* elements) {
  constexpr Index kL = kLanes<Real>;
  for (Index n = 0; n < length; ++n) {
    const Real* const factor = spectrum + 2 * kL * std::min(n, length - n);
    Real* const element = elements + 2 * kL * n;
    Lanes<Real> a, b, re, im;
    load(a, factor);
    load(b, factor + kL);
    load(re, element);
    load(im, element + kL);
    store(element, Lanes<Real>(a * re - b * im));
    store(element + kL, Lanes<Real>(a * im + b * re));
  }
}

// The same for each precision, compiled for several instruction sets
#define FLOE_FOR_PRECISION(Real)                                                                  \
  FLOE_SIMD_CLONES void to_elements(const Real* rows, Index stride, Index row_count, Index count, \
                                    Real* elements) {                                             \
    rows_to_elements(rows, stride, row_count, count, elements);                                   \
  }                                                                                               \
  FLOE_SIMD_CLONES void to_rows(const Real* elements, Index stride, Index row_count, Index count, \
                                Real* rows) {                                                     \
    elements_to_rows(elements, stride, row_count, count, rows);                                   \
  }                                                                                               \
  FLOE_SIMD_CLONES void to_blocks(const Real* elements, Index length, Index blocks,               \
                                  Index block_size, Real* workspace) {                            \
    all_to_blocks(elements, length, blocks, block_size, workspace);                               \
  }                                                                                               \
  FLOE_SIMD_CLONES void from_blocks(const Real* workspace, Index length, Index blocks,            \
                                    Index block_size, Real* elements) {                           \
    all_from_blocks(workspace, length, blocks, block_size, elements);                             \
  }                                                                                               \
  FLOE_SIMD_CLONES void multiply(const Real* spectrum, Index length, Real* elements) {            \
    multiply_all(spectrum, length, elements);                                                     \
  }
FLOE_FOR_PRECISION(float)
FLOE_FOR_PRECISION(double)
#undef FLOE_FOR_PRECISION

// Spectra of even sequences, kLanes at a time: Σ over both signs of the offset, which is
// X_m + X_-m - x_0 of the transform of one sign
class EvenTransform {
 public:
  explicit EvenTransform(Index length)
      : fft_(length), data_(fft_.buffer_size()), work_(fft_.buffer_size()) {}

  // sample(i, lane) for 0 ≤ i < count; store(m, lane, value) for 0 ≤ m ≤ length/2
  template <class Sample, class Store>
  void transform(Index count, const Sample& sample, const Store& store) const {
    constexpr Index kL = kLanes<double>;
    const Index length = fft_.length();
    Complex first[kL];
    std::fill_n(data_.data(), fft_.buffer_size(), 0.0);
    for (Index i = 0; i < count; ++i)
      for (Index l = 0; l < kL; ++l) {
        const Complex value = sample(i, l);
        if (i == 0) first[l] = value;
        data_.data()[2 * kL * i + l] = value.real();
        data_.data()[2 * kL * i + kL + l] = value.imag();
      }
    const double* const result = fft_.forward(data_.data(), work_.data());
    const auto at = [&](Index m, Index l) {
      return Complex(result[2 * kL * m + l], result[2 * kL * m + kL + l]);
    };
    for (Index m = 0; m <= length / 2; ++m)
      for (Index l = 0; l < kL; ++l)
        store(m, l, at(m, l) + at((length - m) % length, l) - first[l]);
  }

 private:
  LaneFft<double> fft_;
  LaneBuffer<double> data_, work_;
};

}  // namespace

template <class Real>
LaneConvolution<Real>::LaneConvolution(Index nx, Index ny, const std::vector<Complex>& table)
    : nx_(nx),
      ny_(ny),
      along_x_(LaneFft<Real>::fast_length(2 * nx)),
      along_y_(LaneFft<Real>::fast_length(2 * ny)) {
  constexpr Index kL = kLanes<Real>, kStep = kLanes<double>;
  const Index half_x = length_x() / 2, half_y = length_y() / 2;
  const double norm = 1.0 / static_cast<double>(length_x() * length_y());
  spectrum_.resize(static_cast<std::size_t>(2 * kL * blocks() * (half_y + 1)));
  std::vector<Complex> columns(static_cast<std::size_t>((half_x + 1) * ny));
#pragma omp parallel
  {
    // Rows to wavenumbers in x, kept one column after the other
    const EvenTransform along_x(length_x()), along_y(length_y());
#pragma omp for schedule(static)
    for (Index j = 0; j < ny; j += kStep)
      along_x.transform(
          nx, [&](Index i, Index l) { return j + l < ny ? table[i + nx * (j + l)] : Complex(); },
          [&](Index m, Index l, Complex value) {
            if (j + l < ny) columns[m * ny + j + l] = value;
          });

      // Columns to wavenumbers in y
#pragma omp for schedule(static)
    for (Index m = 0; m <= half_x; m += kStep)
      along_y.transform(
          ny, [&](Index j, Index l) { return m + l <= half_x ? columns[(m + l) * ny + j] : 0.0; },
          [&](Index n, Index l, Complex value) {
            if (m + l > half_x) return;
            const Index block = (m + l) / kL, lane = (m + l) % kL;
            Real* const to = spectrum_.data() + 2 * kL * (block * (half_y + 1) + n) + lane;
            to[0] = static_cast<Real>(norm * value.real());
            to[kL] = static_cast<Real>(norm * value.imag());
          });
  }
}

template <class Real>
void LaneConvolution<Real>::transform_rows(const GridData<Real>& grid, Real* workspace) const {
  constexpr Index kL = kLanes<Real>;
#pragma omp parallel
  {
    const auto data = LaneBuffer<Real>::zeros(along_x_.buffer_size());
    const auto work = LaneBuffer<Real>::zeros(along_x_.buffer_size());
#pragma omp for schedule(static)
    for (Index j = 0; j < ny_; j += kL) {
      const Index rows = std::min(kL, ny_ - j);
      to_elements(grid.row(j), 2 * grid.stride, rows, nx_, data.data());
      to_elements(grid.row(j) + grid.stride, 2 * grid.stride, rows, nx_, data.data() + kL);
      std::fill(data.data() + 2 * kL * nx_, data.data() + kL * length_x(), Real(0));
      const Real* const result = along_x_.forward(data.data(), work.data());
      to_blocks(result, length_x(), blocks(), block_size(), workspace + 2 * kL * j);
    }
  }
}

template <class Real>
void LaneConvolution<Real>::transform_columns(Real* workspace) const {
  constexpr Index kL = kLanes<Real>;
#pragma omp parallel
  {
    const LaneBuffer<Real> data(along_y_.buffer_size()), work(along_y_.buffer_size());
#pragma omp for schedule(static)
    for (Index b = 0; b < 2 * blocks(); ++b) {
      Real* const block = workspace + b * block_size();
      std::copy_n(block, 2 * kL * ny_, data.data());
      std::fill(data.data() + 2 * kL * ny_, data.data() + kL * length_y(), Real(0));
      Real* const result = along_y_.forward(data.data(), work.data());
      multiply(spectrum_.data() + 2 * kL * (b / 2) * (length_y() / 2 + 1), length_y(), result);
      const Real* const back =
          along_y_.backward(result, result == data.data() ? work.data() : data.data());
      std::copy_n(back, 2 * kL * ny_, block);
    }
  }
}

template <class Real>
void LaneConvolution<Real>::restore_rows(const Real* workspace, GridData<Real>& grid) const {
  constexpr Index kL = kLanes<Real>;
#pragma omp parallel
  {
    const auto data = LaneBuffer<Real>::zeros(along_x_.buffer_size());
    const auto work = LaneBuffer<Real>::zeros(along_x_.buffer_size());
#pragma omp for schedule(static)
    for (Index j = 0; j < ny_; j += kL) {
      const Index rows = std::min(kL, ny_ - j);
      from_blocks(workspace + 2 * kL * j, length_x(), blocks(), block_size(), data.data());
      const Real* const result = along_x_.backward(data.data(), work.data());
      to_rows(result, 2 * grid.stride, rows, nx_, grid.row(j));
      to_rows(result + kL, 2 * grid.stride, rows, nx_, grid.row(j) + grid.stride);
    }
  }
}

template <class Real>
void LaneConvolution<Real>::apply(GridData<Real>& grid, Real* workspace) const {
  transform_rows(grid, workspace);
  transform_columns(workspace);
  restore_rows(workspace, grid);
}

template class LaneConvolution<float>;
template class LaneConvolution<double>;

}  // namespace floe::fmm::pfft
