#include <floe/numeric/error.hpp>
#include <floe/wave/scatter_diagram.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floe::wave {
namespace {

// ∫ ωʲ S dω by the rule of trapezoids over ln ω, independent of Spectrum::moment
double moment(const Spectrum& spectrum, int order, double peak) {
  const int count = 200'000;
  const double from = std::log(0.1 * peak), to = std::log(1e5 * peak);
  double sum = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double omega = std::exp(from + (to - from) * i / count);
    sum += (i == 0 || i == count ? 0.5 : 1.0) * std::pow(omega, order + 1) * spectrum(omega);
  }
  return sum * (to - from) / count;
}

TEST(SpectrumMoment, IsTheIntegralForEveryOrder) {
  for (const double gamma : {1.0, 3.3}) {
    const double peak = 2.0 * std::numbers::pi / 9.0;
    const Spectrum spectrum = Spectrum::jonswap(3.0, 9.0, gamma);
    // The sum's own error: the kink of σ at the peak, where S has a step in its second derivative
    for (const int order : {-1, 0, 1, 2})
      EXPECT_NEAR(spectrum.moment(order) / moment(spectrum, order, peak), 1.0, 1e-8) << order;
  }
  const Spectrum table = Spectrum::tabulated({0.5, 1.0, 2.0}, {0.0, 2.0, 0.0});
  // ∫ ω S: straight lines 4(ω - ½) and 2(2 - ω)
  EXPECT_NEAR(table.moment(1), 4.0 * (7.0 / 24.0 - 3.0 / 16.0) + 2.0 * (3.0 - 7.0 / 3.0), 1e-12);
}

TEST(PeakPeriod, HasClosedFormsWithoutEnhancement) {
  // Of A ω⁻⁵ exp(-B ω⁻⁴), B = 5/4 ωp⁴: m0 = A/4B, m2 = A √π/(4 √B), m₋₁ = A Γ(5/4)/(4 B^5/4)
  const double zero_crossing = std::pow(1.25 * std::numbers::pi, -0.25);
  const double energy = std::tgamma(1.25) / std::pow(1.25, 0.25);
  EXPECT_NEAR(peak_period(PeriodType::kZeroCrossing, zero_crossing * 9.0, 1.0), 9.0, 1e-8);
  EXPECT_NEAR(peak_period(PeriodType::kEnergy, energy * 9.0, 1.0), 9.0, 1e-8);
  EXPECT_EQ(peak_period(PeriodType::kPeak, 9.0, 1.0), 9.0);
}

TEST(PeakPeriod, AgreesWithTheUsualFitForJonswap) {
  // DNV-RP-C205: Tz/Tp = 0.6673 + 0.05037 γ - 0.006230 γ² + 0.0003341 γ³, 1 ≤ γ < 7; a fit, told
  // to four digits, that differs from the integrals by some 1e-3 itself
  for (const double gamma : {1.0, 2.0, 3.3, 5.0}) {
    const double fit =
        0.6673 + 0.05037 * gamma - 0.006230 * gamma * gamma + 0.0003341 * gamma * gamma * gamma;
    EXPECT_NEAR(peak_period(PeriodType::kZeroCrossing, 1.0, gamma) * fit, 1.0, 5e-3) << gamma;
  }
}

TEST(ScatterDiagram, AddsUpToOne) {
  const MatXd counts = (MatXd(2, 3) << 1, 2, 0, 3, 0, 4).finished();
  const ScatterDiagram diagram =
      scatter_diagram({0.5, 1.5}, {4.0, 6.0, 8.0}, PeriodType::kPeak, counts);
  EXPECT_NEAR(diagram.probability.sum(), 1.0, 1e-15);
  EXPECT_NEAR(diagram.probability(1, 2), 0.4, 1e-15);

  WaveClimate climate;
  climate.scatter = diagram;
  EXPECT_NEAR(climate.energy(0), (0.1 * 0.25 + 0.3 * 2.25) / 16.0, 1e-15);
  EXPECT_NEAR(climate.spectrum(1).m0(), 1.0 / 16.0, 1e-12);
}

TEST(ScatterDiagram, RefusesWhatIsNone) {
  const MatXd one = MatXd::Ones(1, 1);
  const auto type = PeriodType::kPeak;
  EXPECT_THROW(scatter_diagram({}, {1.0}, type, MatXd(0, 1)), InputError);
  EXPECT_THROW(scatter_diagram({0.0}, {1.0}, type, one), InputError);
  EXPECT_THROW(scatter_diagram({1.0}, {1.0}, type, 0.0 * one), InputError);
  EXPECT_THROW(scatter_diagram({1.0}, {1.0}, type, -one), InputError);
  EXPECT_THROW(scatter_diagram({1.0}, {1.0}, type, NAN * one), InputError);
  EXPECT_THROW(scatter_diagram({1.0, 1.0}, {1.0}, type, MatXd::Ones(2, 1)), InputError);
  EXPECT_THROW(scatter_diagram({1.0}, {1.0}, type, MatXd::Ones(2, 1)), InputError);
}

}  // namespace
}  // namespace floe::wave
