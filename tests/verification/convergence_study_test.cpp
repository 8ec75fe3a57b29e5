#include "test_case.hpp"

#include <floe/convergence_study.hpp>
#include <floe/numeric/error.hpp>

#include <csv.hpp>
#include <expect.hpp>
#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <cmath>

// The error that a study tells, against the error that the answers have.
namespace floe {
namespace {

class Silent final : public Log {
 public:
  void info(const std::string&) override {}
  void notice(const std::string&) override {}
  void warning(const std::string&) override {}
  void progress(double, const std::string&) override {}
};

// f + c hᵖ with complex c at h, h/2, h/4
TEST(Extrapolation, IsExactForOnePower) {
  for (const double order : {1.0, 1.7, 2.0, 3.2}) {
    const VecXcd limit{{Complex(1.0, 2.0), Complex(-3.0, 0.5), Complex(0.0, 0.0)}};
    const VecXcd slope{{Complex(0.1, -0.2), Complex(0.05, 0.0), Complex(0.0, 0.3)}};
    MatXcd answers(3, 3);
    for (int level = 0; level < 3; ++level)
      answers.col(level) = limit + std::exp2(-order * level) * slope;
    const Extrapolation found = extrapolate(answers);
    test::expect_close(found.order, order, 1e-10);
    test::expect_all_close(found.value, limit, 1e-12);
  }
}

TEST(Extrapolation, TellsWhatDoesNotSettle) {
  const Extrapolation found = extrapolate(MatXcd{{Complex(1.0), Complex(2.0), Complex(1.1)}});
  EXPECT_EQ(found.order, 0.0);
  EXPECT_EQ(found.value[0], Complex(1.1));
  EXPECT_EQ(extrapolate(MatXcd::Ones(2, 3)).value[1], Complex(1.0));
}

Complex reference(const StudiedAnswer& answer, const std::string& theory) {
  const auto row = test::read_reference("table1_rao_points.csv")
                       .where("theory", theory)
                       .where("omega", answer.omega)
                       .where("heading_deg", answer.heading_deg)
                       .where("point", answer.point);
  return {row.numbers("re_w").at(0), row.numbers("im_w").at(0)};
}

// The plate of Table 1 on elements of 12 m, 6 m and 3 m against the independent spectral solution
TEST(verification_ConvergenceStudy, TellsTheErrorThatTheAnswersHave) {
  const test::TestFolder folder;
  Case data = test::table1_case(25, 5);
  data.omega = {0.42, 0.72};
  data.heading_deg = {0.0, 60.0};
  Silent log;
  const ConvergenceStudy study = study_convergence(data, folder.path(), log);
  ASSERT_EQ(study.answers.size(), 20u);
  ASSERT_EQ(study.groups.size(), 2u);
  for (const StudiedGroup& group : study.groups) {
    double own = 0.0, extrapolated = 0.0, modes = 0.0;
    for (const StudiedAnswer& answer : study.answers) {
      if (answer.omega != group.omega) continue;
      const Complex exact = reference(answer, "mindlin_30modes");
      own = std::max(own, std::abs(answer.value - exact));
      extrapolated = std::max(extrapolated, std::abs(answer.extrapolated - exact));
      modes = std::max(modes, std::abs(exact - reference(answer, "mindlin")));
    }
    own /= group.largest, extrapolated /= group.largest, modes /= group.largest;
    // The estimate is as good as the extrapolation is better than the answer
    EXPECT_LT(extrapolated, own / 3.0) << group.omega;
    EXPECT_NEAR(group.mesh_error, own, 1.01 * extrapolated) << group.omega;
    EXPECT_GT(group.order, 1.5) << group.omega;
    // Twice the modes hold most of what is missing
    EXPECT_GT(group.mode_error, 0.5 * modes) << group.omega;
    EXPECT_LT(group.mode_error, 1.5 * modes + own) << group.omega;
  }
}

TEST(ConvergenceStudy, NeedsAPoint) {
  const test::TestFolder folder;
  Case data = test::table1_case(4, 2);
  data.omega = {0.42};
  data.heading_deg = {0.0};
  data.points.clear();
  Silent log;
  EXPECT_THROW(study_convergence(data, folder.path(), log), InputError);
}

}  // namespace
}  // namespace floe
