#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/plate/section_forces.hpp>
#include <floe/response/modal_basis.hpp>

#include <algorithm>

namespace floe::response {
namespace {

// Row of the section forces that a quantity needs
int section_row(Quantity quantity) {
  switch (quantity) {
    case Quantity::kBendingMomentX:
    case Quantity::kSurfaceStressX:
      return plate::kBendingMomentX;
    case Quantity::kBendingMomentY:
    case Quantity::kSurfaceStressY:
      return plate::kBendingMomentY;
    case Quantity::kTwistingMoment:
      return plate::kTwistingMoment;
    case Quantity::kShearForceX:
      return plate::kShearForceX;
    default:
      return plate::kShearForceY;
  }
}

// Every `stride`-th row from `first`
MatXd strided_rows(const MatXd& matrix, Index first, Index stride) {
  return matrix(Eigen::seq(first, Eigen::last, stride), Eigen::all);
}

// Nodes that an interpolation reads, rising
std::vector<Index> nodes_read(const SparseMatrix& interpolation) {
  std::vector<Index> nodes;
  for (Index node = 0; node < interpolation.cols(); ++node)
    if (interpolation.col(node).nonZeros() > 0) nodes.push_back(node);
  return nodes;
}

// The rows of the points in a region; those of others are empty
SparseMatrix rows_in(const SparseMatrix& interpolation, const plate::PlateRegions& regions,
                     int region, const std::vector<Index>& elements) {
  SparseMatrix chosen = interpolation;
  if (regions.count() > 1)
    chosen.prune(
        [&](Index point, Index, double) { return regions.region(elements[point]) == region; });
  return chosen;
}

// points × (5 · nodes read): picks one section force of each node and interpolates it
SparseMatrix select_force(const SparseMatrix& interpolation, const std::vector<Index>& nodes,
                          int row) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (SparseMatrix::InnerIterator it(interpolation, nodes[k]); it; ++it)
      entries.emplace_back(it.row(), plate::kSectionForces * static_cast<Index>(k) + row,
                           it.value());
  SparseMatrix select(interpolation.rows(),
                      plate::kSectionForces * static_cast<Index>(nodes.size()));
  select.setFromTriplets(entries.begin(), entries.end());
  return select;
}

}  // namespace

ModalBasis::ModalBasis(const mesh::Q8Mesh& mesh, const plate::PlateRegions& regions,
                       const plate::DryModes& modes, const SparseMatrix& interpolation,
                       const std::vector<Quantity>& quantities, const std::vector<Index>& elements)
    : loss_factor_(regions.loss_factor()) {
  const MatXd deflection = strided_rows(modes.shape, 0, plate::kUnknownsPerNode);
  motion_[Quantity::kDeflection] = interpolation;

  // Recover section forces at the nodes around the points only, in each region by itself
  FLOE_EXPECT(regions.count() == 1 || std::ssize(elements) == interpolation.rows());
  if (std::any_of(quantities.begin(), quantities.end(), is_section_force))
    for (int region = 0; region < regions.count(); ++region)
      add_section_forces(mesh, regions, region, rows_in(interpolation, regions, region, elements),
                         quantities);
  for (const auto& [quantity, at_points] : section_force_)
    values_[quantity] = at_points * modes.shape;

  // And slopes
  for (const Quantity quantity : quantities)
    if (quantity == Quantity::kSlopeX || quantity == Quantity::kSlopeY)
      motion_[quantity] = interpolation * plate::slope_operator(mesh, quantity == Quantity::kSlopeX
                                                                          ? plate::kSlopeX
                                                                          : plate::kSlopeY);
  for (const auto& [quantity, at_points] : motion_) values_[quantity] = at_points * deflection;
}

// Of time derivatives and of the complex stiffness
Complex ModalBasis::factor(Quantity quantity, double omega) const {
  if (quantity == Quantity::kVelocity) return Complex(0.0, -omega);
  if (quantity == Quantity::kAcceleration) return -omega * omega;
  return is_section_force(quantity) ? Complex(1.0, -loss_factor_) : Complex(1.0);
}

void ModalBasis::add_section_forces(const mesh::Q8Mesh& mesh, const plate::PlateRegions& regions,
                                    int region, const SparseMatrix& interpolation,
                                    const std::vector<Quantity>& quantities) {
  // NOTE: stress at z = t/2 is M z / I with I = t³/12
  const double thickness = regions[region].thickness;
  const double stress_factor = 6.0 / (thickness * thickness);
  const std::vector<Index> nodes = nodes_read(interpolation);
  const SparseMatrix recovery = plate::section_force_operator(mesh, regions, nodes, region);
  for (const Quantity quantity : quantities) {
    if (!is_section_force(quantity)) continue;
    const bool stress =
        quantity == Quantity::kSurfaceStressX || quantity == Quantity::kSurfaceStressY;
    SparseMatrix part = select_force(interpolation, nodes, section_row(quantity)) * recovery;
    if (stress) part *= stress_factor;
    SparseMatrix& at_points = section_force_[quantity];
    if (at_points.size() == 0)
      at_points = std::move(part);
    else if (region > 0)
      at_points = SparseMatrix(at_points + part);
  }
}

MatXcd ModalBasis::evaluate(Quantity quantity, double omega, const MatXcd& amplitudes) const {
  const bool motion = quantity == Quantity::kVelocity || quantity == Quantity::kAcceleration;
  const auto values = values_.find(motion ? Quantity::kDeflection : quantity);
  FLOE_VALIDATE(values != values_.end(),
                "invalid quantity = " << name(quantity) << " (must be one of those asked for)");
  return factor(quantity, omega) * (values->second.cast<Complex>() * amplitudes);
}

MatXcd ModalBasis::evaluate_displacement(Quantity quantity, double omega,
                                         const MatXcd& displacement) const {
  if (is_section_force(quantity))
    return factor(quantity, omega) * (section_force_.at(quantity).cast<Complex>() * displacement);
  const bool motion = quantity == Quantity::kVelocity || quantity == Quantity::kAcceleration;
  const SparseMatrix& at_points = motion_.at(motion ? Quantity::kDeflection : quantity);
  const auto deflection = Eigen::seq(0, Eigen::last, plate::kUnknownsPerNode);
  return factor(quantity, omega) *
         (at_points.cast<Complex>() * MatXcd(displacement(deflection, Eigen::all)));
}

}  // namespace floe::response
