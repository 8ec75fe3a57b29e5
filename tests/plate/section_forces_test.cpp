#include "expect.hpp"
#include "plates.hpp"

#include <floe/plate/section_forces.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace floe::plate {
namespace {

// The same five forces at every node
MatXd everywhere(const mesh::Q8Mesh& mesh, const Eigen::Matrix<double, 5, 1>& forces) {
  return forces.replicate(mesh.node_count(), 1);
}

// A smooth deflection without shear strain; wavelengths of about 6 m by 9 m
VecXd smooth_field(const mesh::Q8Mesh& mesh) {
  return test::nodal_values(mesh, [](double x, double y) {
    return Eigen::Vector3d(std::sin(x + 0.3) * std::cos(0.7 * y + 0.2),
                           -0.7 * std::sin(x + 0.3) * std::sin(0.7 * y + 0.2),
                           -std::cos(x + 0.3) * std::cos(0.7 * y + 0.2));
  });
}

VecXd deflections(const VecXd& displacement) { return displacement(Eigen::seq(0, Eigen::last, 3)); }

TEST(identity_SectionForces, OfConstantCurvatureAreExact) {
  const mesh::Q8Mesh mesh = test::distorted_rectangle(6, 4, 12.0, 8.0, 0.3).build();
  for (const double thickness : {2.0, 2e-3}) {
    PlateProperties properties = test::table1_properties();
    properties.thickness = thickness;
    const double rigidity = properties.bending_rigidity(), nu = properties.poisson_ratio;
    const double a = 1.0, b = -0.5, c = 0.25;
    const MatXd forces = section_forces(mesh, properties, test::constant_curvature(mesh, a, b, c));
    const MatXd expected =
        everywhere(mesh, (Eigen::Matrix<double, 5, 1>() << -rigidity * (a + nu * c),
                          -rigidity * (c + nu * a), -rigidity * (1.0 - nu) * b, 0.0, 0.0)
                             .finished());
    // Shear forces from strains that cancel: rounding of κGt times the slopes, about 10
    const double rounding = 1e-14 * 10.0 * properties.shear_modulus() * thickness;
    test::expect_all_close(forces, expected, 1e-11, rounding);
  }
}

TEST(identity_SectionForces, OfConstantShearAreExact) {
  const mesh::Q8Mesh mesh = test::bent_rectangle(6, 4, 12.0, 8.0, 0.2).build();
  const PlateProperties properties = test::table1_properties();
  const VecXd shape = test::nodal_values(
      mesh, [](double x, double y) { return Eigen::Vector3d(2.0 * x - y, 0.0, 0.0); });
  const double shear = 5.0 / 6.0 * properties.shear_modulus() * properties.thickness;
  const MatXd expected = everywhere(
      mesh, (Eigen::Matrix<double, 5, 1>() << 0.0, 0.0, 0.0, 2.0 * shear, -shear).finished());
  test::expect_all_close(section_forces(mesh, properties, shape), expected, 1e-12);
}

TEST(identity_SectionForces, OfRigidMotionVanish) {
  const mesh::Q8Mesh mesh = test::ring_arrays(3.0, 6.0, 12, 2).build();
  const PlateProperties properties = test::table1_properties();
  const VecXd shape = test::nodal_values(
      mesh, [](double x, double y) { return Eigen::Vector3d(1.0 + 2.0 * y - 3.0 * x, 2.0, 3.0); });
  const double rounding = 1e-13 * properties.shear_modulus() * properties.thickness * 10.0;
  EXPECT_LT(section_forces(mesh, properties, shape).cwiseAbs().maxCoeff(), rounding);
}

TEST(twin_SectionForces, OfTheOperatorAreTheSame) {
  const mesh::Q8Mesh mesh = test::bent_rectangle(8, 5, 16.0, 10.0, 0.2).build();
  const PlateProperties properties = test::table1_properties();
  const VecXd shape = smooth_field(mesh);
  MatXd columns(shape.size(), 3);
  columns << shape, 2.0 * shape, shape.reverse();
  const MatXd forces = section_forces(mesh, properties, columns);
  const std::vector<Index> nodes{0, 7, mesh.node_count() - 1, 20, 7};
  const SparseMatrix matrix = section_force_operator(mesh, properties, nodes);
  ASSERT_EQ(matrix.rows(), 25);
  ASSERT_EQ(matrix.cols(), shape.size());
  const MatXd chosen = matrix * columns;
  for (Index k = 0; k < 5; ++k)
    test::expect_all_close(chosen.middleRows(5 * k, 5), forces.middleRows(5 * nodes[k], 5), 1e-12);
}

// Bilinear functions through four values: second order at nodes
TEST(order_SectionForces, ConvergeWithTheSecondOrder) {
  const PlateProperties properties = test::unit_plate(0.5, 0.3);
  const std::array<int, 3> elements{16, 32, 64};
  std::array<double, 3> side{}, moment_error{}, slope_error{};
  for (int level = 0; level < 3; ++level) {
    side[level] = 1.0 / elements[level];
    const mesh::Q8Mesh mesh =
        test::distorted_rectangle(elements[level], elements[level], 8.0, 8.0, 0.2).build();
    const VecXd displacement = smooth_field(mesh);
    const MatXd forces = section_forces(mesh, properties, displacement);
    const MatXd deflection = deflections(displacement);
    const MatXd slope_x = slope_operator(mesh, kSlopeX) * deflection;
    const MatXd slope_y = slope_operator(mesh, kSlopeY) * deflection;
    for (Index n = 0; n < mesh.node_count(); ++n) {
      // Mx = -(w,xx + ν w,yy) for a rigidity of 1
      const double moment = (1.0 + 0.3 * 0.49) * displacement[3 * n];
      moment_error[level] =
          std::max(moment_error[level], std::abs(forces(5 * n + kBendingMomentX, 0) - moment));
      slope_error[level] =
          std::max({slope_error[level], std::abs(slope_x(n, 0) + displacement[3 * n + 2]),
                    std::abs(slope_y(n, 0) - displacement[3 * n + 1])});
    }
  }
  EXPECT_GT(test::observed_order(side, moment_error), 1.8);
  EXPECT_GT(test::observed_order(side, slope_error), 1.8);
}

TEST(Slopes, OfQuadraticDeflectionsAreExactOnParallelograms) {
  const mesh::Q8Mesh mesh =
      test::mapped(test::rectangle_arrays(5, 4, 10.0, 8.0), [](const Point2& p) {
        return Point2(p.x() + 0.3 * p.y(), p.y());
      }).build();
  const VecXd displacement = test::constant_curvature(mesh, 1.0, -0.5, 0.25);
  const MatXd deflection = deflections(displacement);
  MatXd slope(mesh.node_count(), 2), expected(mesh.node_count(), 2);
  slope << slope_operator(mesh, kSlopeX) * deflection, slope_operator(mesh, kSlopeY) * deflection;
  for (Index n = 0; n < mesh.node_count(); ++n)
    expected.row(n) << -displacement[3 * n + 2], displacement[3 * n + 1];
  test::expect_all_close(slope, expected, 1e-12);
}

TEST(identity_SectionForces, AreTheSameBitsForAnyNumberOfThreads) {
  const mesh::Q8Mesh mesh = test::ring_arrays(30.0, 60.0, 48, 8).build();
  const VecXd displacement = smooth_field(mesh);
  const auto with = [&](int threads) {
    const test::ThreadCount count(threads);
    return section_forces(mesh, test::table1_properties(), displacement);
  };
  const MatXd one = with(1);
  for (const int threads : test::kThreadCounts) EXPECT_TRUE(one == with(threads)) << threads;
}

}  // namespace
}  // namespace floe::plate
