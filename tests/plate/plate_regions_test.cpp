#include "expect.hpp"
#include "plates.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/section_forces.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace floe::plate {
namespace {

// The elements with their middle at x > 0 are of region 1
std::vector<int> right_half(const mesh::Q8Mesh& mesh) {
  std::vector<int> region;
  for (Index e = 0; e < mesh.element_count(); ++e)
    region.push_back(mesh.element_nodes(e).row(0).mean() > 0.0 ? 1 : 0);
  return region;
}

TEST(PlateRegions, OfTheSamePropertiesAreTheUniformPlateToTheLastBit) {
  const mesh::Q8Mesh mesh = test::bent_rectangle(6, 4, 120.0, 60.0, 1.5).build();
  const PlateProperties properties = test::table1_properties();
  const PlateRegions halves({properties, properties}, right_half(mesh));
  const PlateMatrices uniform = assemble_plate(mesh, properties),
                      split = assemble_plate(mesh, halves);
  EXPECT_TRUE(test::same_bits(uniform.stiffness, split.stiffness));
  EXPECT_TRUE(test::same_bits(uniform.mass, split.mass));
  const DryModes one = dry_modes(mesh, properties, {.count = 12});
  const DryModes two = dry_modes(mesh, halves, {.count = 12});
  test::expect_all_close(two.omega, one.omega, 1e-12);
}

// Nodal unknowns of a rigid body carry the whole mass: each region its own density and thickness
TEST(PlateRegions, CarryTheirOwnMass) {
  const mesh::Q8Mesh mesh = test::rectangle_arrays(6, 2, 60.0, 20.0).build();
  PlateProperties thick = test::table1_properties();
  thick.thickness = 3.0;
  thick.density = 400.0;
  const PlateMatrices plate =
      assemble_plate(mesh, PlateRegions({test::table1_properties(), thick}, right_half(mesh)));
  const VecXd heave =
      test::nodal_values(mesh, [](double, double) { return Eigen::Vector3d::UnitX(); });
  const double expected = 600.0 * (2.0 * 256.25 + 3.0 * 400.0);
  EXPECT_NEAR(heave.dot(plate.mass * heave), expected, 1e-12 * expected);
}

// Free beam of two halves, Euler and Bernoulli: from each free end cos + cosh and sin + sinh; where
// they meet deflection, slope, moment and shear force agree. The determinant vanishes at ω.
double two_halves_determinant(double omega, double half,
                              const std::array<PlateProperties, 2>& beam) {
  Eigen::Matrix4d condition;
  for (int side = 0; side < 2; ++side) {
    const double rigidity = beam[side].bending_rigidity();
    const double k = std::pow(omega * omega * beam[side].surface_mass() / rigidity, 0.25);
    const double x = k * half, sign = side == 0 ? 1.0 : -1.0;  // slopes seen from the left
    const double c = std::cos(x), s = std::sin(x), ch = std::cosh(x), sh = std::sinh(x);
    condition.block<4, 2>(0, 2 * side) << c + ch, s + sh,          //
        sign * k * (sh - s), sign * k * (c + ch),                  //
        rigidity * k * k * (ch - c), rigidity * k * k * (sh - s),  //
        sign * rigidity * k * k * k * (s + sh), sign * rigidity * k * k * k * (ch - c);
    if (side == 1) condition.block<4, 2>(0, 2) *= -1.0;
  }
  return condition.determinant();
}

std::vector<double> two_halves_omega(double half, const std::array<PlateProperties, 2>& beam,
                                     std::size_t count) {
  std::vector<double> roots;
  const double step = 1e-3;
  for (double low = 10.0 * step; roots.size() < count; low += step) {
    double a = low, b = low + step;
    if (two_halves_determinant(a, half, beam) * two_halves_determinant(b, half, beam) > 0.0)
      continue;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (a + b);
      const bool left =
          two_halves_determinant(a, half, beam) * two_halves_determinant(middle, half, beam) <= 0.0;
      (left ? b : a) = middle;
    }
    roots.push_back(a);
  }
  return roots;
}

// The determinant itself is right: equal halves are a uniform free beam, βL = 4.730, 7.853, 10.996
TEST(PlateRegions, BeamOfEqualHalvesIsTheUniformBeam) {
  const PlateProperties p{
      .thickness = 0.2, .youngs_modulus = 1e10, .poisson_ratio = 0.0, .density = 500.0};
  const std::vector<double> omega = two_halves_omega(50.0, {p, p}, 3);
  const std::array<double, 3> beta{4.730040745, 7.853204624, 10.995607838};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(omega[i],
                std::pow(beta[i] / 100.0, 2) * std::sqrt(p.bending_rigidity() / p.surface_mass()),
                1e-9);
}

// The strip must lie below the beam by no more than rotary inertia and shear take, and above by no
// more than the mesh's error, as the uniform strip of dry_frequencies_test.cpp does; the larger of
// the halves' wavenumbers counts
TEST(limit_PlateRegions, StripOfTwoThicknessesHasTheFrequenciesOfTheBeam) {
  PlateProperties thick{
      .thickness = 0.2, .youngs_modulus = 1e10, .poisson_ratio = 0.0, .density = 500.0};
  PlateProperties thin = thick;
  thin.thickness = 0.1;
  const mesh::Q8Mesh mesh = test::rectangle_arrays(50, 1, 100.0, 2.0).build();
  const DryModes modes =
      dry_modes(mesh, PlateRegions({thick, thin}, right_half(mesh)), {.count = 7});
  const std::vector<double> beam = two_halves_omega(50.0, {thick, thin}, 4);
  for (int i = 0; i < 4; ++i) {
    double below = 0.0, above = 0.0;
    for (const PlateProperties& p : {thick, thin}) {
      const double k = std::pow(beam[i] * beam[i] * p.surface_mass() / p.bending_rigidity(), 0.25);
      below = std::max(
          below, 0.5 * std::pow(k * p.thickness, 2) / 12.0 * (1.0 + 2.0 / p.shear_correction));
      above = std::max(above, std::pow(2.0 * k, 4) / 480.0);
    }
    const double error = modes.omega[3 + i] / beam[i] - 1.0;
    EXPECT_GT(error, -1.1 * below) << i;
    EXPECT_LT(error, 1.1 * above) << i;
  }
}

// Constant curvature w = x²/2: M = -D on each side, D eight times as large where the plate is twice
// as thick
TEST(PlateRegions, MomentsJumpWhereTheyMeet) {
  const mesh::Q8Mesh mesh = test::rectangle_arrays(4, 2, 8.0, 4.0).build();
  PlateProperties thick = test::unit_plate(0.1, 0.3);
  thick.thickness = 0.2;
  const PlateRegions regions({test::unit_plate(0.1, 0.3), thick}, right_half(mesh));
  const VecXd bent = test::constant_curvature(mesh, 1.0, 0.0, 0.0);
  Index middle = 0;
  while (mesh.nodes().col(middle).norm() > 1e-12) ++middle;
  const std::vector<Index> nodes{middle};
  for (int region = 0; region < 2; ++region) {
    const VecXd forces = section_force_operator(mesh, regions, nodes, region) * bent;
    const double rigidity = regions[region].bending_rigidity();
    EXPECT_NEAR(forces[kBendingMomentX], -rigidity, 1e-10 * rigidity);
    EXPECT_NEAR(forces[kBendingMomentY], -0.3 * rigidity, 1e-10 * rigidity);
  }
  const MatXd both = section_forces(mesh, regions, bent);
  EXPECT_NEAR(both(5 * middle, 0), -0.5 * (1.0 + 8.0), 1e-9);
}

TEST(PlateRegions, RefuseSetsThatThereAreNot) {
  const PlateProperties p = test::table1_properties();
  EXPECT_THROW(PlateRegions({p, p}, {0, 1, 2}), InputError);
  EXPECT_THROW(PlateRegions({p}, {-1}), InputError);
  EXPECT_THROW(PlateRegions(std::vector<PlateProperties>{}, {}), InputError);
}

}  // namespace
}  // namespace floe::plate
