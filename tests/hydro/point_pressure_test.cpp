#include <floe/hydro/point_pressure.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/response/stations.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <rigid_plate.hpp>

#include <numbers>
#include <string>
#include <vector>

namespace floe::hydro {
namespace {

using test::SolvedPlate;

const wave::Water kWater{.depth = 12.0};
constexpr double kOmega = 0.9;
const std::vector<double> kHeadings = {0.0, 0.4, 1.2, 2.5, 4.0};

// A corner, a mid-side of an edge, the centre, and places within elements
Points2 points() {
  Points2 all(2, 5);
  all << -30.0, 30.0, 0.0, 7.3, -29.2, -15.0, 0.0, 0.0, 4.1, 3.3;
  return all;
}

// Largest difference of the two ways to the wave pressure, relative to the largest pressure
double difference(int nx, int ny) {
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 60.0, .width = 30.0, .nx = nx, .ny = ny});
  const SolvedPlate plate(mesh, kOmega, kWater);
  const std::vector<std::string> names(5, "point");
  const SparseMatrix at_points = response::interpolation_to(plate.mesh, points(), names);
  const MatXcd direct =
      at_points.cast<Complex>() *
      solve_diffraction(plate.pressure_operator,
                        incident_elevation(plate.mesh.nodes(), plate.wavenumber, kHeadings), kWater,
                        1e-10);
  const MatXcd influence =
      wave_pressure_influence(plate.pressure_operator, plate.integrals, plate.green,
                              plate.surface_mass, points(), kWater, 1e-10);
  const MatXcd own =
      kWater.density * kWater.gravity * incident_elevation(points(), plate.wavenumber, kHeadings) -
      influence.transpose() * wave_loads(plate.mesh, plate.wavenumber, kHeadings);
  return (own - direct).cwiseAbs().maxCoeff() / direct.cwiseAbs().maxCoeff();
}

TEST(order_PointPressure, MeetsTheDiffractionProblemWithOrderTwoOrMore) {
  // Four, eight and sixteen elements on the wave of 32 m and less
  const std::vector<double> size = {7.5, 3.75, 1.875};
  const std::vector<double> error = {difference(8, 4), difference(16, 8), difference(32, 16)};
  RecordProperty("coarse", std::to_string(error[0]));
  RecordProperty("middle", std::to_string(error[1]));
  RecordProperty("fine", std::to_string(error[2]));
  EXPECT_LE(error[2], 5e-3);  // what standard deviations are asked for
  EXPECT_GE(test::observed_order(size, error), 1.8);
}

}  // namespace
}  // namespace floe::hydro
