#pragma once

#include <floe/fmm/padded_grid.hpp>

#include <fftw3.h>

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

/// The anchor of every speed target, and how times are taken: CPU time, medians.
namespace floe::bench {

/// CPU time of the process so far [s].
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds_of(const Work& work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// F1: FFTW's plain zero-padded 2-D complex convolution for nx × ny points, long side contiguous:
/// forward, times a full spectrum, inverse, in place.
class F1 {
 public:
  F1(Index nx, Index ny, unsigned effort)
      : px_(fmm::fast_fft_length(2 * nx)), py_(fmm::fast_fft_length(2 * ny)) {
    data_ = fftw_alloc_complex(size());
    const int rows = static_cast<int>(py_), columns = static_cast<int>(px_);
    forward_ = fftw_plan_dft_2d(rows, columns, data_, data_, FFTW_FORWARD, effort);
    backward_ = fftw_plan_dft_2d(rows, columns, data_, data_, FFTW_BACKWARD, effort);
    spectrum_.assign(size(), Complex(0.5, 0.25));
    std::fill_n(reinterpret_cast<double*>(data_), 2 * size(), 0.0);
    data_[1][0] = 1.0;
  }
  F1(const F1&) = delete;
  F1& operator=(const F1&) = delete;
  ~F1() {
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
    fftw_free(data_);
  }

  double seconds() const {
    return seconds_of([&] {
      fftw_execute(forward_);
      const double norm = 1.0 / static_cast<double>(size());
      for (std::size_t i = 0; i < size(); ++i) {
        const double re = data_[i][0], im = data_[i][1];
        data_[i][0] = norm * (re * spectrum_[i].real() - im * spectrum_[i].imag());
        data_[i][1] = norm * (re * spectrum_[i].imag() + im * spectrum_[i].real());
      }
      fftw_execute(backward_);
    });
  }

 private:
  std::size_t size() const { return static_cast<std::size_t>(px_ * py_); }

  Index px_, py_;
  fftw_complex* data_;
  fftw_plan forward_, backward_;
  std::vector<Complex> spectrum_;
};

}  // namespace floe::bench
