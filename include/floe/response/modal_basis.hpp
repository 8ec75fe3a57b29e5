#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/plate_regions.hpp>
#include <floe/response/quantity.hpp>

#include <map>
#include <vector>

namespace floe::response {

/// Values of the modes at points of the plate, so that every structural quantity costs one small
/// product a wave (R.1).
class ModalBasis {
 public:
  /// `interpolation` (points × N) is that of stations.hpp on the mesh of the modes. Quantities that
  /// are not structural are passed over. Where the plate has several regions, `elements` says on
  /// which element each point lies: moments along the line between two regions jump.
  ModalBasis(const mesh::Q8Mesh& mesh, const plate::PlateRegions& regions,
             const plate::DryModes& modes, const SparseMatrix& interpolation,
             const std::vector<Quantity>& quantities, const std::vector<Index>& elements = {});

  /// A structural quantity at all points for amplitudes ξ (q × headings) at ω: points × headings.
  MatXcd evaluate(Quantity quantity, double omega, const MatXcd& amplitudes) const;

  /// A section force at all points as a functional of the displacement, points × 3N, without the
  /// loss factor.
  const SparseMatrix& section_force(Quantity quantity) const { return section_force_.at(quantity); }

  /// A structural quantity at all points of a displacement (3N × headings) at ω: points × headings.
  MatXcd evaluate_displacement(Quantity quantity, double omega, const MatXcd& displacement) const;

 private:
  Complex factor(Quantity quantity, double omega) const;
  void add_section_forces(const mesh::Q8Mesh& mesh, const plate::PlateRegions& regions, int region,
                          const SparseMatrix& interpolation,
                          const std::vector<Quantity>& quantities);

  double loss_factor_;
  std::map<Quantity, MatXd> values_;                // points × q, without factors of time and loss
  std::map<Quantity, SparseMatrix> section_force_;  // points × 3N
  std::map<Quantity, SparseMatrix> motion_;         // deflection and slopes, points × N
};

}  // namespace floe::response
