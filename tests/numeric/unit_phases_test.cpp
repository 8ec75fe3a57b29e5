#include <floe/numeric/unit_phases.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace floe::numeric {
namespace {

TEST(twin_UnitPhases, EqualTheLibrarysCosineAndSine) {
  std::mt19937_64 random(7);
  for (const double range : {1e-3, 1.0, 100.0, 1e6}) {
    std::uniform_real_distribution<double> any(-range, range);
    std::vector<double> angle(10'001), cosine(angle.size()), sine(angle.size());
    for (double& a : angle) a = any(random);
    angle[0] = 0.0;
    unit_phases(angle.data(), static_cast<Index>(angle.size()), cosine.data(), sine.data());
    for (std::size_t i = 0; i < angle.size(); ++i) {
      ASSERT_LE(std::hypot(cosine[i] - std::cos(angle[i]), sine[i] - std::sin(angle[i])), 5e-16);
    }
  }
}

TEST(UnitPhases, TurnExactlyAtQuarters) {
  const double quarter = std::acos(0.0);
  std::vector<double> angle, cosine(17), sine(17);
  for (int n = -8; n <= 8; ++n) angle.push_back(n * quarter);
  unit_phases(angle.data(), 17, cosine.data(), sine.data());
  for (int n = -8; n <= 8; ++n) {
    EXPECT_NEAR(cosine[static_cast<std::size_t>(n + 8)], std::cos(n * quarter), 2e-16) << n;
    EXPECT_NEAR(sine[static_cast<std::size_t>(n + 8)], std::sin(n * quarter), 2e-16) << n;
  }
}

}  // namespace
}  // namespace floe::numeric
