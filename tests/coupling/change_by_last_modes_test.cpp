#include "expect.hpp"

#include <floe/coupling/modal_equation.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace floe::coupling {
namespace {

// Heave and `elastic` modes that nothing couples
plate::DryModes uncoupled_modes(int elastic) {
  plate::DryModes modes;
  modes.omega = VecXd::LinSpaced(elastic + 1, 0.0, static_cast<double>(elastic));
  modes.modal_mass = MatXd::Identity(elastic + 1, elastic + 1);
  modes.rigid_count = 1;
  return modes;
}

// Without coupling the change is the motion in the highest quarter itself
TEST(ChangeByLastModes, IsTheirMotionWhereNothingCouples) {
  const plate::DryModes modes = uncoupled_modes(8);
  const MatXcd fluid = MatXcd::Zero(9, 9), force = MatXcd::Ones(9, 1);
  const MatXd shape = MatXd::Identity(9, 9);
  const MatXcd amplitudes = modal_amplitudes(modes, 0.0, 0.5, fluid, force);
  const double largest = amplitudes.cwiseAbs().maxCoeff();
  EXPECT_NEAR(change_by_last_modes(modes, 0.0, 0.5, fluid, force, amplitudes, shape),
              std::abs(amplitudes(7, 0)) / largest, 1e-15);
}

// With coupling the modes that stay move too: against the smaller equation, solved by itself
TEST(ChangeByLastModes, IncludesWhatTheOthersDo) {
  const plate::DryModes modes = uncoupled_modes(4);
  MatXcd fluid = MatXcd::Constant(5, 5, Complex(-0.3, 0.2));
  fluid.diagonal().array() -= 1.0;
  const MatXcd force = MatXcd::Ones(5, 2);
  const MatXcd amplitudes = modal_amplitudes(modes, 0.0, 0.5, fluid, force);
  MatXcd dynamic = -fluid.topLeftCorner(4, 4);
  for (Index i = 0; i < 4; ++i) dynamic(i, i) += static_cast<double>(i * i) - 0.25;
  const MatXcd fewer = dynamic.inverse() * force.topRows(4);
  const MatXd heave_only = (MatXd(1, 5) << 1.0, 0.0, 0.0, 0.0, 0.0).finished();
  EXPECT_NEAR(change_by_last_modes(modes, 0.0, 0.5, fluid, force, amplitudes, heave_only),
              std::abs(amplitudes(0, 0) - fewer(0, 0)) / std::abs(amplitudes(0, 0)), 1e-12);
}

TEST(ChangeByLastModes, IsZeroWithFewerThanFourElasticModes) {
  const plate::DryModes modes = uncoupled_modes(3);
  const MatXcd fluid = MatXcd::Zero(4, 4), force = MatXcd::Ones(4, 1);
  EXPECT_EQ(
      change_by_last_modes(modes, 0.0, 0.5, fluid, force,
                           modal_amplitudes(modes, 0.0, 0.5, fluid, force), MatXd::Identity(4, 4)),
      0.0);
}

}  // namespace
}  // namespace floe::coupling
