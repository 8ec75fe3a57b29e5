// The spectral stage with synthetic modes and modal amplitudes.
//   bench_pem                 T12, N = 1621: one wave by pseudo-excitation against two zgemm of 3N
//   bench_pem stage N Q F D   the whole stage: N nodes, Q modes, F frequencies, D directions, four
//                             mean headings; time and memory over the stored modes
#include <floe/numeric/memory.hpp>
#include <floe/sea_statistics.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

extern "C" void zgemm_(const char*, const char*, const int*, const int*, const int*,
                       const std::complex<double>*, const std::complex<double>*, const int*,
                       const std::complex<double>*, const int*, const std::complex<double>*,
                       std::complex<double>*, const int*);

namespace floe {
namespace {

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

void one_wave() {
  constexpr Index kNodes = 1621, kModes = 60, kHeadings = 180;
  const MatXd shape = random_real(3 * kNodes, kModes, 3);
  const VecXcd amplitudes = random_complex(kModes, 1, 4);
  MatXd parts(kModes, 2);  // real products: the modes are real
  parts << amplitudes.real(), amplitudes.imag();
  // All headings of a frequency share one small matrix (E.9); here each is the wave above
  const MatXcd waves = amplitudes.replicate(1, kHeadings) / std::sqrt(double{kHeadings});
  std::vector<double> autos, matrices;
  VecXd spectrum;
  MatXcd matrix = MatXcd::Zero(3 * kNodes, 3 * kNodes);  // its lower half; it is Hermitian
  for (int repeat = 0; repeat < 9; ++repeat) {
    autos.push_back(seconds([&] {
                      const MatXcd covariance = waves.conjugate() * waves.transpose();
                      spectrum = response::standard_deviation(shape, covariance).cwiseAbs2();
                    }) /
                    static_cast<double>(kHeadings));
    matrices.push_back(seconds([&] {
      const MatXd pair = shape * parts;
      const VecXcd pseudo = pair.col(0).cast<Complex>() + Complex(0.0, 1.0) * pair.col(1);
#pragma omp parallel for schedule(static, 16)
      for (Index j = 0; j < matrix.cols(); ++j)
        matrix.col(j).tail(matrix.rows() - j) =
            pseudo.tail(matrix.rows() - j).conjugate() * pseudo[j];
    }));
  }
  const double error = (matrix.diagonal().real() - spectrum).norm() / spectrum.norm();
  std::nth_element(autos.begin(), autos.begin() + 4, autos.end());
  std::nth_element(matrices.begin(), matrices.begin() + 4, matrices.end());
  const double anchor = product_seconds(3 * kNodes);
  std::printf(
      "T12 nodes %ld modes %ld: auto-spectra %.3g s a wave of 180, full matrix %.3g s, two zgemm "
      "%.3g s: "
      "ratios %.2g and %.2g, difference %.1g\n",
      long{kNodes}, long{kModes}, autos[4], matrices[4], anchor, autos[4] / anchor,
      matrices[4] / anchor, error);
}

void whole_stage(Index nodes, Index modes, int frequencies, int directions) {
  SeaObservation observation;
  observation.quantity = {0};
  observation.derivative = {0};
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
  std::printf(
      "stage nodes %ld modes %ld frequencies %d directions %d mean headings 4: %.3g s, %.0f MB "
      "over the stored modes, difference to a direct sum %.1g\n",
      nodes, modes, frequencies, directions, time, (numeric::peak_memory() - stored) / 1e6,
      (own - variance).norm() / variance.norm());
}

}  // namespace
}  // namespace floe

int main(int argc, char** argv) {
  if (argc == 6 && std::string(argv[1]) == "stage")
    floe::whole_stage(std::atol(argv[2]), std::atol(argv[3]), std::atoi(argv[4]),
                      std::atoi(argv[5]));
  else
    floe::one_wave();
}
