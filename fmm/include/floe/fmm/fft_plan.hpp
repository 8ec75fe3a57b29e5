#pragma once

#include <floe/numeric/types.hpp>

#include <fftw3.h>

#include <memory>

namespace floe::fmm {

/// Memory for transforms, aligned to cache lines.
class FftBuffer {
 public:
  explicit FftBuffer(Index count);
  Complex* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(Complex* data) const;
  };
  std::unique_ptr<Complex, Free> data_;
};

/// `howmany` interleaved 1-D transforms (element i of transform c at c + howmany·i), unnormalised,
/// from one aligned buffer to another or in place. Planned without measuring: the same bits in
/// every run. Planner calls share one mutex; executing is thread-safe.
class FftPlan {
 public:
  enum class Place { in, out_of };
  FftPlan(Index length, Index howmany, int sign, Place place);
  ~FftPlan();
  FftPlan(const FftPlan&) = delete;
  FftPlan& operator=(const FftPlan&) = delete;

  void execute(Complex* in, Complex* out) const {
    fftw_execute_dft(plan_, reinterpret_cast<fftw_complex*>(in),
                     reinterpret_cast<fftw_complex*>(out));
  }

 private:
  fftw_plan plan_;
};

}  // namespace floe::fmm
