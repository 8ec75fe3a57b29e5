#include <floe/numeric/error.hpp>
#include <floe/plate/body_dofs.hpp>
#include <floe/plate/mindlin.hpp>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace floe::plate {
namespace {

constexpr std::array<const char*, 6> kRigidNames = {"Surge", "Sway",  "Heave",
                                                    "Roll",  "Pitch", "Yaw"};
constexpr int kHeave = 3;  // heave, roll, pitch follow each other
constexpr int kYaw = 6;

// Names that no other name contains: readers look for bodies by parts of names
std::vector<std::string> body_names(int count) {
  if (count == 1) return {"plate"};
  const std::size_t digits = std::to_string(count).size();
  std::vector<std::string> names;
  for (int b = 1; b <= count; ++b) {
    const std::string number = std::to_string(b);
    names.push_back("plate_" + std::string(digits - number.size(), '0') + number);
  }
  return names;
}

// Nodes of a body and what the modes do there
struct BodyNodes {
  std::vector<Index> node;
  Points2 position;
  MatXd deflection;  // w of all modes at these nodes
};

std::vector<BodyNodes> bodies_of(const mesh::Q8Mesh& mesh, const DryModes& modes) {
  const int count = modes.rigid_count / 3;
  FLOE_VALIDATE(modes.rigid_count == 3 * count && (count == 1 || count == mesh.piece_count()),
                "invalid count of rigid modes = " << modes.rigid_count
                                                  << " (must be three, or three a piece)");
  std::vector<BodyNodes> bodies(static_cast<std::size_t>(count));
  for (Index n = 0; n < mesh.node_count(); ++n)
    bodies[count == 1 ? 0 : static_cast<std::size_t>(mesh.node_piece()[n])].node.push_back(n);
  for (BodyNodes& body : bodies) {
    body.position = mesh.nodes()(Eigen::all, body.node);
    std::vector<Index> rows = body.node;
    for (Index& row : rows) row *= kUnknownsPerNode;
    body.deflection = modes.shape(rows, Eigen::all);
  }
  return bodies;
}

// Heave, roll and pitch by one unit about `centre`, as sums of the body's rigid modes, 3 × 3
Eigen::Matrix3d rigid_motion(const BodyNodes& body, Index first, const Point2& centre) {
  MatXd unit(body.position.cols(), 3);
  unit.col(0).setOnes();
  unit.col(1) = body.position.row(1).transpose().array() - centre.y();
  unit.col(2) = centre.x() - body.position.row(0).transpose().array();
  const MatXd rigid = body.deflection.middleCols(first, 3);
  Eigen::Matrix3d motion = rigid.colPivHouseholderQr().solve(unit);
  const double error = (rigid * motion - unit).cwiseAbs().maxCoeff();
  FLOE_VALIDATE(error <= 1e-6 * unit.cwiseAbs().maxCoeff(),
                "invalid modes " << first + 1 << " to " << first + 3 << ": deflection " << error
                                 << " m besides heave, roll and pitch (must be rigid motions)");
  // NOTE: what is zero in theory is set to zero, or readers would see couplings of 1e-16
  const VecXd size = rigid.colwise().norm();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(motion(i, j)) * size[i] < 1e-12 * unit.col(j).norm()) motion(i, j) = 0.0;
  return motion;
}

// From the mass that couples heave to rotations about the middle of the body
Point2 centre_of_mass(const BodyNodes& body, Index first, const MatXd& modal_mass) {
  const Point2 lower = body.position.rowwise().minCoeff(),
               upper = body.position.rowwise().maxCoeff();
  const Point2 middle = 0.5 * (lower + upper);
  const Eigen::Matrix3d motion = rigid_motion(body, first, middle);
  const Eigen::Matrix3d mass = motion.transpose() * modal_mass.block<3, 3>(first, first) * motion;
  Point2 centre = middle + Point2(-mass(0, 2), mass(0, 1)) / mass(0, 0);
  for (double& coordinate : centre)
    if (std::abs(coordinate) < 1e-12 * (upper - lower).norm()) coordinate = 0.0;
  return centre;
}

// The body that an elastic mode moves; -1: several
int owner_of(const std::vector<BodyNodes>& bodies, Index mode) {
  std::vector<double> largest;
  for (const BodyNodes& body : bodies)
    largest.push_back(body.deflection.col(mode).cwiseAbs().maxCoeff());
  const auto most = std::max_element(largest.begin(), largest.end());
  const auto moved =
      std::count_if(largest.begin(), largest.end(), [&](double w) { return w > 1e-9 * *most; });
  return moved > 1 ? -1 : static_cast<int>(most - largest.begin());
}

std::vector<BodyDof> list_dofs(const std::vector<BodyNodes>& bodies, const DryModes& modes,
                               DofSet set) {
  std::vector<BodyDof> elastic;
  if (set != DofSet::kSixRigid)
    for (Index i = modes.rigid_count; i < modes.count(); ++i)
      elastic.push_back({owner_of(bodies, i), 0, i, "Elastic_" + std::to_string(i + 1)});

  std::vector<BodyDof> dofs;
  const int first = set == DofSet::kPlate ? kHeave : 1, last = set == DofSet::kPlate ? 5 : kYaw;
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
    for (int r = first; r <= last; ++r) dofs.push_back({b, r, -1, kRigidNames[r - 1]});
    if (set == DofSet::kSixAndElastic)
      std::copy_if(elastic.begin(), elastic.end(), std::back_inserter(dofs),
                   [&](const BodyDof& dof) { return dof.body == b; });
  }
  std::copy_if(elastic.begin(), elastic.end(), std::back_inserter(dofs),
               [&](const BodyDof& dof) { return set == DofSet::kPlate || dof.body < 0; });
  return dofs;
}

// Surge and sway have the body's mass, yaw its moment about the vertical through the centre:
// ∫ρt (x² + y²), that is roll and pitch without twice the rotary inertia ∫ρt³/12
void add_inertia_in_plane(const VecXd& rotary_inertia, BodyDofs& dofs) {
  for (Index i = 0; i < dofs.count(); ++i) {
    const BodyDof& dof = dofs.dof[static_cast<std::size_t>(i)];
    if (dof.rigid == 0) continue;
    const double mass = dofs.mass[dof.body];
    const double rotary = dofs.mass.size() == 1 ? rotary_inertia.sum() : rotary_inertia[dof.body];
    if (dof.rigid < kHeave) dofs.inertia(i, i) = mass;
    if (dof.rigid == kYaw)
      dofs.inertia(i, i) = dofs.inertia(i - 1, i - 1) + dofs.inertia(i - 2, i - 2) - 2.0 * rotary;
  }
}

}  // namespace

BodyDofs body_dofs(const mesh::Q8Mesh& mesh, const DryModes& modes, DofSet set) {
  // Find the bodies and their rigid motions
  const std::vector<BodyNodes> bodies = bodies_of(mesh, modes);
  const auto count = static_cast<Index>(bodies.size());
  BodyDofs dofs;
  dofs.body = body_names(static_cast<int>(count));
  dofs.centre.resize(2, count);
  dofs.mass.resize(count);
  std::vector<Eigen::Matrix3d> rigid;
  for (Index b = 0; b < count; ++b) {
    const BodyNodes& body = bodies[static_cast<std::size_t>(b)];
    dofs.centre.col(b) = centre_of_mass(body, 3 * b, modes.modal_mass);
    rigid.push_back(rigid_motion(body, 3 * b, dofs.centre.col(b)));
    const Eigen::Vector3d heave = rigid.back().col(0);
    dofs.mass[b] = heave.dot(modes.modal_mass.block<3, 3>(3 * b, 3 * b) * heave);
  }

  // Say each degree of freedom in modes, and back
  dofs.dof = list_dofs(bodies, modes, set);
  dofs.motion = MatXd::Zero(modes.count(), dofs.count());
  dofs.amplitude = MatXd::Zero(dofs.count(), modes.count());
  dofs.stiffness = VecXd::Zero(dofs.count());
  for (Index j = 0; j < dofs.count(); ++j) {
    const BodyDof& dof = dofs.dof[static_cast<std::size_t>(j)];
    const int place = dof.rigid - kHeave;
    if (dof.rigid == 0) {
      dofs.motion(dof.mode, j) = dofs.amplitude(j, dof.mode) = 1.0;
      dofs.stiffness[j] = modes.omega[dof.mode] * modes.omega[dof.mode];
    } else if (place >= 0 && place < 3) {
      const Eigen::Matrix3d& motion = rigid[static_cast<std::size_t>(dof.body)];
      dofs.motion.block<3, 1>(3 * dof.body, j) = motion.col(place);
      dofs.amplitude.block<1, 3>(j, 3 * dof.body) = motion.inverse().row(place);
    }
  }
  dofs.inertia = dofs.motion.transpose() * modes.modal_mass * dofs.motion;
  add_inertia_in_plane(modes.rotary_inertia, dofs);
  return dofs;
}

}  // namespace floe::plate
