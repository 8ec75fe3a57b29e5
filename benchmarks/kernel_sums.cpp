// Kernel sums on the nodes of a rectangle of Q8 elements, L/B = 5, with the water's Green function:
//   bench_kernel_sums [elements along the length] [tolerance] [kL] [kh; inf: deep] [leaf size]
//   [columns]
// One line a run: times are CPU time, medians, and ratios to F1, FFTW's zero-padded complex
// convolution on the grid of element corners, timed in turn with the sums.
#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/multipole_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/green/green_table.hpp>

#include <fftw3.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

namespace floe {
namespace {

double cpu_seconds() {
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

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

int fast_length(int least) {
  for (int length = least;; ++length) {
    int rest = length;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

// F1: forward, times a full spectrum, inverse, in place
class Convolution {
 public:
  Convolution(int nx, int ny) : size_(nx * ny), data_(fftw_alloc_complex(size_)) {
    forward_ = fftw_plan_dft_2d(ny, nx, data_, data_, FFTW_FORWARD, FFTW_MEASURE);
    backward_ = fftw_plan_dft_2d(ny, nx, data_, data_, FFTW_BACKWARD, FFTW_MEASURE);
    spectrum_.assign(size_, Complex(0.5, 0.25));
    std::fill_n(reinterpret_cast<double*>(data_), 2 * size_, 0.0);
    data_[1][0] = 1.0;
  }
  Convolution(const Convolution&) = delete;
  Convolution& operator=(const Convolution&) = delete;
  ~Convolution() {
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
    fftw_free(data_);
  }

  void run() const {
    fftw_execute(forward_);
    const double norm = 1.0 / size_;
    for (int i = 0; i < size_; ++i) {
      const double re = data_[i][0], im = data_[i][1];
      data_[i][0] = norm * (re * spectrum_[i].real() - im * spectrum_[i].imag());
      data_[i][1] = norm * (re * spectrum_[i].imag() + im * spectrum_[i].real());
    }
    fftw_execute(backward_);
  }

 private:
  int size_;
  fftw_complex* data_;
  fftw_plan forward_, backward_;
  std::vector<Complex> spectrum_;
};

// Corners and middles of the edges of nx × ny square elements of size 1
Points2 q8_nodes(int nx, int ny) {
  Points2 points(2, (nx + 1) * (ny + 1) + nx * (ny + 1) + (nx + 1) * ny);
  Index count = 0;
  for (int j = 0; j <= 2 * ny; ++j)
    for (int i = 0; i <= 2 * nx; ++i)
      if (i % 2 == 0 || j % 2 == 0) points.col(count++) = Point2(0.5 * i, 0.5 * j);
  return points;
}

MatXcd random_charges(Index count, Index columns) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  return MatXcd::NullaryExpr(count, columns,
                             [&] { return Complex(normal(random), normal(random)); });
}

}  // namespace
}  // namespace floe

int main(int argc, char** argv) {
  using namespace floe;
  const auto argument = [&](int i, double otherwise) {
    return argc > i ? std::strtod(argv[i], nullptr) : otherwise;
  };
  const int nx = static_cast<int>(argument(1, 690)), ny = nx / 5;
  const double tolerance = argument(2, 1e-4), kL = argument(3, 150.0), kh = argument(4, INFINITY);
  const auto leaf_size = static_cast<Index>(argument(5, fmm::MultipoleOptions{}.leaf_size));
  const auto columns = static_cast<Index>(argument(6, 1.0));

  const Points2 points = q8_nodes(nx, ny);
  const double k = kL / nx, depth = kh / k, nu = std::isinf(kh) ? k : k * std::tanh(kh);
  std::shared_ptr<const fmm::MultipolePlan> plan;
  const double plan_seconds = seconds_of([&] {
    plan = std::make_shared<fmm::MultipolePlan>(points, points,
                                                fmm::MultipoleOptions{.leaf_size = leaf_size});
  });
  const green::GreenTable kernel(green::GreenFunction(nu, depth), plan->reach());
  std::unique_ptr<fmm::MultipoleSum> sum;
  const double setup_seconds =
      seconds_of([&] { sum = std::make_unique<fmm::MultipoleSum>(plan, kernel, tolerance); });

  const MatXcd charges = random_charges(points.cols(), columns);
  MatXcd potentials(points.cols(), columns);
  const Convolution convolution(fast_length(2 * nx + 1), fast_length(2 * ny + 1));
  std::vector<double> anchor, far, whole;
  for (int round = 0; round < 9; ++round) {
    anchor.push_back(seconds_of([&] { convolution.run(); }));
    far.push_back(seconds_of([&] { sum->far_apply(charges, potentials); }));
    whole.push_back(seconds_of([&] { sum->apply(charges, potentials); }));
  }
  const fmm::DirectSum truth(points, points, kernel);
  const double error = fmm::sampled_error(truth, charges, potentials, 100);
  MatXcd smooth(points.cols(), columns);
  for (Index j = 0; j < columns; ++j)
    smooth.col(j) = (Complex(0.0, k) * points.row(0).transpose()).array().exp();
  sum->apply(smooth, potentials);
  const double smooth_error = fmm::sampled_error(truth, smooth, potentials, 100);

  const double f1 = median(anchor), time = median(whole),
               columns_done = static_cast<double>(columns);
  std::printf(
      "multipole N=%ld threads=%d columns=%ld kL=%g kh=%g tolerance=%.1e error=%.2e "
      "smooth_error=%.2e "
      "seconds=%.4f far=%.4f f1=%.4f ratio=%.2f far_ratio=%.2f plan=%.3f setup=%.3f "
      "setup_in_applications=%.1f bytes_a_node=%.0f plan_bytes_a_node=%.0f ranks=",
      static_cast<long>(points.cols()), omp_get_max_threads(), static_cast<long>(columns), kL, kh,
      tolerance, error, smooth_error, time / columns_done, median(far) / columns_done, f1,
      time / columns_done / f1, median(far) / columns_done / f1, plan_seconds, setup_seconds,
      setup_seconds / time, sum->memory() / static_cast<double>(points.cols()),
      plan->memory() / static_cast<double>(points.cols()));
  for (const Index rank : sum->ranks()) std::printf("%ld ", static_cast<long>(rank));
  std::printf("\n");
}
