#include <floe/fmm/fft_plan.hpp>

#include <mutex>
#include <new>

namespace floe::fmm {
namespace {

// FFTW's planner is not thread-safe: everything that plans or forgets a plan locks this
std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

FftBuffer::FftBuffer(Index count)
    : data_(static_cast<Complex*>(::operator new (sizeof(Complex) * static_cast<std::size_t>(count),
                                                  std::align_val_t{64}))) {}

void FftBuffer::Free::operator()(Complex* data) const {
  ::operator delete (data, std::align_val_t{64});
}

FftPlan::FftPlan(Index length, Index howmany, int sign, Place place) {
  const FftBuffer in(length * howmany), other(place == Place::in ? 1 : length * howmany);
  auto* const from = reinterpret_cast<fftw_complex*>(in.data());
  auto* const to = place == Place::in ? from : reinterpret_cast<fftw_complex*>(other.data());
  const int n = static_cast<int>(length), stride = static_cast<int>(howmany);
  const std::lock_guard<std::mutex> lock(planner_mutex());
  plan_ = fftw_plan_many_dft(1, &n, stride, from, nullptr, stride, 1, to, nullptr, stride, 1, sign,
                             FFTW_ESTIMATE);
}

FftPlan::~FftPlan() {
  const std::lock_guard<std::mutex> lock(planner_mutex());
  fftw_destroy_plan(plan_);
}

}  // namespace floe::fmm
