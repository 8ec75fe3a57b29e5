#include "expect.hpp"

#include <floe/coupling/modal_equation.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe::coupling {
namespace {

// Two modes, the second elastic, without and with a fluid that neither stiffens nor damps
plate::DryModes two_modes(double omega) {
  plate::DryModes modes;
  modes.omega = (VecXd(2) << 0.0, omega).finished();
  modes.modal_mass = MatXd::Identity(2, 2);
  return modes;
}

TEST(ModalAmplitudes, RefuseAResonanceWithoutDamping) {
  const MatXcd nothing = MatXcd::Zero(2, 2), force = MatXcd::Ones(2, 1);
  try {
    modal_amplitudes(two_modes(0.7), 0.0, 0.7, nothing, force);
    FAIL() << "accepted";
  } catch (const ConvergenceError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("omega = 0.7 rad/s"));
    EXPECT_THAT(error.what(), testing::HasSubstr("set plate.loss_factor"));
  }
}

// (Ω²(1 - iη) - ω²) ξ = F
TEST(ModalAmplitudes, AreLimitedByTheLossFactor) {
  const MatXcd nothing = MatXcd::Zero(2, 2), force = MatXcd::Ones(2, 1);
  const MatXcd amplitude = modal_amplitudes(two_modes(0.7), 0.02, 0.7, nothing, force);
  test::expect_close(amplitude(1, 0), Complex(0.0, 1.0 / (0.02 * 0.49)), 1e-12);
  test::expect_close(amplitude(0, 0), Complex(-1.0 / 0.49), 1e-12);
}

}  // namespace
}  // namespace floe::coupling
