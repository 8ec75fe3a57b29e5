#include <floe/numeric/error.hpp>
#include <floe/response/design_values.hpp>
#include <floe/response/pseudo_excitation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace floe::response {
namespace {

constexpr double kPi = std::numbers::pi;

MatXcd random_complex(Index rows, Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return MatXcd::NullaryExpr(rows, columns,
                             [&] { return Complex(normal(generator), normal(generator)); });
}

// The conventional method, paper (29a): all of S_xx, then H* S_xx Hᵀ
MatXcd conventional_product(const MatXcd& transfer, const MatXcd& wave,
                            const std::vector<double>& weight, double density) {
  MatXcd waves = MatXcd::Zero(wave.rows(), wave.rows());
  for (Index b = 0; b < wave.cols(); ++b)
    waves += density * weight[static_cast<std::size_t>(b)] * wave.col(b).conjugate() *
             wave.col(b).transpose();
  return transfer.conjugate() * waves * transfer.transpose();
}

TEST(twin_PseudoExcitation, EqualsTheConventionalProductForEveryPairOfPoints) {
  // 40 wave points drive 12 modes that are seen at 9 points, in a sea of 24 headings
  const MatXd shape = random_complex(9, 12, 1).real();
  const MatXcd modal_transfer = random_complex(12, 40, 2), wave = random_complex(40, 24, 3);
  std::vector<double> weight;
  for (int b = 0; b < 24; ++b) weight.push_back(0.01 + 0.002 * b);
  const double density = 0.7;
  const MatXcd expected =
      conventional_product(shape.cast<Complex>() * modal_transfer, wave, weight, density);

  PseudoExcitation response(shape);
  response.add(0.8, 1.0, pseudo_amplitudes(modal_transfer * wave, density, weight));
  for (Index a = 0; a < 9; ++a)
    for (Index b = 0; b < 9; ++b)
      EXPECT_LT(std::abs(response.cross_covariance(a, b) - expected(a, b)),
                1e-10 * expected.cwiseAbs().maxCoeff());
  EXPECT_LT((response.spectra().col(0) - expected.diagonal().real()).norm(),
            1e-10 * expected.norm());
}

TEST(identity_PseudoExcitation, OneFrequencyAndOneHeadingGiveTheSquaredRao) {
  const MatXd shape = random_complex(5, 4, 1).real();
  const MatXcd amplitudes = random_complex(4, 1, 2);
  PseudoExcitation response(shape);
  response.add(0.6, 0.1, pseudo_amplitudes(amplitudes, 1.0, {1.0}));
  const VecXd squared = (shape.cast<Complex>() * amplitudes).cwiseAbs2();
  EXPECT_LT((response.spectra().col(0) - squared).norm(), 1e-14 * squared.norm());
  EXPECT_LT((response.moment(2) - 0.1 * 0.36 * squared).norm(), 1e-14 * squared.norm());
}

TEST(identity_PseudoExcitation, NodewiseDeviationIsTheRootOfTheIntegratedSpectrum) {
  const MatXd shape = random_complex(5000, 6, 1).real();
  PseudoExcitation response(shape);
  const std::vector<double> omega = {0.4, 0.5, 0.8, 1.0};
  const std::vector<double> weight = trapezoid_weights(omega);
  for (std::size_t i = 0; i < omega.size(); ++i)
    response.add(omega[i], weight[i],
                 pseudo_amplitudes(random_complex(6, 3, 7), 0.5, {0.2, 0.5, 0.3}));
  const VecXd deviation = standard_deviation(shape, response.modal_covariance(0));
  EXPECT_LT((deviation - response.moment(0).cwiseSqrt()).norm(), 1e-12 * deviation.norm());
}

TEST(PseudoExcitation, RefusesFrequenciesThatDoNotAscendAndAmplitudesThatAreNotFinite) {
  PseudoExcitation response(MatXd::Ones(1, 1));
  response.add(0.5, 1.0, MatXcd::Ones(1, 1));
  EXPECT_THROW(response.add(0.5, 1.0, MatXcd::Ones(1, 1)), InputError);
  EXPECT_THROW(response.add(0.6, 1.0, MatXcd::Constant(1, 1, std::nan(""))), InputError);
}

TEST(DirectionGrid, CarriesAllEnergyWhateverTheSpreading) {
  for (const wave::Spreading& spreading :
       {wave::Spreading::cosine_power(2.0), wave::Spreading::cosine_power(20.0),
        wave::Spreading::half_angle_cosine(5.0), wave::Spreading::wrapped_normal(0.05)}) {
    const DirectionGrid grid = direction_grid(spreading, 0.3, 36);
    double sum = 0.0;
    for (const double weight : grid.weight) sum += weight;
    EXPECT_NEAR(sum, 1.0, 1e-6);
  }
}

TEST(DirectionGrid, OfLongCrestsIsTheMeanHeading) {
  const DirectionGrid grid = direction_grid(wave::Spreading::none(), 0.3, 360);
  EXPECT_EQ(grid.heading, std::vector<double>{0.3});
  EXPECT_EQ(grid.weight, std::vector<double>{1.0});
}

TEST(DirectionGrid, IntegratesTheHarmonicsOfTheSquaredCosineExactly) {
  // ∫ D cos(mθ) dθ is 1/2 for m = 2 and 0 for every even m above
  const DirectionGrid grid = direction_grid(wave::Spreading::cosine_power(2.0), 0.0, 360);
  for (const int m : {2, 4, 10}) {
    double sum = 0.0;
    for (std::size_t b = 0; b < grid.heading.size(); ++b)
      sum += grid.weight[b] * std::cos(m * grid.heading[b]);
    EXPECT_NEAR(sum, m == 2 ? 0.5 : 0.0, 1e-12) << m;
  }
}

TEST(TrapezoidWeights, AreHalfTheStepsOnBothSides) {
  EXPECT_EQ(trapezoid_weights({1.0, 1.5, 2.5}), (std::vector<double>{0.25, 0.75, 0.5}));
  EXPECT_THROW(trapezoid_weights({1.0, 1.0}), InputError);
}

TEST(DesignValues, OfARayleighResponse) {
  // m0 = 4, a period of 8 s, three hours: 1350 crossings
  const double m2 = 4.0 * std::pow(2.0 * kPi / 8.0, 2);
  const DesignValues values = design_values(4.0, m2, 10800.0);
  EXPECT_NEAR(values.zero_crossing_period, 8.0, 1e-12);
  EXPECT_DOUBLE_EQ(values.significant, 4.0);
  EXPECT_NEAR(exceedance(values.most_probable_maximum, 4.0), 1.0 / 1350.0, 1e-12);
  EXPECT_THROW(design_values(-1.0, 1.0, 1.0), InputError);
}

}  // namespace
}  // namespace floe::response
