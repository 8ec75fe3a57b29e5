#include <floe/numeric/error.hpp>
#include <floe/wave/sea_state.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace floe::wave {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Independent of Spectrum::variance: the rule of trapezoids on a fine grid
double trapezoids(const Spectrum& spectrum, double from, double to, int count) {
  double sum = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double weight = i == 0 || i == count ? 0.5 : 1.0;
    sum += weight * spectrum(from + (to - from) * i / count);
  }
  return sum * (to - from) / count;
}

TEST(BretschneiderMitsuyasu, HasTheValuesOfTheReferenceTable) {
  // S_wave of table1_spectra_points.csv, H1/3 = 2 m, T1/3 = 6.3 s
  const Spectrum spectrum = Spectrum::bretschneider(2.0, 6.3);
  EXPECT_NEAR(spectrum(0.40), 5.12018432e-16, 1e-8 * 5.12e-16);
  EXPECT_NEAR(spectrum(0.46), 6.44503939e-09, 1e-8 * 6.45e-09);
}

TEST(BretschneiderMitsuyasu, HasTheHeightThatItIsNamedBy) {
  const Spectrum spectrum = Spectrum::bretschneider(2.0, 6.3);
  EXPECT_NEAR(4.0 * std::sqrt(spectrum.m0()), 0.9990 * 2.0, 1e-4 * 2.0);
  EXPECT_NEAR(trapezoids(spectrum, 0.0, 40.0, 40000), spectrum.m0(), 1e-6 * spectrum.m0());
}

TEST(Jonswap, HasTheHeightThatItIsNamedByForEveryPeakedness) {
  for (const double gamma : {1.0, 3.3, 7.0}) {
    const Spectrum spectrum = Spectrum::jonswap(3.0, 9.0, gamma);
    EXPECT_NEAR(4.0 * std::sqrt(trapezoids(spectrum, 0.0, 40.0, 80000)), 3.0, 2e-6) << gamma;
  }
}

TEST(Jonswap, PeaksAtItsPeriodAndIsPiersonMoskowitzWithoutEnhancement) {
  const double peak = 2.0 * std::numbers::pi / 9.0;
  const Spectrum sharp = Spectrum::jonswap(3.0, 9.0, 3.3);
  EXPECT_GT(sharp(peak), sharp(0.99 * peak));
  EXPECT_GT(sharp(peak), sharp(1.01 * peak));
  const Spectrum plain = Spectrum::jonswap(3.0, 9.0, 1.0);
  const Spectrum moskowitz = Spectrum::pierson_moskowitz(3.0, 9.0);
  // 5/16 Hs² ωp⁴ ω⁻⁵ exp(-5/4 (ωp/ω)⁴)
  const double omega = 0.9;
  const double expected = 5.0 / 16.0 * 9.0 * std::pow(peak, 4) * std::pow(omega, -5) *
                          std::exp(-1.25 * std::pow(peak / omega, 4));
  EXPECT_NEAR(plain(omega), expected, 1e-8 * expected);
  EXPECT_EQ(moskowitz(omega), plain(omega));
}

TEST(Spectrum, SharesItsVarianceBetweenBands) {
  for (const Spectrum& spectrum :
       {Spectrum::bretschneider(2.0, 6.3), Spectrum::jonswap(2.0, 8.0, 3.3),
        Spectrum::tabulated({0.2, 0.5, 1.5}, {0.0, 2.0, 0.0})}) {
    const double parts = spectrum.variance(0.0, 0.7) + spectrum.variance(0.7, 1.9) +
                         spectrum.variance(1.9, kInfinity);
    EXPECT_NEAR(parts, spectrum.m0(), 1e-7 * spectrum.m0());
  }
}

TEST(Spectrum, OfATableIsLinearBetweenItsValues) {
  const Spectrum spectrum = Spectrum::tabulated({0.5, 1.0, 2.0}, {1.0, 3.0, 0.0});
  EXPECT_DOUBLE_EQ(spectrum(0.75), 2.0);
  EXPECT_DOUBLE_EQ(spectrum(0.5), 1.0);
  EXPECT_EQ(spectrum(0.4), 0.0);
  EXPECT_EQ(spectrum(2.1), 0.0);
  EXPECT_DOUBLE_EQ(spectrum.m0(), 1.0 + 1.5);
}

TEST(Spectrum, RefusesWhatIsNoSea) {
  EXPECT_THROW(Spectrum::bretschneider(-2.0, 6.3), InputError);
  EXPECT_THROW(Spectrum::jonswap(2.0, 6.3, 0.5), InputError);
  EXPECT_THROW(Spectrum::tabulated({1.0, 0.5}, {1.0, 1.0}), InputError);
  EXPECT_THROW(Spectrum::tabulated({0.5, 1.0}, {0.0, 0.0}), InputError);
}

TEST(Spreading, IntegratesToOne) {
  for (const Spreading& spreading :
       {Spreading::cosine_power(2.0), Spreading::cosine_power(6.5),
        Spreading::half_angle_cosine(10.0), Spreading::wrapped_normal(0.3),
        Spreading::wrapped_normal(3.0)}) {
    double sum = 0.0;
    const int count = 3600;
    for (int i = 0; i < count; ++i) sum += spreading(2.0 * std::numbers::pi * i / count);
    EXPECT_NEAR(sum * 2.0 * std::numbers::pi / count, 1.0, 1e-8);
  }
}

TEST(Spreading, OfThePaperIsTheSquaredCosine) {
  const Spreading spreading = Spreading::cosine_power(2.0);
  EXPECT_NEAR(spreading(0.3), 2.0 / std::numbers::pi * std::pow(std::cos(0.3), 2), 1e-15);
  EXPECT_EQ(spreading(2.0), 0.0);
  EXPECT_NEAR(spreading(2.0 * std::numbers::pi - 0.3), spreading(0.3), 1e-15);
}

}  // namespace
}  // namespace floe::wave
