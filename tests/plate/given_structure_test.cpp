#include "expect.hpp"
#include "plates.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/given_structure.hpp>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe::plate {
namespace {

using testing::HasSubstr;

// Two pieces, one of them bent: 3 + 3 rigid modes
mesh::Q8Mesh two_plates() {
  return test::joined(test::bent_rectangle(6, 3, 60.0, 20.0, 0.5),
                      test::shifted(test::rectangle_arrays(4, 2, 40.0, 18.0), 0.0, 40.0))
      .build();
}

template <typename Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

std::string matrices_error(const mesh::Q8Mesh& mesh, const PlateMatrices& given) {
  return error_of([&] { static_cast<void>(dry_modes(mesh, given, {.count = 12})); });
}

// |C'| = |C| to 1e-7 of its largest: modes with separate frequencies keep their shape
void expect_same(const DryModes& found, const DryModes& expected) {
  ASSERT_EQ(found.count(), expected.count());
  EXPECT_EQ(found.rigid_count, expected.rigid_count);
  test::expect_all_close(found.omega, expected.omega, 1e-9);
  test::expect_all_close(found.modal_mass, expected.modal_mass, 1e-9);
  test::expect_all_close(found.shape, expected.shape, 1e-7);
}

TEST(twin_GivenStructure, ModesOfTheOwnMatricesAreThoseOfThePlate) {
  const mesh::Q8Mesh mesh = two_plates();
  const PlateProperties properties = test::table1_properties();
  expect_same(dry_modes(mesh, assemble_plate(mesh, properties), {.count = 16}),
              dry_modes(mesh, properties, {.count = 16}));
}

TEST(twin_GivenStructure, OwnModesInAnyOrderAndMixtureAreThoseOfThePlate) {
  const mesh::Q8Mesh mesh = two_plates();
  const PlateProperties properties = test::table1_properties();
  const DryModes own = dry_modes(mesh, properties, {.count = 16});
  // Mix the rigid modes by an orthogonal matrix, after making them orthonormal; turn the order
  GivenModes given{own.omega.reverse(), own.shape, {}};
  const MatXd mass = own.modal_mass.topLeftCorner(6, 6);
  MatXd orthonormal = MatXd::Identity(6, 6);
  mass.llt().matrixU().solveInPlace(orthonormal);
  const MatXd rotation = MatXd(MatXd::Random(6, 6).householderQr().householderQ());
  given.shape.leftCols(6) = own.shape.leftCols(6) * orthonormal * rotation;
  given.shape = given.shape.rowwise().reverse().eval();
  expect_same(dry_modes(mesh, given, 16), own);
  given.mass = assemble_plate(mesh, properties).mass;
  expect_same(dry_modes(mesh, given, 16), own);
}

TEST(GivenStructure, RefusesMatricesThatDoNotFit) {
  const mesh::Q8Mesh mesh = two_plates();
  const PlateMatrices good = assemble_plate(mesh, test::table1_properties());
  const Index size = good.mass.cols();
  EXPECT_EQ(matrices_error(mesh, good), "");

  PlateMatrices bad = good;
  bad.stiffness.conservativeResize(size - 3, size - 3);
  EXPECT_THAT(matrices_error(mesh, bad),
              HasSubstr("invalid plate.structure.stiffness of " + std::to_string(size - 3)));
  bad = good;
  bad.mass.coeffRef(3, 0) *= 1.001;
  EXPECT_THAT(matrices_error(mesh, bad), HasSubstr("plate.structure.mass: not symmetric"));
  bad = good;
  bad.mass.coeffRef(0, 0) = -1.0;
  EXPECT_THAT(matrices_error(mesh, bad), HasSubstr("the deflection of node 1 is -1 kg"));
  bad = good;
  bad.stiffness.coeffRef(0, 0) *= 1.01;
  EXPECT_THAT(matrices_error(mesh, bad), HasSubstr("it resists the heave of piece 1"));
  bad = good;
  bad.stiffness.coeffRef(0, size - 3) = 1.0;
  bad.stiffness.coeffRef(size - 3, 0) = 1.0;
  EXPECT_THAT(matrices_error(mesh, bad), HasSubstr("of another piece of the mesh"));
  bad = good;
  bad.stiffness *= -1.0;
  EXPECT_THAT(matrices_error(mesh, bad), HasSubstr("invalid plate.structure"));
  bad = good;
  bad.stiffness *= 0.0;
  EXPECT_THAT(matrices_error(mesh, bad), HasSubstr("invalid plate.structure"));
}

TEST(GivenStructure, RefusesAHinge) {
  // A plate of two halves that share the deflections along a line but not the rotation about it
  const mesh::Q8Mesh mesh = test::rectangle_arrays(4, 1, 40.0, 10.0).build();
  PlateProperties soft = test::table1_properties();
  soft.youngs_modulus *= 1e-14;
  std::vector<int> region(4, 0);
  region[1] = 1;
  const PlateMatrices plate =
      assemble_plate(mesh, PlateRegions({test::table1_properties(), soft}, region));
  EXPECT_THAT(error_of([&] { static_cast<void>(dry_modes(mesh, plate, {.count = 6})); }),
              HasSubstr("a motion besides the rigid ones has omega²"));
}

TEST(GivenStructure, RefusesModesThatDoNotFit) {
  const mesh::Q8Mesh mesh = two_plates();
  const DryModes own = dry_modes(mesh, test::table1_properties(), {.count = 12});
  const GivenModes good{own.omega, own.shape, {}};
  const auto error = [&](const GivenModes& given) {
    return error_of([&] { static_cast<void>(dry_modes(mesh, given, 8)); });
  };
  EXPECT_EQ(error(good), "");
  GivenModes bad = good;
  bad.shape.conservativeResize(own.shape.rows() - 3, Eigen::NoChange);
  EXPECT_THAT(error(bad), HasSubstr("invalid plate.structure.modes of " +
                                    std::to_string(own.shape.rows() - 3) + " rows"));
  bad = good;
  bad.omega.conservativeResize(11);
  EXPECT_THAT(error(bad), HasSubstr("of 11 frequencies (must be 12"));
  bad = good;
  bad.omega[2] = 1.0;
  EXPECT_THAT(error(bad), HasSubstr("the first 6 rise to"));
  bad = good;
  bad.shape.col(1) += 1e-3 * bad.shape.col(7);
  EXPECT_THAT(error(bad), HasSubstr("the first 6 differ from rigid motions"));
  bad = good;
  bad.shape.col(1) = bad.shape.col(0);
  EXPECT_THAT(error(bad), HasSubstr("differ from rigid motions"));
  bad = good;
  bad.mass = assemble_plate(mesh, test::table1_properties()).mass;
  bad.shape.col(7) *= 1.01;
  EXPECT_THAT(error(bad), HasSubstr("(must be 1 to 1e-6: mass-normalised"));
  EXPECT_THROW(dry_modes(mesh, good, 13), InputError);
}

}  // namespace
}  // namespace floe::plate
