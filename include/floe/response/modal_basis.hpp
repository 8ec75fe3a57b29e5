#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/plate_properties.hpp>
#include <floe/response/quantity.hpp>
#include <map>
#include <vector>

namespace floe::response {

/// Values of the modes at points of the plate, so that every quantity that is linear in the modal
/// amplitudes ξ costs one small product a wave.
class ModalBasis {
 public:
  /// `interpolation` (points × N) is that of stations.hpp on the mesh of the modes. Pressure and
  /// relative elevation are not linear in ξ alone; asking for them here is ignored.
  ModalBasis(const mesh::Q8Mesh& mesh, const plate::PlateProperties& properties,
             const plate::DryModes& modes, const SparseMatrix& interpolation,
             const std::vector<Quantity>& quantities);

  /// The quantity at all points for amplitudes ξ (q × headings) at ω: points × headings.
  MatXcd evaluate(Quantity quantity, double omega, const MatXcd& amplitudes) const;

  /// Whether a quantity is linear in ξ alone.
  static bool is_modal(Quantity quantity);

 private:
  double loss_factor_;
  std::map<Quantity, MatXd> values_;  // points × q, without the factor of time and of loss
};

}  // namespace floe::response
