#include <floe/numeric/error.hpp>
#include <floe/response/design_values.hpp>
#include <floe/response/long_term.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floe::response {
namespace {

// Zero-crossing periods of 6.28 s, 3.14 s and 12.6 s; calm in a tenth of the time
const std::vector<ShortTermResponse> kStates = {
    {0.6, 1.0, 1.0}, {0.299, 4.0, 16.0}, {0.001, 25.0, 6.25}};

// Peaks beyond a level in a second, summed by hand (E.21)
double rate_beyond(double level) {
  double sum = 0.0;
  for (const ShortTermResponse& state : kStates)
    sum += state.probability * std::sqrt(state.m2 / state.m0) / (2.0 * std::numbers::pi) *
           exceedance(level, state.m0);
  return sum;
}

TEST(limit_LongTerm, OneStateIsRayleigh) {
  const LongTermDistribution one({{1.0, 4.0, 1.0}});
  EXPECT_NEAR(one.exceedance(3.0), exceedance(3.0, 4.0), 1e-15);
  EXPECT_NEAR(one.level(1e-6), std::sqrt(-8.0 * std::log(1e-6)), 1e-12);
  EXPECT_EQ(one.level(1.0), 0.0);
  // What is exceeded once in three hours is the most probable largest of three hours (E.11)
  EXPECT_NEAR(one.return_value(10'800.0), design_values(4.0, 1.0, 10'800.0).most_probable_maximum,
              1e-12);
}

TEST(LongTerm, WeighsTheStatesByTheirPeaks) {
  const LongTermDistribution many(kStates);
  EXPECT_NEAR(many.peak_rate(), rate_beyond(0.0), 1e-15);
  for (const double level : {0.5, 3.0, 12.0})
    EXPECT_NEAR(many.exceedance(level) * many.peak_rate(), rate_beyond(level),
                1e-14 * rate_beyond(level));
}

TEST(LongTerm, LevelsAreExceededAsOftenAsAsked) {
  const LongTermDistribution many(kStates);
  for (const double wanted : {0.9, 0.1, 1e-3, 1e-8, 1e-100, 1e-300})
    EXPECT_NEAR(std::log(many.exceedance(many.level(wanted))) / std::log(wanted), 1.0, 1e-11)
        << wanted;
  const double year = 365.25 * 86'400.0;
  const double value = many.return_value(100.0 * year);
  EXPECT_NEAR(rate_beyond(value) * 100.0 * year, 1.0, 1e-9);
  EXPECT_EQ(many.return_value(1.0), 0.0);  // less than one peak
}

TEST(LongTerm, TellsWhereThePeaksBeyondALevelComeFrom) {
  const LongTermDistribution many(kStates);
  const std::vector<double> shares = many.contributions(10.0);
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1.0, 1e-14);
  EXPECT_NEAR(shares[2],
              0.001 * 0.5 * std::exp(-2.0) / (2.0 * std::numbers::pi) / rate_beyond(10.0), 1e-14);
}

TEST(LongTerm, StatesWithoutMotionHaveNoPeaks) {
  std::vector<ShortTermResponse> states = kStates;
  states.push_back({0.05, 0.0, 0.0});
  states.push_back({0.05, 1e-300, 1e-300});
  const LongTermDistribution many(states);
  EXPECT_NEAR(many.peak_rate(), rate_beyond(0.0), 1e-15);
  EXPECT_NEAR(many.level(1e-5), LongTermDistribution(kStates).level(1e-5), 1e-12);
  EXPECT_FALSE(LongTermDistribution({{1.0, 0.0, 0.0}}).moves());
  EXPECT_EQ(LongTermDistribution({{1.0, 0.0, 0.0}}).exceedance(1.0), 0.0);
}

TEST(LongTerm, RefusesWhatIsNoProbabilityOrMoment) {
  EXPECT_THROW(LongTermDistribution({{-0.1, 1.0, 1.0}}), InputError);
  EXPECT_THROW(LongTermDistribution({{0.1, NAN, 1.0}}), InputError);
  EXPECT_THROW(LongTermDistribution(kStates).level(0.0), InputError);
  EXPECT_THROW(LongTermDistribution(kStates).level(1.1), InputError);
  EXPECT_THROW(LongTermDistribution(kStates).return_value(-1.0), InputError);
  EXPECT_THROW(LongTermDistribution({}).level(0.5), InputError);
}

}  // namespace
}  // namespace floe::response
