#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/body_dofs.hpp>
#include <floe/plate/given_structure.hpp>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace floe::plate {
namespace {

using testing::ElementsAre;

const PlateProperties kPlate{.thickness = 2.0,
                             .youngs_modulus = 1.19e10,
                             .poisson_ratio = 0.13,
                             .density = 256.25,
                             .shear_correction = 5.0 / 6.0,
                             .loss_factor = 0.0};

// A rectangle with one corner at the origin, so that its centre is elsewhere
mesh::Q8Mesh shifted_rectangle(double length, double width) {
  const mesh::Q8Mesh centred =
      mesh::make_rectangle({.length = length, .width = width, .nx = 6, .ny = 3, .grading = 1.0});
  Points2 nodes = centred.nodes();
  nodes.colwise() += Point2(0.5 * length, 0.5 * width);
  return mesh::Q8Mesh(nodes, centred.elements());
}

std::vector<std::string> names(const BodyDofs& dofs) {
  std::vector<std::string> list;
  for (const BodyDof& dof : dofs.dof) list.push_back(dof.name);
  return list;
}

TEST(BodyDofs, AreUnitMotionsAboutTheCentreOfMass) {
  const mesh::Q8Mesh mesh = shifted_rectangle(60.0, 20.0);
  const DryModes modes = dry_modes(mesh, kPlate, {.count = 5});
  const BodyDofs dofs = body_dofs(mesh, modes, DofSet::kPlate);
  EXPECT_THAT(names(dofs), ElementsAre("Heave", "Roll", "Pitch", "Elastic_4", "Elastic_5"));
  EXPECT_NEAR(dofs.centre(0, 0), 30.0, 1e-10);
  EXPECT_NEAR(dofs.centre(1, 0), 10.0, 1e-10);
  const MatXd shape = modes.shape * dofs.motion;
  for (Index n = 0; n < mesh.node_count(); ++n) {
    const double x = mesh.nodes()(0, n), y = mesh.nodes()(1, n);
    EXPECT_NEAR(shape(3 * n, 0), 1.0, 1e-12);
    EXPECT_NEAR(shape(3 * n, 1), y - 10.0, 1e-10);
    EXPECT_NEAR(shape(3 * n, 2), 30.0 - x, 1e-10);
    EXPECT_NEAR(shape(3 * n + 1, 1), 1.0, 1e-12);  // roll turns about +x
    EXPECT_NEAR(shape(3 * n + 2, 2), 1.0, 1e-12);  // pitch about +y
  }
  EXPECT_EQ(shape.rightCols(2), modes.shape.rightCols(2));
}

// Of a box: m, m (B² + t²)/12, m (L² + t²)/12, m (L² + B²)/12
TEST(BodyDofs, HaveTheInertiaOfABox) {
  const mesh::Q8Mesh mesh = shifted_rectangle(60.0, 20.0);
  const DryModes modes = dry_modes(mesh, kPlate, {.count = 4});
  const BodyDofs dofs = body_dofs(mesh, modes, DofSet::kSixAndElastic);
  EXPECT_THAT(names(dofs),
              ElementsAre("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw", "Elastic_4"));
  const double mass = 256.25 * 2.0 * 60.0 * 20.0;
  const VecXd expected = (VecXd(7) << mass, mass, mass, mass * (400.0 + 4.0) / 12.0,
                          mass * (3600.0 + 4.0) / 12.0, mass * (3600.0 + 400.0) / 12.0, 1.0)
                             .finished();
  for (Index i = 0; i < 7; ++i)
    EXPECT_NEAR(dofs.inertia(i, i) / expected[i], 1.0, 1e-11) << names(dofs)[i];
  EXPECT_NEAR(dofs.mass[0] / mass, 1.0, 1e-11);
  EXPECT_EQ(dofs.stiffness.head(6), VecXd::Zero(6));
  EXPECT_EQ(dofs.stiffness[6], modes.omega[3] * modes.omega[3]);
  for (const Index in_plane : {0, 1, 5}) EXPECT_EQ(dofs.motion.col(in_plane).norm(), 0.0);
}

// Of two boxes side by side, of other thickness and density: about their common centre of mass
// m (a² + b²)/12 + m d² each. Yaw feels no thickness; roll and pitch do
TEST(BodyDofs, HaveTheInertiaOfTwoBoxesWherePropertiesDiffer) {
  const mesh::Q8Mesh mesh = shifted_rectangle(60.0, 20.0);
  PlateProperties other = kPlate;
  other.thickness = 4.0;
  other.density = 400.0;
  std::vector<int> region;
  for (Index e = 0; e < mesh.element_count(); ++e)
    region.push_back(mesh.element_nodes(e).row(0).mean() > 30.0 ? 1 : 0);
  const DryModes modes = dry_modes(mesh, PlateRegions({kPlate, other}, region), {.count = 4});
  const BodyDofs dofs = body_dofs(mesh, modes, DofSet::kSixRigid);
  const double left = 256.25 * 2.0 * 600.0, right = 400.0 * 4.0 * 600.0;
  const double centre = (left * 15.0 + right * 45.0) / (left + right);
  EXPECT_NEAR(dofs.centre(0, 0), centre, 1e-9);
  const double apart = left * std::pow(15.0 - centre, 2) + right * std::pow(45.0 - centre, 2);
  const double yaw = (left + right) * (900.0 + 400.0) / 12.0 + apart;
  EXPECT_NEAR(dofs.inertia(5, 5), yaw, 1e-10 * yaw);
  const double roll = left * (400.0 + 4.0) / 12.0 + right * (400.0 + 16.0) / 12.0;
  EXPECT_NEAR(dofs.inertia(3, 3), roll, 1e-10 * roll);

  // K and M of the same plate, or its modes beside M, say the same; modes alone leave the thickness
  // out: 2 ∫ρt³/12 more
  const PlateMatrices matrices = assemble_plate(mesh, PlateRegions({kPlate, other}, region));
  MatXd shape = modes.shape;  // rigid modes that no mass couples, as another program has them
  const Eigen::Matrix3d coupled = modes.modal_mass.topLeftCorner<3, 3>();
  shape.leftCols(3) *= coupled.llt().matrixU().solve(Eigen::Matrix3d::Identity()).eval();
  const GivenModes with_mass{modes.omega, shape, matrices.mass};
  for (const DryModes& given :
       {dry_modes(mesh, matrices, {.count = 4}), dry_modes(mesh, with_mass, 4)})
    EXPECT_NEAR(body_dofs(mesh, given, DofSet::kSixRigid).inertia(5, 5), yaw, 1e-8 * yaw);
  const DryModes alone = dry_modes(mesh, GivenModes{modes.omega, shape, {}}, 4);
  const double rotary = (left * 4.0 + right * 16.0) / 12.0;
  EXPECT_NEAR(body_dofs(mesh, alone, DofSet::kSixRigid).inertia(5, 5), yaw + 2.0 * rotary,
              1e-8 * yaw);
}

// amplitude is the inverse of motion on everything that moves out of the plane
TEST(BodyDofs, TellModalAmplitudesAndBack) {
  const mesh::Q8Mesh mesh = shifted_rectangle(60.0, 20.0);
  const DryModes modes = dry_modes(mesh, kPlate, {.count = 5});
  const BodyDofs dofs = body_dofs(mesh, modes, DofSet::kPlate);
  EXPECT_LT((dofs.motion * dofs.amplitude - MatXd::Identity(5, 5)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((dofs.amplitude * dofs.motion - MatXd::Identity(5, 5)).cwiseAbs().maxCoeff(), 1e-12);
}

// Modes of another program may mix the rigid motions
TEST(BodyDofs, FindTheMotionsInRigidModesThatAreMixed) {
  const mesh::Q8Mesh mesh = shifted_rectangle(60.0, 20.0);
  DryModes modes = dry_modes(mesh, kPlate, {.count = 4});
  const BodyDofs plain = body_dofs(mesh, modes, DofSet::kPlate);
  const MatXd unmixed = modes.shape;
  const Eigen::Matrix3d mix =
      (Eigen::Matrix3d() << 0.8, -0.6, 0.0, 0.48, 0.64, -0.6, 0.36, 0.48, 0.8).finished();
  modes.shape.leftCols(3) = (modes.shape.leftCols(3) * mix).eval();
  modes.modal_mass.topLeftCorner(3, 3) =
      (mix.transpose() * modes.modal_mass.topLeftCorner(3, 3) * mix).eval();
  const BodyDofs mixed = body_dofs(mesh, modes, DofSet::kPlate);
  EXPECT_LT((mixed.centre - plain.centre).norm(), 1e-9);
  EXPECT_LT((modes.shape * mixed.motion - unmixed * plain.motion).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((mixed.inertia - plain.inertia).cwiseAbs().maxCoeff(),
            1e-11 * plain.inertia.cwiseAbs().maxCoeff());
}

TEST(BodyDofs, RefuseRigidModesThatBend) {
  const mesh::Q8Mesh mesh = shifted_rectangle(60.0, 20.0);
  DryModes modes = dry_modes(mesh, kPlate, {.count = 4});
  modes.shape.col(2) = modes.shape.col(3);
  EXPECT_THROW(body_dofs(mesh, modes, DofSet::kPlate), InputError);
}

// Eleven plates: no name is a part of another
TEST(BodyDofs, NameManyBodiesApart) {
  const mesh::Q8Mesh one =
      mesh::make_rectangle({.length = 10.0, .width = 8.0, .nx = 2, .ny = 2, .grading = 1.0});
  const Index count = 11, n = one.node_count(), e = one.element_count();
  Points2 nodes(2, count * n);
  mesh::Connectivity elements(8, count * e);
  for (Index p = 0; p < count; ++p) {
    nodes.middleCols(p * n, n) = one.nodes();
    nodes.middleCols(p * n, n).row(0).array() += 20.0 * static_cast<double>(p);
    elements.middleCols(p * e, e) = one.elements().array() + p * n;
  }
  const mesh::Q8Mesh mesh(nodes, elements);
  const DryModes modes = dry_modes(mesh, kPlate, {.count = 44});
  const BodyDofs dofs = body_dofs(mesh, modes, DofSet::kSixAndElastic);
  EXPECT_EQ(dofs.body.front(), "plate_01");
  EXPECT_EQ(dofs.body.back(), "plate_11");
  EXPECT_EQ(dofs.count(), 11 * 6 + 11);
  int last = 0;
  for (const BodyDof& dof : dofs.dof) {  // body by body
    EXPECT_GE(dof.body, last);
    last = dof.body;
  }
  for (int b = 0; b < 11; ++b) EXPECT_NEAR(dofs.centre(0, b), 20.0 * b, 1e-9);
}

}  // namespace
}  // namespace floe::plate
