#include "expect.hpp"
#include "plate/elastic_modes.hpp"
#include "plate/piece_modes.hpp"
#include "plates.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/dry_modes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace floe::plate {
namespace {

// CᵀMC and CᵀKC as the docstring promises them
void expect_normal_modes(const mesh::Q8Mesh& mesh, const PlateProperties& properties,
                         const DryModes& modes, double tolerance = 1e-9) {
  const PlateMatrices plate = assemble_plate(mesh, properties);
  const MatXd mass = modes.shape.transpose() * (plate.mass * modes.shape);
  test::expect_all_close(modes.modal_mass, mass, 1e-11);
  const Index elastic = modes.count() - modes.rigid_count;
  test::expect_all_close(mass.bottomRightCorner(elastic, elastic),
                         MatXd::Identity(elastic, elastic), 1e-11);
  EXPECT_LT(mass.topRightCorner(modes.rigid_count, elastic).cwiseAbs().maxCoeff(), 1e-11);
  const MatXd stiffness = modes.shape.transpose() * (plate.stiffness * modes.shape);
  const VecXd expected = modes.omega.cwiseAbs2();
  // Unless asked otherwise, rounding: eps times the largest of K over M, 1e7 times that of the
  // modes
  test::expect_all_close(stiffness, MatXd(expected.asDiagonal()), tolerance);
}

// The elastic ones, by a dense solution
VecXd dense_frequencies(const mesh::Q8Mesh& mesh, const PlateProperties& properties, Index count) {
  const Piece piece = split_pieces(mesh).front();
  const PlateMatrices plate = assemble_plate(mesh, properties);
  const MatXd rigid = rigid_modes(piece.nodes, area_moments(piece).centroid, NodeMass(plate.mass));
  return dense_elastic_modes(plate, 1.0, rigid, count).value.cwiseSqrt();
}

TEST(DryModes, AreMassOrthonormalAndDiagonaliseTheStiffness) {
  for (const test::MeshArrays& arrays :
       {test::rectangle_arrays(50, 10, 300.0, 60.0), test::ring_arrays(90.0, 150.0, 48, 6),
        test::bent_rectangle(25, 5, 300.0, 60.0, 2.0)}) {
    const mesh::Q8Mesh mesh = arrays.build();
    expect_normal_modes(mesh, test::table1_properties(),
                        dry_modes(mesh, test::table1_properties()));
  }
}

TEST(DryModes, BeginWithHeaveRollAndPitchAboutTheCentroid) {
  const mesh::Q8Mesh mesh = test::shifted(test::l_shape(60.0, 20.0, 2), 1000.0, -500.0).build();
  const PlateProperties properties = test::table1_properties();
  const DryModes modes = dry_modes(mesh, properties, {.count = 5});
  // The L is the square less a square of 40 m at its upper right
  const double area = 2000.0, x = 1000.0 - 16.0, y = -500.0 - 16.0;
  const double scale = 1.0 / std::sqrt(properties.surface_mass() * area);
  const double centre = (0.0 * 3600.0 - 10.0 * 1600.0) / area;
  ASSERT_NEAR(centre, -8.0, 1e-12);
  for (Index n = 0; n < mesh.node_count(); ++n) {
    const double dx = mesh.nodes()(0, n) - (x + 8.0), dy = mesh.nodes()(1, n) - (y + 8.0);
    test::expect_all_close(modes.shape.block<3, 1>(3 * n, 0), Eigen::Vector3d(scale, 0.0, 0.0),
                           1e-12);
    const double roll = modes.shape(3 * n + 1, 1), pitch = modes.shape(3 * n + 2, 2);
    test::expect_all_close(modes.shape.block<3, 1>(3 * n, 1), Eigen::Vector3d(roll * dy, roll, 0.0),
                           1e-11, 1e-15);
    test::expect_all_close(modes.shape.block<3, 1>(3 * n, 2),
                           Eigen::Vector3d(-pitch * dx, 0.0, pitch), 1e-11, 1e-15);
  }
  // Unmixed: they couple, as ∫xy dS < 0 and pitch turns x down
  EXPECT_GT(modes.modal_mass(1, 2), 0.1);
  EXPECT_NEAR(modes.modal_mass(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(modes.modal_mass(0, 2), 0.0, 1e-12);
}

TEST(DryModes, TurnTheLargestDeflectionUp) {
  const DryModes modes = dry_modes(test::table1_mesh(25, 5), test::table1_properties());
  for (Index i = 3; i < modes.count(); ++i) {
    const VecXd w = modes.shape.col(i)(Eigen::seq(0, Eigen::last, 3));
    EXPECT_GE(w.maxCoeff(), (1.0 - 2e-6) * -w.minCoeff()) << i;
  }
}

TEST(DryModes, OfSeveralPiecesAreThoseOfEachPieceInOrder) {
  const test::MeshArrays first = test::rectangle_arrays(10, 4, 100.0, 40.0);
  const test::MeshArrays other = test::rectangle_arrays(8, 4, 70.0, 40.0);
  const mesh::Q8Mesh mesh = test::joined(test::joined(first, test::shifted(first, 0.0, 50.0)),
                                         test::shifted(other, 0.0, 100.0))
                                .build();
  const PlateProperties properties = test::table1_properties();
  const DryModes modes = dry_modes(mesh, properties, {.count = 30});
  ASSERT_EQ(modes.rigid_count, 9);
  EXPECT_EQ(modes.omega.head(9).cwiseAbs().maxCoeff(), 0.0);
  expect_normal_modes(mesh, properties, modes);

  const DryModes of_first = dry_modes(first.build(), properties, {.count = 24});
  const DryModes of_other = dry_modes(other.build(), properties, {.count = 24});
  std::vector<double> expected;
  for (int i = 3; i < 24; ++i) {
    expected.push_back(of_first.omega[i]);
    expected.push_back(of_first.omega[i]);
    expected.push_back(of_other.omega[i]);
  }
  std::sort(expected.begin(), expected.end());
  for (int i = 9; i < 30; ++i) test::expect_close(modes.omega[i], expected[i - 9], 1e-9);

  // Each lives on one piece, and a rigid one on the piece of its number
  for (Index i = 0; i < modes.count(); ++i) {
    std::vector<double> largest(3, 0.0);
    for (Index n = 0; n < mesh.node_count(); ++n)
      largest[mesh.node_piece()[n]] =
          std::max(largest[mesh.node_piece()[n]], std::abs(modes.shape(3 * n, i)));
    EXPECT_EQ(std::count(largest.begin(), largest.end(), 0.0), 2) << i;
    if (i < 9) {
      EXPECT_GT(largest[i / 3], 0.0);
    }
  }
}

TEST(DryModes, KeepAPieceThatIsOneElement) {
  const mesh::Q8Mesh mesh =
      test::joined(test::rectangle_arrays(1, 1, 10.0, 10.0),
                   test::shifted(test::rectangle_arrays(12, 4, 60.0, 20.0), 0.0, 30.0))
          .build();
  const DryModes modes = dry_modes(mesh, test::table1_properties(), {.count = 40});
  EXPECT_EQ(modes.count(), 40);
  expect_normal_modes(mesh, test::table1_properties(), modes);
}

TEST(DryModes, RejectACountThatCannotBe) {
  const mesh::Q8Mesh mesh = test::tiny_plate();
  const Index half = 3 * mesh.node_count() / 2;
  EXPECT_THROW(dry_modes(mesh, test::table1_properties(), {.count = 2}), InputError);
  EXPECT_THROW(dry_modes(mesh, test::table1_properties(), {.count = static_cast<int>(half) + 1}),
               InputError);
  EXPECT_EQ(dry_modes(mesh, test::table1_properties(), {.count = 3}).count(), 3);
  EXPECT_EQ(dry_modes(mesh, test::table1_properties(), {.count = static_cast<int>(half)}).count(),
            half);
}

TEST(DryModes, SayHowManyConvergedWhenSomeDidNot) {
  try {
    dry_modes(test::table1_mesh(50, 10), test::table1_properties(), {.max_restarts = 0});
    FAIL() << "no error";
  } catch (const ConvergenceError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("dry modes converged = 0 of 27 elastic modes"));
  }
}

// The ratio of its eigenvalues is 1e7: rounding along the lowest modes must not count as a residual
TEST(identity_DryModes, OfALongPlateConverge) {
  const mesh::Q8Mesh mesh = test::rectangle_arrays(60, 2, 2400.0, 40.0).build();
  const DryModes modes = dry_modes(mesh, test::table1_properties(), {.count = 120});
  test::expect_all_close(modes.omega.tail(117),
                         dense_frequencies(mesh, test::table1_properties(), 117), 1e-6);
}

TEST(DryModes, RefuseAPencilThatIsNotDefinite) {
  const PlateMatrices plate = assemble_plate(test::tiny_plate(), test::table1_properties());
  EXPECT_THROW(ShiftedFactor(plate, -1e3), ConvergenceError);
}

// A Krylov space from one start vector holds one copy of each; others come by rounding, or not at
// all. The square has many pairs. These counts are among those where the first search leaves one
// out (24 of 450 on meshes like this).
TEST(identity_DryModes, KeepAllCopiesOfMultipleModes) {
  const mesh::Q8Mesh mesh = test::rectangle_arrays(12, 12, 100.0, 100.0).build();
  PlateProperties properties = test::table1_properties();
  properties.poisson_ratio = 0.3;
  const VecXd expected = dense_frequencies(mesh, properties, 60);
  int pairs = 0;
  for (int i = 1; i < 60; ++i)
    if (expected[i] - expected[i - 1] < 1e-7 * expected[i]) ++pairs;
  EXPECT_GE(pairs, 12);
  for (const int count : {19, 24, 25, 26, 46, 56}) {
    const DryModes modes = dry_modes(mesh, properties, {.count = count, .tolerance = 1e-6});
    test::expect_all_close(modes.omega.tail(count - 3), expected.head(count - 3), 1e-8, 0.0,
                           std::to_string(count));
    expect_normal_modes(mesh, properties, modes, 1e-6);
  }
}

TEST(twin_DryModes, OfLanczosAreThoseOfTheDenseSolution) {
  for (const double thickness : {2.0, 0.05}) {
    PlateProperties properties = test::table1_properties();
    properties.thickness = thickness;
    const mesh::Q8Mesh mesh = test::bent_rectangle(15, 6, 100.0, 40.0, 0.5).build();
    ASSERT_GT(3 * mesh.node_count(), 600);  // else dry_modes is dense itself
    const DryModes modes = dry_modes(mesh, properties, {.count = 40});
    test::expect_all_close(modes.omega.tail(37), dense_frequencies(mesh, properties, 37), 1e-8);
  }
}

TEST(identity_DryModes, GiveTheSameBitsForAnyNumberOfThreads) {
  const mesh::Q8Mesh mesh = test::bent_rectangle(50, 10, 300.0, 60.0, 1.0).build();
  const auto with = [&](int threads) {
    const test::ThreadCount count(threads);
    return dry_modes(mesh, test::table1_properties());
  };
  const DryModes one = with(1);
  for (const int threads : test::kThreadCounts) {
    const DryModes many = with(threads);
    EXPECT_TRUE(one.omega == many.omega && one.shape == many.shape &&
                one.modal_mass == many.modal_mass &&
                one.estimated_frequency_error == many.estimated_frequency_error)
        << threads;
  }
}

// Large enough that the vector operations of the iteration are shared between threads, too
TEST(identity_DryModesLong, GiveTheSameBitsForAnyNumberOfThreads) {
  const mesh::Q8Mesh mesh = test::table1_mesh(345, 69);
  ASSERT_GT(3 * mesh.node_count(), 200000);
  const auto with = [&](int threads) {
    const test::ThreadCount count(threads);
    return dry_modes(mesh, test::table1_properties(), {.count = 12});
  };
  const DryModes one = with(1), three = with(3);
  EXPECT_TRUE(one.omega == three.omega && one.shape == three.shape);
}

}  // namespace
}  // namespace floe::plate
