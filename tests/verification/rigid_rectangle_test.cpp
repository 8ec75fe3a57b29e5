#include <csv.hpp>
#include <expect.hpp>
#include <gtest/gtest.h>
#include <rigid_plate.hpp>

#include <map>
#include <numbers>
#include <string>

// The rigid zero-draft rectangle 300 × 60 m in 58.5 m of water, 3 m elements, against an
// independent spectral solution.
namespace floe {
namespace {

using test::SolvedPlate;

const std::map<std::string, int> kModes{{"heave", 0}, {"pitchx", 1}, {"rolly", 2}};

struct SolvedRectangle {
  explicit SolvedRectangle(double omega)
      : mesh(mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 100, .ny = 20})),
        plate(mesh, omega, test::table1_water()) {}
  mesh::Q8Mesh mesh;
  SolvedPlate plate;
};

// Solved once for all tests of this file
const SolvedRectangle& solved(double omega) {
  static std::map<double, std::unique_ptr<SolvedRectangle>> all;
  auto& entry = all[omega];
  if (!entry) entry = std::make_unique<SolvedRectangle>(omega);
  return *entry;
}

constexpr double kFrequencies[] = {0.42, 1.01};

TEST(verification_RigidRectangle, AddedMassAndDampingAgreeWithTheReference) {
  const auto table = test::read_csv(FLOE_TEST_DATA "/rigid_rectangle_radiation.csv");
  for (const double omega : kFrequencies) {
    const auto rows = table.where("omega", omega);
    ASSERT_EQ(rows.row_count(), 3u);
    const auto& radiation = solved(omega).plate.radiation;
    for (std::size_t i = 0; i < rows.row_count(); ++i) {
      const int mode = kModes.at(rows.strings("mode_i")[i]);
      // 0.1 % of each coefficient
      test::expect_close(radiation.added_mass(mode, mode), rows.numbers("added_mass")[i], 1e-3, 0.0,
                         "added mass of mode " + std::to_string(mode));
      test::expect_close(radiation.damping(mode, mode), rows.numbers("damping")[i], 1e-3, 0.0,
                         "damping of mode " + std::to_string(mode));
    }
  }
}

// Largest |force| of each mode in the reference at one frequency, times ρg
TEST(verification_RigidRectangle, ExcitingForcesAgreeWithTheReferenceBothWays) {
  const auto table = test::read_csv(FLOE_TEST_DATA "/rigid_rectangle_excitation.csv");
  for (const double omega : kFrequencies) {
    const SolvedPlate& plate = solved(omega).plate;
    const auto rows = table.where("omega", omega);
    const auto re = rows.numbers("X_over_rho_g_A_re"), im = rows.numbers("X_over_rho_g_A_im");
    std::map<int, double> largest;
    for (std::size_t i = 0; i < rows.row_count(); ++i) {
      double& most = largest[kModes.at(rows.strings("mode")[i])];
      most = std::max(most, std::abs(Complex(re[i], im[i])));
    }
    for (std::size_t i = 0; i < rows.row_count(); ++i) {
      const int mode = kModes.at(rows.strings("mode")[i]);
      const std::vector<double> heading{rows.numbers("heading_deg")[i] * std::numbers::pi / 180.0};
      const MatXcd reciprocal = hydro::exciting_forces(
          plate.radiation.pressure, hydro::wave_loads(plate.mesh, plate.wavenumber, heading));
      const MatXcd direct = hydro::exciting_forces_direct(
          plate.deflection, plate.surface_mass,
          hydro::solve_diffraction(
              plate.pressure_operator,
              hydro::incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading), plate.water,
              1e-10));
      const double weight = plate.water.density * plate.water.gravity;
      const Complex expected(re[i], im[i]);
      // 0.15 % of the largest force of that mode
      test::expect_close(reciprocal(mode, 0) / weight, expected, 0.0, 1.5e-3 * largest[mode],
                         "reciprocal, mode " + std::to_string(mode));
      test::expect_close(direct(mode, 0) / weight, expected, 0.0, 1.5e-3 * largest[mode],
                         "direct, mode " + std::to_string(mode));
    }
  }
}

TEST(verification_RigidRectangle, RadiatesTheEnergyThatDampingTakes) {
  for (const double omega : kFrequencies) {
    const SolvedPlate& plate = solved(omega).plate;
    const MatXd radiated =
        hydro::radiated_damping(plate.radiation.pressure, plate.mesh, omega, plate.water);
    EXPECT_LE(hydro::energy_error(plate.radiation, radiated, omega), 2e-4) << omega;
  }
}

TEST(verification_RigidRectangle, HasASymmetricFluidMatrix) {
  for (const double omega : kFrequencies)
    EXPECT_LE(hydro::reciprocity_error(solved(omega).plate.radiation, omega), 1e-4) << omega;
}

}  // namespace
}  // namespace floe
