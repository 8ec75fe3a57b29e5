#include "expect.hpp"
#include "plates.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace floe::plate {
namespace {

using test::MeshArrays;

VecXd stiffness_eigenvalues(const MeshArrays& arrays, const PlateProperties& properties) {
  const MatXd stiffness = assemble_plate(arrays.build(), properties).stiffness;
  const Eigen::SelfAdjointEigenSolver<MatXd> solver(stiffness, Eigen::EigenvaluesOnly);
  return solver.eigenvalues();
}

// Three eigenvalues at the level of rounding, the next far above it
void expect_three_zero_modes(const MeshArrays& arrays, const std::string& what) {
  // A plate as thick as an element is wide: shear and bending weigh alike
  const VecXd value = stiffness_eigenvalues(arrays, test::unit_plate(1.0, 0.3));
  const double largest = value.maxCoeff();
  EXPECT_LT(std::abs(value[2]), 1e-13 * largest) << what;
  EXPECT_GT(value[3], 1e-6 * largest) << what;
}

TEST(Mindlin, IsSymmetricToTheLastBit) {
  const PlateMatrices plate =
      assemble_plate(test::bent_rectangle(6, 4, 12.0, 8.0, 0.3).build(), test::table1_properties());
  const SparseMatrix stiffness = plate.stiffness.transpose(), mass = plate.mass.transpose();
  EXPECT_TRUE(test::same_bits(plate.stiffness, stiffness));
  EXPECT_TRUE(test::same_bits(plate.mass, mass));
}

TEST(Mindlin, HasTheMassAndTheRotaryInertiaOfThePlate) {
  const mesh::Q8Mesh mesh = test::distorted_rectangle(6, 4, 12.0, 8.0, 0.3).build();
  const PlateProperties properties = test::table1_properties();
  const PlateMatrices plate = assemble_plate(mesh, properties);
  const double mass = 256.25 * 2.0 * 96.0, rotary = mass * 2.0 * 2.0 / 12.0;
  for (int c = 0; c < 3; ++c) {
    VecXd ones = VecXd::Zero(plate.mass.cols());
    for (Index n = 0; n < mesh.node_count(); ++n) ones[3 * n + c] = 1.0;
    // The N_a sum to 1, so that the total is the area, exact with 3 × 3 points
    test::expect_close(ones.dot(plate.mass * ones), c == 0 ? mass : rotary, 1e-13);
  }
}

TEST(Mindlin, RejectsPropertiesThatNoPlateHas) {
  const mesh::Q8Mesh mesh = test::tiny_plate();
  const PlateProperties good = test::table1_properties();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    PlateProperties p = good;
    p.thickness = bad;
    EXPECT_THROW(assemble_plate(mesh, p), InputError) << bad;
    p = good;
    p.youngs_modulus = bad;
    EXPECT_THROW(assemble_plate(mesh, p), InputError) << bad;
    p = good;
    p.density = bad;
    EXPECT_THROW(assemble_plate(mesh, p), InputError) << bad;
    p = good;
    p.shear_correction = bad;
    EXPECT_THROW(assemble_plate(mesh, p), InputError) << bad;
  }
  for (const double bad : {-1.0, 0.51, nan}) {
    PlateProperties p = good;
    p.poisson_ratio = bad;
    EXPECT_THROW(assemble_plate(mesh, p), InputError) << bad;
  }
}

TEST(identity_Mindlin, RigidMotionMeetsNoForce) {
  for (const MeshArrays& arrays :
       {test::bent_rectangle(6, 4, 12.0, 8.0, 0.3), test::ring_arrays(3.0, 6.0, 12, 2)}) {
    const mesh::Q8Mesh mesh = arrays.build();
    const SparseMatrix stiffness = assemble_plate(mesh, test::table1_properties()).stiffness;
    for (const Eigen::Vector3d& motion :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
      const VecXd shape = test::nodal_values(mesh, [&](double x, double y) {
        return Eigen::Vector3d(motion[0] + motion[1] * y - motion[2] * x, motion[1], motion[2]);
      });
      const VecXd scale = stiffness.cwiseAbs() * shape.cwiseAbs();
      EXPECT_LT((stiffness * shape).cwiseAbs().maxCoeff(), 1e-14 * scale.maxCoeff());
    }
  }
}

TEST(identity_Mindlin, HasThreeZeroModesOnOneElement) {
  expect_three_zero_modes(test::rectangle_arrays(1, 1, 2.0, 2.0), "square");
  expect_three_zero_modes(test::rectangle_arrays(1, 1, 2.0, 0.5), "oblong");
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const MeshArrays bent = test::random_element(0.2, seed);
    expect_three_zero_modes(bent, "bent " + std::to_string(seed));
    expect_three_zero_modes(test::straightened(bent), "straight " + std::to_string(seed));
  }
}

TEST(identity_Mindlin, HasThreeZeroModesOnMeshes) {
  expect_three_zero_modes(test::rectangle_arrays(3, 2, 3.0, 2.0), "rectangle");
  expect_three_zero_modes(test::distorted_rectangle(4, 3, 4.0, 3.0, 0.25), "distorted");
  expect_three_zero_modes(test::bent_rectangle(4, 3, 4.0, 3.0, 0.15), "bent");
  expect_three_zero_modes(test::ring_arrays(1.0, 2.0, 8, 1), "ring");
  expect_three_zero_modes(test::l_shape(4.0, 2.0, 2), "L");
}

// The patch test of bending. Straight sides, but no side parallel to another: the elements cannot
// hold w, their shear strains must vanish all the same.
TEST(identity_Mindlin, ConstantCurvatureNeedsNoForceInside) {
  const mesh::Q8Mesh mesh = test::distorted_rectangle(6, 4, 12.0, 8.0, 0.3).build();
  const std::vector<bool> on_edge = test::edge_nodes(mesh);
  for (const double thickness : {2.0, 2e-3}) {
    PlateProperties properties = test::table1_properties();
    properties.thickness = thickness;
    const SparseMatrix stiffness = assemble_plate(mesh, properties).stiffness;
    const double nu = properties.poisson_ratio;
    for (const Eigen::Vector3d& k :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
      const VecXd shape = test::constant_curvature(mesh, k[0], k[1], k[2]);
      const VecXd force = stiffness * shape;
      const double rounding = 1e-14 * (stiffness.cwiseAbs() * shape.cwiseAbs()).maxCoeff();
      for (Index n = 0; n < mesh.node_count(); ++n)
        if (!on_edge[n]) {
          EXPECT_LT(force.segment<3>(3 * n).cwiseAbs().maxCoeff(), rounding);
        }
      const double energy =
          properties.bending_rigidity() * 96.0 *
          (k[0] * k[0] + k[2] * k[2] + 2.0 * nu * k[0] * k[2] + 2.0 * (1.0 - nu) * k[1] * k[1]);
      test::expect_close(shape.dot(force), energy, 1e-12, rounding * shape.cwiseAbs().maxCoeff());
    }
  }
}

// The patch test of shear: w linear without rotation gives γ constant, forces along w inside vanish
TEST(identity_Mindlin, ConstantShearNeedsNoForceAlongTheDeflectionInside) {
  const mesh::Q8Mesh mesh = test::distorted_rectangle(6, 4, 12.0, 8.0, 0.3).build();
  const std::vector<bool> on_edge = test::edge_nodes(mesh);
  const PlateProperties properties = test::table1_properties();
  const SparseMatrix stiffness = assemble_plate(mesh, properties).stiffness;
  const VecXd shape = test::nodal_values(
      mesh, [](double x, double y) { return Eigen::Vector3d(2.0 * x - y, 0.0, 0.0); });
  const VecXd force = stiffness * shape;
  const double rounding = 1e-14 * (stiffness.cwiseAbs() * shape.cwiseAbs()).maxCoeff();
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (!on_edge[n]) {
      EXPECT_NEAR(force[3 * n], 0.0, rounding);
    }
  const double shear =
      properties.shear_correction * properties.shear_modulus() * properties.thickness;
  test::expect_close(shape.dot(force), shear * 96.0 * 5.0, 1e-12);
}

TEST(identity_Mindlin, GivesTheSameBitsForAnyNumberOfThreads) {
  const mesh::Q8Mesh mesh = test::ring_arrays(30.0, 60.0, 48, 8).build();
  const auto assemble_with = [&](int threads) {
    const test::ThreadCount count(threads);
    return assemble_plate(mesh, test::table1_properties());
  };
  const PlateMatrices one = assemble_with(1);
  for (const int threads : test::kThreadCounts) {
    const PlateMatrices many = assemble_with(threads);
    EXPECT_TRUE(test::same_bits(one.stiffness, many.stiffness)) << threads;
    EXPECT_TRUE(test::same_bits(one.mass, many.mass)) << threads;
  }
}

}  // namespace
}  // namespace floe::plate
