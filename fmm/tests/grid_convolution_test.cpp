#include <floe/fmm/grid_convolution.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <random>

namespace floe::fmm {
namespace {

using Centre = EvenSpectrum::Centre;

// Rounding of an FFT of size n grows like ε·log n: 1e-13 leaves a factor of fifty
constexpr double kRounding = 1e-13;

Complex kernel(double x, double y) {
  const double r = std::hypot(x, 1.7 * y) + 0.3;
  return Complex(std::cos(0.4 * r), std::sin(0.4 * r)) / r;
}

std::vector<Complex> random_data(Index count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Complex> data(static_cast<std::size_t>(count));
  for (Complex& value : data) value = {uniform(engine), uniform(engine)};
  return data;
}

struct Lattice {
  Index nx, ny;
  bool half_x, half_y;
  std::vector<Complex> data;
};

// Adds the direct sum of one lattice to another
void add_direct(const Lattice& from, Lattice& to) {
  for (Index j = 0; j < to.ny; ++j)
    for (Index i = 0; i < to.nx; ++i)
      for (Index l = 0; l < from.ny; ++l)
        for (Index k = 0; k < from.nx; ++k)
          to.data[i + to.nx * j] += kernel(i - k + 0.5 * (to.half_x - from.half_x),
                                           j - l + 0.5 * (to.half_y - from.half_y)) *
                                    from.data[k + from.nx * l];
}

double relative_error(const std::vector<Complex>& actual, const std::vector<Complex>& expected) {
  double difference = 0.0, norm = 0.0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    difference += std::norm(actual[i] - expected[i]);
    norm += std::norm(expected[i]);
  }
  return std::sqrt(difference / norm);
}

GridConvolution integer_convolution(Index nx, Index ny) {
  auto grid = std::make_shared<PaddedGrid>(nx, ny);
  EvenSpectrum spectrum(*grid, [](Index i, Index j) { return kernel(i, j); });
  return {std::move(grid), std::move(spectrum)};
}

TEST(FastFftLength, IsEvenWithSmallFactors) {
  EXPECT_EQ(fast_fft_length(1), 2);
  EXPECT_EQ(fast_fft_length(11), 12);
  EXPECT_EQ(fast_fft_length(13), 14);
  EXPECT_EQ(fast_fft_length(49), 50);
  EXPECT_EQ(fast_fft_length(97), 100);
  EXPECT_EQ(fast_fft_length(2 * 691), 1400);
}

TEST(GridConvolution, EqualsTheDirectSum) {
  for (const auto& [nx, ny] : {std::pair<Index, Index>{1, 1}, {7, 1}, {1, 6}, {23, 9}, {40, 17}}) {
    Lattice in{nx, ny, false, false, random_data(nx * ny, 1)};
    Lattice out{nx, ny, false, false, std::vector<Complex>(in.data.size())};
    add_direct(in, out);
    integer_convolution(nx, ny).apply(in.data.data());
    EXPECT_LE(relative_error(in.data, out.data), kRounding) << nx << " x " << ny;
  }
}

TEST(GridConvolution, IsItsOwnTranspose) {
  const Index nx = 33, ny = 14;
  const GridConvolution convolution = integer_convolution(nx, ny);
  const std::vector<Complex> x = random_data(nx * ny, 2), y = random_data(nx * ny, 3);
  std::vector<Complex> kx = x, ky = y;
  convolution.apply(kx.data());
  convolution.apply(ky.data());
  Complex ykx = 0.0, xky = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    ykx += y[i] * kx[i];
    xky += x[i] * ky[i];
  }
  EXPECT_LE(std::abs(ykx - xky), kRounding * std::abs(ykx));
}

TEST(PaddedGrid, CouplesLatticesShiftedByHalfSteps) {
  // The three lattices of nodes of a Q8 mesh
  const Index nx = 13, ny = 6;
  std::vector<Lattice> lattices = {{nx + 1, ny + 1, false, false, {}},
                                   {nx, ny + 1, true, false, {}},
                                   {nx + 1, ny, false, true, {}}};
  std::vector<Lattice> expected;
  const PaddedGrid grid(nx + 1, ny + 1);
  std::vector<InputLattice> inputs;
  std::vector<OutputLattice> outputs;
  for (Lattice& lattice : lattices) {
    lattice.data = random_data(lattice.nx * lattice.ny, 4);
    inputs.push_back({lattice.data.data(), lattice.nx, lattice.ny, lattice.half_x, lattice.half_y});
    outputs.push_back(
        {lattice.data.data(), lattice.nx, lattice.ny, lattice.half_x, lattice.half_y});
    expected.push_back(lattice);
    std::fill(expected.back().data.begin(), expected.back().data.end(), Complex(0.0, 0.0));
  }
  std::vector<EvenSpectrum> tables;
  for (const Lattice& to : lattices)
    for (const Lattice& from : lattices) {
      const bool x = to.half_x != from.half_x, y = to.half_y != from.half_y;
      tables.emplace_back(
          grid, [&](Index i, Index j) { return kernel(i + 0.5 * x, j + 0.5 * y); },
          x ? Centre::half : Centre::integer, y ? Centre::half : Centre::integer);
    }
  for (Lattice& to : expected)
    for (const Lattice& from : lattices) add_direct(from, to);

  std::vector<const EvenSpectrum*> kernels;
  for (const EvenSpectrum& table : tables) kernels.push_back(&table);
  PaddedGrid::Workspace workspace;
  grid.convolve(inputs, outputs, kernels, &workspace);
  for (std::size_t k = 0; k < lattices.size(); ++k)
    EXPECT_LE(relative_error(lattices[k].data, expected[k].data), kRounding) << "lattice " << k;
}

TEST(PaddedGrid, MultipliesPlaneWavesByASymbol) {
  // A symbol of cosines is a convolution with few entries: 2 + cos, i.e. 2 here, 1/2 next door
  const Index nx = 9, ny = 5;
  auto grid = std::make_shared<PaddedGrid>(nx, ny);
  const double step_x = 2.0 * M_PI / static_cast<double>(grid->padded_nx());
  EvenSpectrum spectrum = EvenSpectrum::from_symbol(
      *grid, [&](Index m, Index) { return 2.0 + std::cos(step_x * static_cast<double>(m)); });
  const std::vector<Complex> data = random_data(nx * ny, 5);
  std::vector<Complex> result = data, expected(data.size());
  GridConvolution(grid, std::move(spectrum)).apply(result.data());
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i)
      expected[i + nx * j] = 2.0 * data[i + nx * j] +
                             0.5 * (i > 0 ? data[i - 1 + nx * j] : Complex(0.0)) +
                             0.5 * (i + 1 < nx ? data[i + 1 + nx * j] : Complex(0.0));
  EXPECT_LE(relative_error(result, expected), kRounding);
}

TEST(PaddedGrid, GivesTheSameBitsForAnyNumberOfThreads) {
  const Index nx = 61, ny = 29;
  const GridConvolution convolution = integer_convolution(nx, ny);
  const std::vector<Complex> data = random_data(nx * ny, 6);
  const int before = omp_get_max_threads();
  std::vector<Complex> first;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    std::vector<Complex> result = data;
    convolution.apply(result.data());
    if (first.empty()) first = result;
    EXPECT_TRUE(result == first) << threads << " threads";
  }
  omp_set_num_threads(before);
}

TEST(PaddedGrid, RejectsAnEmptyGrid) { EXPECT_THROW(PaddedGrid(0, 3), InputError); }

}  // namespace
}  // namespace floe::fmm
