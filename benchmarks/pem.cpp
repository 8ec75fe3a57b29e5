// The spectral stage with synthetic modes and modal amplitudes: T12, the whole stage with its
// memory over the stored modes, and what Table 2 of the paper compares.
#include "f1.hpp"
#include "figures.hpp"

#include <floe/numeric/blas_threads.hpp>
#include <floe/numeric/memory.hpp>
#include <floe/sea_statistics.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

extern "C" void zgemm_(const char*, const char*, const int*, const int*, const int*,
                       const std::complex<double>*, const std::complex<double>*, const int*,
                       const std::complex<double>*, const int*, const std::complex<double>*,
                       std::complex<double>*, const int*);

extern "C" void zgetrf_(const int*, const int*, std::complex<double>*, const int*, int*, int*);

namespace floe {
namespace {

using bench::Figures;

double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

MatXcd random_complex(Index rows, Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return MatXcd::NullaryExpr(rows, columns,
                             [&] { return Complex(normal(generator), normal(generator)); });
}

MatXd random_real(Index rows, Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return MatXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

// H* S Hᵀ as the paper's (29a) forms it: two products of full matrices
double product_seconds(Index unknowns) {
  const MatXcd transfer = random_complex(unknowns, unknowns, 1);
  const MatXcd spectrum = random_complex(unknowns, unknowns, 2);
  MatXcd half(unknowns, unknowns), response(unknowns, unknowns);
  const int n = static_cast<int>(unknowns);
  const Complex one = 1.0, zero = 0.0;
  return seconds([&] {
    zgemm_("N", "N", &n, &n, &n, &one, transfer.data(), &n, spectrum.data(), &n, &zero, half.data(),
           &n);
    zgemm_("N", "C", &n, &n, &n, &one, half.data(), &n, transfer.data(), &n, &zero, response.data(),
           &n);
  });
}

constexpr Index kHeadings = 180;

// Auto-spectra of all unknowns for one wave. All headings of a frequency share one small matrix
// (E.9); here each is the same wave
double auto_spectra_seconds(const MatXd& shape, const VecXcd& amplitudes, VecXd& spectrum) {
  const MatXcd waves = amplitudes.replicate(1, kHeadings) / std::sqrt(double{kHeadings});
  std::vector<double> times;
  for (int repeat = 0; repeat < 9; ++repeat)
    times.push_back(seconds([&] {
      const MatXcd covariance = waves.conjugate() * waves.transpose();
      spectrum = response::standard_deviation(shape, covariance).cwiseAbs2();
    }));
  return bench::median(times) / static_cast<double>(kHeadings);
}

// y_i* y_j for all i ≥ j: (re, -im) of y_i times re y_j and (im, re) times im y_j
// NOTE: the matrix is only written; past the caches, or every line would be read before
void write_column(const Eigen::Matrix2Xd& conjugate, const Eigen::Matrix2Xd& turned, double real,
                  double imaginary, Index j, MatXcd& matrix) {
  double* out = reinterpret_cast<double*>(&matrix(0, j));
  for (Index i = j; i < matrix.rows(); ++i) {
#ifdef __SSE2__
    const __m128d product =
        _mm_add_pd(_mm_mul_pd(_mm_loadu_pd(&conjugate(0, i)), _mm_set1_pd(real)),
                   _mm_mul_pd(_mm_loadu_pd(&turned(0, i)), _mm_set1_pd(imaginary)));
    _mm_stream_pd(out + 2 * i, product);
#else
    for (Index part = 0; part < 2; ++part)
      out[2 * i + part] = conjugate(part, i) * real + turned(part, i) * imaginary;
#endif
  }
}

// The full matrix of the spectra for one wave, as the paper's (33) forms it; its lower half, it is
// Hermitian. `error` is that of its diagonal against the auto-spectra
double full_matrix_seconds(const MatXd& shape, const VecXcd& amplitudes, const VecXd& spectrum,
                           double& error) {
  const Index unknowns = shape.rows();
  MatXd parts(amplitudes.size(), 2);  // real products: the modes are real
  Eigen::Matrix2Xd conjugate(2, unknowns), turned(2, unknowns);
  parts << amplitudes.real(), amplitudes.imag();
  MatXcd matrix = MatXcd::Zero(unknowns, unknowns);
  std::vector<double> times;
  for (int repeat = 0; repeat < 5; ++repeat)
    times.push_back(seconds([&] {
      const MatXd pair = shape * parts;
      conjugate << pair.col(0).transpose(), -pair.col(1).transpose();
      turned << pair.col(1).transpose(), pair.col(0).transpose();
#pragma omp parallel for schedule(static, 16)
      for (Index j = 0; j < unknowns; ++j)
        write_column(conjugate, turned, pair(j, 0), pair(j, 1), j, matrix);
    }));
  error = (matrix.diagonal().real() - spectrum).norm() / spectrum.norm();
  return bench::median(times);
}

enum class Way { auto_spectra, full_matrix };

// One wave; the anchor is the conventional product where it is small enough to be made
Figures one_wave(Index nodes, Index modes, Way way, bool with_product) {
  const MatXd shape = random_real(3 * nodes, modes, 3);
  const VecXcd amplitudes = random_complex(modes, 1, 4);
  VecXd spectrum;
  const double autos = auto_spectra_seconds(shape, amplitudes, spectrum);
  const VecXd exact = (shape.cast<Complex>() * amplitudes).cwiseAbs2();
  double error = (spectrum - exact).norm() / exact.norm(), time = autos;
  if (way == Way::full_matrix) time = full_matrix_seconds(shape, amplitudes, spectrum, error);
  const double unknowns = 3.0 * static_cast<double>(nodes);
  return {.nodes = static_cast<double>(nodes),
          .seconds = time,
          .anchor = with_product ? product_seconds(3 * nodes) : 0.0,
          .error = error,
          .bytes = way == Way::full_matrix ? 16.0 * unknowns * unknowns : 8.0 * unknowns,
          .more = {{"modes", static_cast<double>(modes)}}};
}

// The conventional way alone: two products of full matrices
Figures conventional(Index nodes) {
  const double unknowns = 3.0 * static_cast<double>(nodes);
  return {.nodes = static_cast<double>(nodes),
          .seconds = product_seconds(3 * nodes),
          .bytes = 4.0 * 16.0 * unknowns * unknowns,
          .more = {}};
}

// LU factors of a dense complex matrix of the fluid's size by LAPACK
Figures factorisation(Index nodes) {
  MatXcd matrix = random_complex(nodes, nodes, 8);
  const int n = static_cast<int>(nodes);
  std::vector<int> pivots(static_cast<std::size_t>(nodes));
  int info = 0;
  const double time = seconds([&] { zgetrf_(&n, &n, matrix.data(), &n, pivots.data(), &info); });
  return {.nodes = static_cast<double>(nodes),
          .seconds = time,
          .error = static_cast<double>(info),
          .bytes = 16.0 * static_cast<double>(nodes * nodes),
          .more = {}};
}

Figures whole_stage(Index nodes, Index modes, int frequencies, int directions) {
  SeaObservation observation;
  observation.quantity = {0};
  observation.derivative = {0};
  observation.phase = {0.0};
  observation.points = random_real(5, modes, 5);
  observation.lines = random_real(61, modes, 6);
  observation.nodes = random_real(nodes, modes, 7);
  std::vector<double> omega;
  for (int i = 0; i < frequencies; ++i) omega.push_back(0.4 + 1.8 * i / (frequencies - 1));
  const wave::SeaState sea{
      .name = "synthetic",
      .description = "",
      .partitions = {{wave::Spectrum::bretschneider(2.0, 6.3), wave::Spreading::cosine_power(2.0)}},
      .mean_heading_deg = {0.0, 30.0, 60.0, 90.0}};
  const MatXd nodes_first = observation.nodes.topRows(100);
  const double stored = numeric::peak_memory();
  std::vector<SeaResult> results;
  MatXcd covariance;
  const double time = seconds([&] {
    SeaStatistics statistics({sea}, std::move(observation), omega, directions);
    for (const double w : omega)
      statistics.add({w, random_complex(modes, directions, static_cast<unsigned>(1e6 * w))});
    results = statistics.results();
  });

  // The same for the first hundred nodes, wave by wave
  const response::DirectionGrid grid =
      response::direction_grid(sea.partitions[0].spreading, 0.0, directions);
  const response::CircleInterpolation at_headings(grid.heading, directions);
  const std::vector<double> weight = response::trapezoid_weights(omega);
  VecXd variance = VecXd::Zero(100);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const MatXcd response =
        nodes_first.cast<Complex>() *
        at_headings(random_complex(modes, directions, static_cast<unsigned>(1e6 * omega[i])));
    for (Index b = 0; b < response.cols(); ++b)
      variance += weight[i] * sea.density(omega[i]) * grid.weight[static_cast<std::size_t>(b)] *
                  response.col(b).cwiseAbs2();
  }
  const VecXd own = results.front().node_moments.col(0).head(100);
  return {.nodes = static_cast<double>(nodes),
          .seconds = time,
          .error = (own - variance).norm() / variance.norm(),
          .bytes = numeric::peak_memory() - stored,
          .more = {{"modes", static_cast<double>(modes)},
                   {"frequencies", static_cast<double>(frequencies)},
                   {"directions", static_cast<double>(directions)}}};
}

}  // namespace
}  // namespace floe

int main(int argc, char** argv) {
  using namespace floe;
  using bench::add_measurement;
  // The stage first: its bytes are the growth of the peak
  const Index large = 284929;
  for (const auto& [frequencies, directions] :
       {std::pair{100, 180}, std::pair{400, 180}, std::pair{100, 720}})
    add_measurement("stage_wall/N=284929/modes=60/frequencies=" + std::to_string(frequencies) +
                        "/directions=" + std::to_string(directions),
                    [=] { return whole_stage(large, 60, frequencies, directions); });
  add_measurement("T12/auto_spectra_wall/N=1621",
                  [] { return one_wave(1621, 60, Way::auto_spectra, true); });
  add_measurement("T12/full_matrix_wall/N=1621",
                  [] { return one_wave(1621, 60, Way::full_matrix, true); });
  // Table 2 of the paper: one wave, 30 modes, one thread
  for (const Index nodes : {1621, 3556, 6241, 8929}) {
    const std::string end = "/N=" + std::to_string(nodes) + (nodes > 4000 ? "/full" : "");
    const auto alone = [](const std::function<Figures()>& measure) {
      return [measure] {
        omp_set_num_threads(1);
        numeric::use_one_blas_thread();
        Figures figures = measure();
        figures.more["table2_threads"] = 1.0;
        return figures;
      };
    };
    add_measurement("table2/factorisation_wall" + end, alone([=] { return factorisation(nodes); }));
    add_measurement("table2/full_matrix_wall" + end,
                    alone([=] { return one_wave(nodes, 30, Way::full_matrix, false); }));
    add_measurement("table2/auto_spectra_wall" + end,
                    alone([=] { return one_wave(nodes, 30, Way::auto_spectra, false); }));
    if (nodes < 4000)
      add_measurement(
          "table2/conventional_wall/N=" + std::to_string(nodes) + (nodes > 2000 ? "/full" : ""),
          alone([=] { return conventional(nodes); }));
  }
  return bench::run_measurements(argc, argv);
}
