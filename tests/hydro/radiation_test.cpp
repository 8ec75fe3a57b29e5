#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/hydro/wave_field.hpp>
#include <floe/numeric/error.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <rigid_plate.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace floe::hydro {
namespace {

using test::SolvedPlate;

const mesh::Q8Mesh& small_plate() {
  static const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 60.0, .width = 30.0, .nx = 16, .ny = 8});
  return mesh;
}

const wave::Water kWater{.depth = 12.0};
constexpr double kOmega = 0.9;

const SolvedPlate& solved() {
  static const SolvedPlate plate(small_plate(), kOmega, kWater, 1000.0);
  return plate;
}

TEST(SurfaceMass, IntegratesAreaAndMoments) {
  const SparseMatrix mass = surface_mass(small_plate());
  const VecXd one = VecXd::Ones(small_plate().node_count());
  const VecXd x = small_plate().nodes().row(0).transpose();
  EXPECT_NEAR(one.dot(mass * one), 60.0 * 30.0, 1e-9);
  EXPECT_NEAR(x.dot(mass * x), 60.0 * 60.0 * 60.0 * 30.0 / 12.0, 1e-6);
}

TEST(WaveLoads, SumToTheClosedFormOfARectangle) {
  // ∫ e^{ik(x cos β + y sin β)} over the rectangle = L sinc(kL cos β / 2) · B sinc(kB sin β / 2)
  const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; };
  const std::vector<double> heading{0.0, 0.7, 1.5, 3.0};
  for (const double k : {0.01, 0.3, 2.0}) {
    const MatXcd loads = wave_loads(small_plate(), k, heading);
    for (std::size_t b = 0; b < heading.size(); ++b) {
      const double exact = 60.0 * sinc(30.0 * k * std::cos(heading[b])) * 30.0 *
                           sinc(15.0 * k * std::sin(heading[b]));
      EXPECT_LE(std::abs(loads.col(b).sum() - exact), 1e-9 * 1800.0) << k << " " << heading[b];
    }
  }
}

TEST(twin_WaveLoads, GiveTheTransformOfAFieldOnTheFullCircle) {
  const MatXcd field = MatXcd::Random(small_plate().node_count(), 3);
  for (const int count : {2, 24, 38}) {
    const MatXcd loads = wave_loads(small_plate(), 0.3, full_circle(count));
    const MatXcd transform = full_circle_transform(small_plate(), 0.3, count, field);
    EXPECT_LE(test::relative_error(transform, field.transpose() * loads), 1e-13) << count;
  }
}

TEST(identity_Radiation, DirectAndReciprocalForcesAgree) {
  // Both tend to the same force; on this mesh of kE = 0.5 they differ by the discretisation error
  const std::vector<double> heading{0.0, 0.4, 1.2, 2.5};
  const SolvedPlate& plate = solved();
  const MatXcd elevation = incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading);
  const MatXcd direct =
      exciting_forces_direct(plate.deflection, plate.surface_mass,
                             solve_diffraction(plate.pressure_operator, elevation, kWater, 1e-10));
  const MatXcd reciprocal =
      exciting_forces(plate.radiation.pressure, wave_loads(plate.mesh, plate.wavenumber, heading));
  EXPECT_LE(test::relative_error(reciprocal, direct), 5e-3);
}

TEST(identity_Radiation, ForcesOfAWaveThatIsHigherOnOneSideAgreeToo) {
  // Reciprocity holds for any elevation: an amplitude that goes from 0 to 1 along the plate (E.25)
  const std::vector<double> heading{0.0, 0.4, 1.2, 2.5};
  const SolvedPlate& plate = solved();
  const VecXcd amplitude =
      (0.5 + (plate.mesh.nodes().row(0).transpose().array() / 60.0)).matrix().cast<Complex>();
  const MatXcd elevation =
      amplitude.asDiagonal() * incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading);
  const MatXcd direct =
      exciting_forces_direct(plate.deflection, plate.surface_mass,
                             solve_diffraction(plate.pressure_operator, elevation, kWater, 1e-10));
  const MatXcd reciprocal = exciting_forces(amplitude.asDiagonal() * plate.radiation.pressure,
                                            wave_loads(plate.mesh, plate.wavenumber, heading));
  EXPECT_LE(test::relative_error(reciprocal, direct), 5e-3);
}

TEST(identity_Radiation, OfATransposedProblemIsNotTheSameProblem) {
  // A guard for the tests above: a wave from the other side gives another force
  const SolvedPlate& plate = solved();
  const std::vector<double> heading{0.4}, reversed{0.4 + std::numbers::pi};
  const MatXcd force =
      exciting_forces(plate.radiation.pressure, wave_loads(plate.mesh, plate.wavenumber, heading));
  const MatXcd other =
      exciting_forces(plate.radiation.pressure, wave_loads(plate.mesh, plate.wavenumber, reversed));
  EXPECT_GE(test::relative_error(other, force), 0.1);
}

TEST(limit_Radiation, TendsToHydrostaticsAsTheFrequencyVanishes) {
  // p → -ρg w, the next term is of the order κ𝒢 ~ νL; P_ij → -ρg ∫ w_i w_j
  const wave::Water water{.depth = 12.0};
  const SolvedPlate plate(small_plate(), 1e-4, water);
  const MatXd hydrostatic =
      1025.0 * 9.81 * plate.deflection.transpose() * (plate.surface_mass * plate.deflection);
  EXPECT_LE(test::relative_error(plate.radiation.fluid_matrix, -hydrostatic.cast<Complex>()), 1e-4);
}

TEST(Radiation, ReportsAResidualOverItsLimitAsAnError) {
  const SolvedPlate& plate = solved();
  EXPECT_THROW(solve_radiation(plate.pressure_operator, plate.deflection, plate.surface_mass,
                               kOmega, kWater, 0.0),
               ConvergenceError);
}

TEST(identity_WaveField, OnThePlateIsDeflectionPlusPressureHead) {
  const SolvedPlate& plate = solved();
  const std::vector<double> heading{0.6};
  const MatXcd elevation = incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading);
  const MatXcd pressure = solve_diffraction(plate.pressure_operator, elevation, kWater, 1e-10);
  const Points2 nodes = plate.mesh.nodes().leftCols(20);
  const MatXcd field =
      wave_elevation(plate.integrals, plate.green, kWater, nodes, elevation.topRows(20), pressure);
  // At collocation nodes, that is the solver's own residual
  test::expect_all_close(field, pressure.topRows(20) / (1025.0 * 9.81), 1e-7);
}

TEST(identity_WaveField, IsContinuousAtTheEdge) {
  const SolvedPlate& plate = solved();
  const std::vector<double> heading{0.6};
  const MatXcd elevation = incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading);
  const MatXcd pressure = solve_diffraction(plate.pressure_operator, elevation, kWater, 1e-10);
  // ζ is continuous with a slope that grows like the logarithm of the distance from the edge: a
  // step of d changes it by d·ln(L/d) times the gradient scale k
  for (const double d : {1e-2, 1e-4, 1e-6}) {
    Points2 points(2, 4);
    points << 30.0, 30.0 + d, 3.3, 3.3,  //
        4.1, 4.1, -15.0, -15.0 - d;
    const MatXcd incident = incident_elevation(points, plate.wavenumber, heading);
    const MatXcd field =
        wave_elevation(plate.integrals, plate.green, kWater, points, incident, pressure);
    const double bound = 3.0 * plate.wavenumber * d * std::log(60.0 / d);
    EXPECT_LE(std::abs(field(1) - field(0)), bound + 1e-7) << d;
    EXPECT_LE(std::abs(field(3) - field(2)), bound + 1e-7) << d;
  }
}

TEST(identity_WaveField, ApproachesItsFarFieldAmplitude) {
  const SolvedPlate& plate = solved();
  const std::vector<double> heading{0.6};
  const MatXcd elevation = incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading);
  const MatXcd pressure = solve_diffraction(plate.pressure_operator, elevation, kWater, 1e-10);
  const double k = plate.wavenumber, r = 900.0, theta = 2.1;
  Points2 point(2, 1);
  point << r * std::cos(theta), r * std::sin(theta);
  const Complex scattered =
      wave_elevation(plate.integrals, plate.green, kWater, point, MatXcd::Zero(1, 1), pressure)(0);
  const std::vector<double> reversed{theta + std::numbers::pi};
  const Complex amplitude = far_field_amplitude(plate.green.exact(), kWater,
                                                wave_loads(plate.mesh, k, reversed), pressure)(0);
  const Complex asymptotic = amplitude * std::sqrt(2.0 / (std::numbers::pi * k * r)) *
                             std::polar(1.0, k * r - 0.25 * std::numbers::pi);
  // The next term of the expansion is of the order k R²/(2r), R = 33 m the half-diagonal
  EXPECT_LE(std::abs(scattered - asymptotic), 0.5 * k * 33.0 * 33.0 / r * std::abs(asymptotic));
}

TEST(identity_WaveField, SatisfiesTheOpticalTheorem) {
  // (1/2π)∫|A|² dθ = -Re A(β) for the fixed plate, without losses (H.10); the discretisation error
  // of an exciting force, 5e-3 as above, is the tolerance
  const SolvedPlate& plate = solved();
  const std::vector<double> heading{0.6};
  const MatXcd elevation = incident_elevation(plate.mesh.nodes(), plate.wavenumber, heading);
  const MatXcd pressure = solve_diffraction(plate.pressure_operator, elevation, kWater, 1e-10);
  std::vector<double> reversed = full_circle(200);
  const MatXcd circle = far_field_amplitude(
      plate.green.exact(), kWater, wave_loads(plate.mesh, plate.wavenumber, reversed), pressure);
  const std::vector<double> back{heading[0] + std::numbers::pi};
  const Complex forward = far_field_amplitude(
      plate.green.exact(), kWater, wave_loads(plate.mesh, plate.wavenumber, back), pressure)(0);
  const double scattered = circle.squaredNorm() / 200.0;
  EXPECT_GT(scattered, 1e-3);
  EXPECT_NEAR(scattered / -forward.real(), 1.0, 5e-3);
}

TEST(order_WaveField, ResidualAtElementCentresFallsUnderRefinement) {
  // No Q8 node lies at an element's centre: there w + p/ρg - ζ_total is the discretisation residual
  double previous = std::numeric_limits<double>::infinity();
  for (const int n : {1, 2, 4}) {
    const mesh::Q8Mesh mesh =
        mesh::make_rectangle({.length = 60.0, .width = 30.0, .nx = 8 * n, .ny = 4 * n});
    const SolvedPlate plate(mesh, kOmega, kWater);
    const std::vector<double> heading{0.6};
    const MatXcd pressure = solve_diffraction(
        plate.pressure_operator, incident_elevation(mesh.nodes(), plate.wavenumber, heading),
        kWater, 1e-10);
    Points2 centres(2, mesh.element_count());
    VecXcd head(mesh.element_count());
    for (Index e = 0; e < mesh.element_count(); ++e) {
      const mesh::Shape8 shape = mesh::q8_shape(0.0, 0.0);
      centres.col(e) = mesh.element_nodes(e) * shape;
      head[e] = 0.0;
      for (int a = 0; a < 8; ++a)
        head[e] += shape[a] * pressure(mesh.elements()(a, e)) / 1025.0 / 9.81;
    }
    const MatXcd field =
        wave_elevation(plate.integrals, plate.green, kWater, centres,
                       incident_elevation(centres, plate.wavenumber, heading), pressure);
    const double residual =
        std::sqrt((field - head).squaredNorm() / static_cast<double>(head.size()));
    // Of the order h^1.5 at least in the mean: the square root of an edge strip with error h
    EXPECT_LE(residual, previous / 2.8) << n;
    previous = residual;
  }
  EXPECT_LE(previous, 1e-3);
}

}  // namespace
}  // namespace floe::hydro
