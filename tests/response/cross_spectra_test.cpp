#include <floe/numeric/error.hpp>
#include <floe/response/cross_spectra.hpp>
#include <floe/response/design_values.hpp>
#include <floe/response/pseudo_excitation.hpp>

#include <Eigen/LU>
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

TEST(twin_CrossSpectra, EqualTheProductOfAllPairsAndTheCovarianceOfTheModes) {
  const MatXd rows = random_complex(4, 6, 1).real();
  CrossSpectra cross(rows);
  PseudoExcitation pseudo_excitation(rows);
  const std::vector<double> omega = {0.5, 0.7, 1.2}, weight = trapezoid_weights(omega);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const MatXcd pseudo = random_complex(6, 9, 2 + static_cast<unsigned>(i));
    cross.add(pseudo, VecXcd::Ones(4));
    pseudo_excitation.add(omega[i], weight[i], pseudo);
    for (Index a = 0; a < 4; ++a)
      for (Index b = 0; b < 4; ++b) {
        Complex sum = 0.0;
        for (Index w = 0; w < 9; ++w)
          sum += std::conj((rows.row(a) * pseudo.col(w))(0)) * (rows.row(b) * pseudo.col(w))(0);
        EXPECT_LT(std::abs(cross.spectra()[i](a, b) - sum), 1e-12 * std::abs(sum) + 1e-12);
      }
  }
  const GaussianVector vector = gaussian_vector(cross.spectra(), omega, weight);
  EXPECT_NEAR(vector.covariance(1, 3), pseudo_excitation.cross_covariance(1, 3).real(), 1e-10);
  EXPECT_LT((vector.with_derivative + vector.with_derivative.transpose()).norm(), 1e-10);
}

TEST(CrossSpectra, FactorsOfTimeTurnThePhase) {
  // The velocity leads the deflection by a quarter of a period: -iω w, S_wv = -iω S_ww
  const MatXd rows = MatXd::Ones(2, 1);
  CrossSpectra cross(rows);
  cross.add(MatXcd::Constant(1, 1, Complex(0.3, 0.4)), VecXcd{{1.0, Complex(0.0, -0.8)}});
  EXPECT_LT(std::abs(cross.spectra()[0](0, 1) - Complex(0.0, -0.8 * 0.25)), 1e-15);
}

// Two or three independent processes of one variance and one variance of the derivative
GaussianVector independent(Index size, double variance, double derivative_variance) {
  return {variance * MatXd::Identity(size, size), MatXd::Zero(size, size),
          derivative_variance * MatXd::Identity(size, size)};
}

TEST(OutcrossingRate, IsRicesRateForOneComponentAndTheClosedFormForTwoAndThree) {
  // The norm of independent components has the derivative's variance, whatever its own value: its
  // rate is its density at the level times E[(ṙ)⁺] = σ̇/√2π
  const double variance = 2.0, derivative = 0.5, level = 4.0;
  const double flow = std::sqrt(derivative / (2.0 * kPi));
  const double exponential = std::exp(-0.5 * level * level / variance);
  const double densities[] = {
      2.0 / std::sqrt(2.0 * kPi * variance) * exponential, level / variance * exponential,
      std::sqrt(2.0 / kPi) * level * level / std::pow(variance, 1.5) * exponential};
  for (Index size = 1; size <= 3; ++size)
    EXPECT_NEAR(outcrossing_rate(independent(size, variance, derivative),
                                 MatXd::Identity(size, size), level),
                flow * densities[size - 1], 1e-10 * flow * densities[size - 1])
        << size;
}

TEST(OutcrossingRate, OfQuantitiesThatMoveAsOneIsThatOfTheirCommonMotion) {
  // b = 3a, the form a² + b²: √10 |a|
  GaussianVector vector;
  const MatXd shape = VecXd{{1.0, 3.0}} * VecXd{{1.0, 3.0}}.transpose();
  vector.covariance = 0.7 * shape;
  vector.with_derivative = MatXd::Zero(2, 2);
  vector.derivative_covariance = 0.4 * shape;
  const double level = 6.0;
  const double expected =
      std::sqrt(0.4 / 0.7) / kPi * std::exp(-0.5 * level * level / (10.0 * 0.7));
  EXPECT_NEAR(outcrossing_rate(vector, MatXd::Identity(2, 2), level), expected, 1e-8 * expected);
}

TEST(OutcrossingRate, DoesNotDependOnTheCoordinates) {
  // A linear map of the vector with the form mapped back
  const std::vector<double> omega = {0.5, 0.8, 1.3}, weight = trapezoid_weights(omega);
  CrossSpectra cross(MatXd::Identity(3, 3));
  for (unsigned i = 0; i < 3; ++i) cross.add(random_complex(3, 2, 5 + i), VecXcd::Ones(3));
  const GaussianVector own = gaussian_vector(cross.spectra(), omega, weight);
  MatXd map(3, 3);
  map << 1.0, 0.4, -0.3, 0.0, 2.0, 0.5, 0.0, 0.0, 30.0;
  const GaussianVector mapped{map * own.covariance * map.transpose(),
                              map * own.with_derivative * map.transpose(),
                              map * own.derivative_covariance * map.transpose()};
  const MatXd back = map.inverse(), form = MatXd::Identity(3, 3);
  const double rate = outcrossing_rate(own, form, 5.0);
  EXPECT_NEAR(outcrossing_rate(mapped, back.transpose() * form * back, 5.0), rate, 1e-8 * rate);
}

// The von Mises form of σx, σy, τ
MatXd von_mises() {
  MatXd form(3, 3);
  form << 1.0, -0.5, 0.0, -0.5, 1.0, 0.0, 0.0, 0.0, 3.0;
  return form;
}

// Waves of random phase and Gaussian amplitude: how often √(yᵀ A y) rises above the level within
// the duration
double count_in_a_sea(const std::vector<double>& omega, const std::vector<MatXcd>& pseudo,
                      const MatXd& form, double level, double duration, std::mt19937& generator) {
  constexpr double kStep = 0.1;  // the stress has peaks every 3 s
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3cd> amplitude;
  std::vector<Complex> turn;
  for (std::size_t i = 0; i < omega.size(); ++i)
    for (Index w = 0; w < pseudo[i].cols(); ++w) {
      amplitude.emplace_back(pseudo[i].col(w) * Complex(normal(generator), normal(generator)));
      turn.push_back(std::polar(1.0, -omega[i] * kStep));
    }
  const Eigen::Matrix3d fixed_form = form;
  int count = 0;
  bool above = true;
  for (double t = 0.0; t < duration; t += kStep) {
    Eigen::Vector3d y = Eigen::Vector3d::Zero();
    for (std::size_t w = 0; w < turn.size(); ++w) {
      y += amplitude[w].real();
      amplitude[w] *= turn[w];
    }
    const bool now = y.dot(fixed_form * y) > level * level;
    if (now && !above) ++count;
    above = now;
  }
  return count;
}

TEST(twin_OutcrossingRate, AgreesWithCountsInSimulatedSeas) {
  // 60 frequencies, not commensurable, of two directions; components correlated and out of phase
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  std::vector<double> omega;
  std::vector<MatXcd> pseudo;
  CrossSpectra cross(MatXd::Identity(3, 3));
  const MatXcd mean = random_complex(3, 2, 9);
  for (int i = 0; i < 60; ++i) {
    omega.push_back(0.6 + 0.012 * (i + jitter(generator)));
    const double envelope = std::exp(-0.5 * std::pow((omega.back() - 0.95) / 0.15, 2));
    pseudo.push_back(envelope * mean + 0.2 * envelope * random_complex(3, 2, 100 + i));
    cross.add(pseudo.back(), VecXcd::Ones(3));
  }
  const std::vector<double> weight(omega.size(), 1.0);
  const GaussianVector vector = gaussian_vector(cross.spectra(), omega, weight);
  const double level = 2.0 * std::sqrt((von_mises() * vector.covariance).trace());
  const double expected = outcrossing_rate(vector, von_mises(), level);

  // Many short seas: one long one of so few waves would have a variance of its own
  constexpr int kSeas = 1000;
  constexpr double kDuration = 150.0;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kSeas; ++i) {
    const double count = count_in_a_sea(omega, pseudo, von_mises(), level, kDuration, generator);
    sum += count;
    squares += count * count;
  }
  const double mean_count = sum / kSeas;
  const double error = std::sqrt((squares / kSeas - mean_count * mean_count) / kSeas);
  ASSERT_LT(error, 0.03 * mean_count);
  EXPECT_NEAR(mean_count, expected * kDuration, 3.0 * error);
}

TEST(MostProbableMaximum, IsExceededOnceInTheDuration) {
  const GaussianVector vector = independent(2, 2.0, 0.5);
  const MatXd form = MatXd::Identity(2, 2);
  const double level = most_probable_maximum(vector, form, 10800.0);
  EXPECT_NEAR(outcrossing_rate(vector, form, level) * 10800.0, 1.0, 1e-6);
  // One component, both signs: twice the crossings of the amplitude's own rule (E.11)
  const double m0 = 2.0, m2 = 0.5;
  const double own = most_probable_maximum(independent(1, m0, m2), MatXd::Ones(1, 1), 10800.0);
  EXPECT_NEAR(own, design_values(m0, m2, 2.0 * 10800.0).most_probable_maximum, 1e-6);
  EXPECT_EQ(most_probable_maximum(independent(2, 0.0, 0.0), form, 10800.0), 0.0);
}

}  // namespace
}  // namespace floe::response
