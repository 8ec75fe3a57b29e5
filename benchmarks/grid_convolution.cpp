// GridConvolution against F1 (SPEED: the anchor), alternating, medians of CPU time on one thread.

#include "f1.hpp"
#include "figures.hpp"

#include <floe/fmm/grid_convolution.hpp>

#include <omp.h>

#include <cmath>
#include <string>

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

bench::Figures compare(Index nx, Index ny) {
  auto grid = std::make_shared<fmm::PaddedGrid>(nx, ny);
  fmm::EvenSpectrum spectrum(*grid, [](Index i, Index j) {
    return Complex(1.0 / (std::hypot(double(i), double(j)) + 1.0), 0.0);
  });
  const fmm::GridConvolution convolution(grid, std::move(spectrum));
  const bench::F1 estimated(nx, ny, FFTW_ESTIMATE), measured(nx, ny, FFTW_MEASURE);
  std::vector<Complex> charges(static_cast<std::size_t>(nx * ny)), data;
  for (std::size_t i = 0; i < charges.size(); ++i)
    charges[i] = {std::sin(1.0 + i), std::cos(2.0 * i)};

  std::vector<double> f1, f1_estimate, ours;
  fmm::PaddedGrid::Workspace workspace;
  for (int repeat = 0; repeat < 11; ++repeat) {
    data = charges;
    f1.push_back(measured.seconds());
    f1_estimate.push_back(estimated.seconds());
    ours.push_back(bench::seconds_of([&] { convolution.apply(data.data(), &workspace); }));
  }
  const double anchor = bench::median(f1), time = bench::median(ours);
  return {.nodes = static_cast<double>(nx * ny),
          .seconds = time,
          .anchor = anchor,
          .error = error_of(charges, data, nx, ny),
          .bytes = 16.0 * static_cast<double>(grid->padded_nx() * grid->padded_ny()),
          .more = {{"anchor_estimate_s", bench::median(f1_estimate)}}};
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  for (const Index nx : {691, 1381, 1293, 2585})
    bench::add_measurement("grid_convolution/nx=" + std::to_string(nx),
                           [=] { return compare(nx, nx / 5 + 1); });
  return bench::run_measurements(argc, argv);
}
