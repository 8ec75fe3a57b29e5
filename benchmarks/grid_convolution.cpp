// GridConvolution against F1 (SPEED: the anchor), alternating, medians of CPU time on one thread.

#include "f1.hpp"

#include <floe/fmm/grid_convolution.hpp>

#include <omp.h>

#include <cmath>
#include <cstdio>

namespace {

using namespace floe;

// Largest difference to the direct sum at a few points, relative to the largest value there
double error_of(const std::vector<Complex>& charges, const std::vector<Complex>& result, Index nx,
                Index ny) {
  double worst = 0.0, largest = 0.0;
  for (int sample = 0; sample < 5; ++sample) {
    const Index i = (sample * 7919 + 13) % nx, j = (sample * 104729 + 5) % ny;
    Complex sum = 0.0;
    for (Index l = 0; l < ny; ++l)
      for (Index k = 0; k < nx; ++k)
        sum += charges[k + nx * l] / (std::hypot(double(i - k), double(j - l)) + 1.0);
    worst = std::max(worst, std::abs(sum - result[i + nx * j]));
    largest = std::max(largest, std::abs(sum));
  }
  return worst / largest;
}

void compare(const char* name, Index nx, Index ny) {
  auto grid = std::make_shared<fmm::PaddedGrid>(nx, ny);
  fmm::EvenSpectrum spectrum(*grid, [](Index i, Index j) {
    return Complex(1.0 / (std::hypot(double(i), double(j)) + 1.0), 0.0);
  });
  const fmm::GridConvolution convolution(grid, std::move(spectrum));
  const benchmark::F1 estimated(nx, ny, FFTW_ESTIMATE), measured(nx, ny, FFTW_MEASURE);
  std::vector<Complex> charges(static_cast<std::size_t>(nx * ny)), data;
  for (std::size_t i = 0; i < charges.size(); ++i)
    charges[i] = {std::sin(1.0 + i), std::cos(2.0 * i)};

  std::vector<double> f1, f1_estimate, ours;
  fmm::PaddedGrid::Workspace workspace;
  for (int repeat = 0; repeat < 11; ++repeat) {
    data = charges;
    f1.push_back(measured.seconds());
    f1_estimate.push_back(estimated.seconds());
    ours.push_back(benchmark::seconds_of([&] { convolution.apply(data.data(), &workspace); }));
  }
  const double anchor = benchmark::median(f1), time = benchmark::median(ours);
  std::printf(
      "%-22s %5td x %4td padded %5td x %4td threads %d F1 %.2f ms (estimate %.2f) "
      "ours %.2f ms ratio %.2f error %.1e\n",
      name, nx, ny, grid->padded_nx(), grid->padded_ny(), omp_get_max_threads(), 1e3 * anchor,
      1e3 * benchmark::median(f1_estimate), 1e3 * time, time / anchor,
      error_of(charges, data, nx, ny));
}

}  // namespace

int main() {
  omp_set_num_threads(1);
  compare("N = 285k, h = E", 691, 139);
  compare("N = 285k, h = E/2", 1381, 277);
  compare("N = 1M, h = E", 1293, 259);
  compare("N = 1M, h = E/2", 2585, 517);
}
