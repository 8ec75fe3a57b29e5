#include <floe/hydro/flexural_gravity.hpp>
#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floe::hydro {
namespace {

const plate::PlateProperties kPlate{.thickness = 2.0,
                                    .youngs_modulus = 1.19e10,
                                    .poisson_ratio = 0.13,
                                    .density = 256.25,
                                    .shear_correction = 5.0 / 6.0,
                                    .loss_factor = 0.0};

// Independent check: put the root back into (H.1), terms relative to the right-hand side
TEST(FlexuralWavenumber, SatisfiesItsDispersionRelation) {
  for (const double depth : {0.5, 58.5, std::numeric_limits<double>::infinity()}) {
    const wave::Water water{.depth = depth, .density = 1025.0, .gravity = 9.81};
    for (double omega = 0.01; omega < 50.0; omega *= 1.3) {
      const double k = flexural_wavenumber(omega, water, kPlate);
      const double stiff = kPlate.bending_rigidity() * std::pow(k, 4) + 1025.0 * 9.81;
      const double t = k * std::tanh(k * depth);
      const double right = 1025.0 * omega * omega + kPlate.surface_mass() * omega * omega * t;
      // Five powers of k at a relative error of 1e-12 each
      EXPECT_NEAR(stiff * t / right, 1.0, 5e-12) << "omega=" << omega << " depth=" << depth;
    }
  }
}

// THEORY section 5 gives these lengths for the plate of Table 1, to three digits
TEST(FlexuralWavenumber, GivesTheLengthsOfTheReferencePlate) {
  const wave::Water water{.depth = 58.5, .density = 1025.0, .gravity = 9.81};
  constexpr double kTurn = 2.0 * std::numbers::pi;
  EXPECT_NEAR(kTurn / flexural_wavenumber(1.0, water, kPlate), 163.0, 0.5);
  EXPECT_NEAR(kTurn / flexural_wavenumber(0.7, water, kPlate), 203.0, 0.5);
}

TEST(limit_FlexuralWavenumber, TendsToTheWaterWaveForALimpMasslessPlate) {
  plate::PlateProperties limp = kPlate;
  limp.youngs_modulus = 1e-6;
  limp.density = 1e-9;
  const wave::Water water{.depth = 20.0, .density = 1025.0, .gravity = 9.81};
  for (const double omega : {0.1, 1.0, 3.0})
    EXPECT_NEAR(flexural_wavenumber(omega, water, limp) / wave::wavenumber(omega, water), 1.0,
                1e-9);
}

TEST(FlexuralWavenumber, RejectsNonPositiveFrequency) {
  EXPECT_THROW(flexural_wavenumber(0.0, wave::Water{}, kPlate), InputError);
  EXPECT_THROW(flexural_wavenumber(-1.0, wave::Water{}, kPlate), InputError);
}

}  // namespace
}  // namespace floe::hydro
