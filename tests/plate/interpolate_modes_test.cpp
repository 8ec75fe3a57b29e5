#include "expect.hpp"
#include "plates.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/dry_modes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace floe::plate {
namespace {

TEST(InterpolateModes, KeepEverythingOnTheSameMesh) {
  const mesh::Q8Mesh mesh = test::table1_mesh(20, 4);
  const DryModes modes = dry_modes(mesh, test::table1_properties());
  const DryModes same = interpolate_modes(modes, mesh, mesh);
  test::expect_all_close(same.shape, modes.shape, 1e-12);
  EXPECT_EQ(same.omega, modes.omega);
  EXPECT_EQ(same.modal_mass, modes.modal_mass);
  EXPECT_EQ(same.rigid_count, 3);
  EXPECT_EQ(same.estimated_frequency_error, modes.estimated_frequency_error);
}

// The Q8 functions hold linear fields, on distorted elements too
TEST(InterpolateModes, KeepRigidModesRigid) {
  const mesh::Q8Mesh plate = test::bent_rectangle(20, 4, 300.0, 60.0, 1.0).build();
  const mesh::Q8Mesh fluid = test::table1_mesh(50, 10);
  const DryModes modes = dry_modes(plate, test::table1_properties(), {.count = 3});
  const DryModes finer = interpolate_modes(modes, plate, fluid);
  for (int c = 0; c < 3; ++c) {
    const Eigen::Vector3d motion(c == 0 ? modes.shape(0, 0) : 0.0, c == 1 ? modes.shape(1, 1) : 0.0,
                                 c == 2 ? modes.shape(2, 2) : 0.0);
    const VecXd expected = test::nodal_values(fluid, [&](double x, double y) {
      return Eigen::Vector3d(motion[0] + motion[1] * y - motion[2] * x, motion[1], motion[2]);
    });
    // The centroid of a bent mesh with straight outline is that of the rectangle to rounding
    test::expect_all_close(finer.shape.col(c), expected, 1e-9);
  }
}

// Quadratic interpolation errs by up to (kh/2)³/9√3, 0.012 with the shortest wave here (k = 0.1)
// and h = 12 m, and by half of that in the mean
TEST(InterpolateModes, AreCloseToTheModesOfTheFinerMesh) {
  const PlateProperties properties = test::table1_properties();
  const mesh::Q8Mesh plate = test::table1_mesh(25, 5), fluid = test::table1_mesh(75, 15);
  const DryModes coarse = interpolate_modes(dry_modes(plate, properties), plate, fluid);
  const DryModes fine = dry_modes(fluid, properties);
  for (Index i = 0; i < 20; ++i) {
    const VecXd expected = fine.shape.col(i)(Eigen::seq(0, Eigen::last, 3));
    VecXd actual = coarse.shape.col(i)(Eigen::seq(0, Eigen::last, 3));
    if (actual.dot(expected) < 0.0) actual = -actual;
    EXPECT_LT(test::relative_error(actual, expected), 0.01) << i;
  }
}

TEST(InterpolateModes, RejectAFluidNodeOffThePlate) {
  const mesh::Q8Mesh plate = test::table1_mesh(20, 4);
  const DryModes modes = dry_modes(plate, test::table1_properties(), {.count = 3});
  const mesh::Q8Mesh wider = test::rectangle_arrays(50, 10, 300.0, 61.0).build();
  try {
    interpolate_modes(modes, plate, wider);
    FAIL() << "no error";
  } catch (const MeshError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("fluid node 0 at (-150, -30.5) m"));
  }
}

}  // namespace
}  // namespace floe::plate
