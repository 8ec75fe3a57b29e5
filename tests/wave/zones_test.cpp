#include <floe/numeric/error.hpp>
#include <floe/wave/zones.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace floe::wave {
namespace {

Zones two_halves(double c) {
  ZoneBounds left, right;
  left.x_to = 20.0;
  right.x_from = 20.0;
  return {{left, right}, 60.0, uniform_coherence(2, c)};
}

Points2 along_x(int count) {
  Points2 points(2, count);
  for (int i = 0; i < count; ++i) points.col(i) = Point2(-150.0 + 300.0 * i / (count - 1), 3.0);
  return points;
}

TEST(Zones, KeepTheVarianceOfOneSpectrumEverywhere) {
  for (const double c : {0.0, 0.3, 1.0}) {
    const Zones zones = two_halves(c);
    const MatXd g = zone_amplitudes(zones, along_x(301));
    for (Index i = 0; i < g.rows(); ++i)
      EXPECT_NEAR((g.row(i) * zones.coherence * g.row(i).transpose()).value(), 1.0, 1e-14);
    // Inside a zone nothing but its own waves; halfway the same of both
    EXPECT_EQ(g(0, 0), 1.0);
    EXPECT_EQ(g(0, 1), 0.0);
    EXPECT_EQ(g(300, 1), 1.0);
    EXPECT_NEAR(g(170, 0), g(170, 1), 1e-14);
  }
  // Waves that belong together add up to one wave
  EXPECT_LE((zone_amplitudes(two_halves(1.0), along_x(301)).rowwise().sum().array() - 1.0)
                .abs()
                .maxCoeff(),
            1e-14);
}

TEST(Zones, AreSmooth) {
  // Steps of 1 m: of a function with two continuous derivatives over 60 m, second differences stay
  // below max|g''| ≈ 5.8/60² and do not jump by more than max|g'''| = 60/60³
  const MatXd g = zone_amplitudes(two_halves(1.0), along_x(301));
  double last = 0.0;
  for (Index i = 1; i + 1 < g.rows(); ++i) {
    const double second = g(i + 1, 0) - 2.0 * g(i, 0) + g(i - 1, 0);
    EXPECT_LE(std::abs(second), 5.8 / 3600.0);
    EXPECT_LE(std::abs(second - last), 60.0 / 216'000.0);
    last = second;
  }
}

TEST(Zones, MustCoverThePlate) {
  Zones zones = two_halves(0.5);
  zones.bounds[1].x_from = 90.0;
  EXPECT_THROW(zone_amplitudes(zones, along_x(301)), InputError);
  zones.bounds[1].x_from = 20.0;
  // A zone may end where the plate ends, a corner included
  zones.bounds[0].x_from = -150.0;
  zones.bounds[0].y_from = 3.0;
  EXPECT_NEAR(zone_amplitudes(zones, along_x(301))(0, 0), 1.0, 1e-14);
  zones.bounds[0].x_from = -120.0;
  EXPECT_THROW(zone_amplitudes(zones, along_x(301)), InputError);
}

TEST(CoherenceFactor, HasAsManyTermsAsItNeeds) {
  for (const double c : {0.0, 0.4, 1.0}) {
    const MatXd coherence = uniform_coherence(3, c);
    const MatXd factor = coherence_factor(coherence);
    EXPECT_EQ(factor.cols(), c == 1.0 ? 1 : 3);
    EXPECT_LE((factor * factor.transpose() - coherence).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(CoherenceFactor, RefusesWhatCannotBe) {
  MatXd coherence = MatXd::Identity(3, 3);
  coherence(0, 1) = 0.5;
  EXPECT_THROW(coherence_factor(coherence), InputError);  // not symmetric
  coherence(1, 0) = 0.5;
  EXPECT_NO_THROW(coherence_factor(coherence));
  // The first is one with the second and with the third, but these know nothing of each other
  coherence(0, 1) = coherence(1, 0) = coherence(0, 2) = coherence(2, 0) = 1.0;
  EXPECT_THROW(coherence_factor(coherence), InputError);
  EXPECT_THROW(coherence_factor(2.0 * MatXd::Identity(2, 2)), InputError);
  EXPECT_THROW(coherence_factor(uniform_coherence(2, -0.5)), InputError);
}

}  // namespace
}  // namespace floe::wave
