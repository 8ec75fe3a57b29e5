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

void expect_reference_coefficients(const SolvedPlate& plate) {
  const auto rows =
      test::read_reference("rigid_rectangle_radiation.csv").where("omega", plate.omega);
  ASSERT_EQ(rows.row_count(), 3u);
  for (std::size_t i = 0; i < rows.row_count(); ++i) {
    const int mode = kModes.at(rows.strings("mode_i")[i]);
    // 0.1 % of each coefficient
    test::expect_close(plate.radiation.added_mass(mode, mode), rows.numbers("added_mass")[i], 1e-3,
                       0.0, "added mass of mode " + std::to_string(mode));
    test::expect_close(plate.radiation.damping(mode, mode), rows.numbers("damping")[i], 1e-3, 0.0,
                       "damping of mode " + std::to_string(mode));
  }
}

void expect_reference_forces(const SolvedPlate& plate) {
  const auto rows =
      test::read_reference("rigid_rectangle_excitation.csv").where("omega", plate.omega);
  ASSERT_EQ(rows.row_count(), 5u);
  const auto re = rows.numbers("X_over_rho_g_A_re"), im = rows.numbers("X_over_rho_g_A_im");
  double largest[3] = {};  // of each mode, all headings
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

void expect_all(double omega) {
  const SolvedRectangle solved(omega);
  const SolvedPlate& plate = solved.plate;
  expect_reference_coefficients(plate);
  expect_reference_forces(plate);

  // Damping is the energy radiated, the fluid matrix is symmetric
  const MatXd radiated =
      hydro::radiated_damping(plate.radiation.pressure, plate.mesh, omega, plate.water);
  EXPECT_LE(hydro::energy_error(plate.radiation, radiated, omega), 2e-4);
  EXPECT_LE(hydro::reciprocity_error(plate.radiation, omega), 1e-4);
}

TEST(verification_RigidRectangle, HoldsReferenceEnergyAndSymmetryInLongWaves) { expect_all(0.42); }

TEST(verification_RigidRectangle, HoldsReferenceEnergyAndSymmetryInShortWaves) { expect_all(1.01); }

}  // namespace
}  // namespace floe
