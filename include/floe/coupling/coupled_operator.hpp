#pragma once

#include <floe/krylov/linear_operator.hpp>
#include <floe/numeric/types.hpp>

namespace floe::coupling {

/// How a plate on an elastic foundation gives way, at the nodes of the fluid's mesh.
class Compliance {
 public:
  virtual ~Compliance() = default;
  /// C q, deflections [m] under nodal pressures [Pa], N × columns.
  virtual MatXcd deflection(const Eigen::Ref<const MatXcd>& pressure) const = 0;
};

/// Plate and fluid in one equation for q = p + ρg w, the pressure that a plate on a foundation of
/// the water's own stiffness ρg would carry beside it; q/ρg is the elevation of the water under
/// the plate:
///   q + κ𝒢 (q - ρg C q) = ρg ζ,   w = C q,   p = q - ρg w                               (C.4)
/// C has no resonance: its foundation outweighs the plate's inertia.
class CoupledOperator final : public krylov::LinearOperator {
 public:
  /// `fluid` is I + κ𝒢, `water_stiffness` ρg [N/m³]. Both views must live as long.
  CoupledOperator(const krylov::LinearOperator& fluid, const Compliance& compliance,
                  double water_stiffness);

  Index size() const override { return fluid_.size(); }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;

 private:
  const krylov::LinearOperator& fluid_;
  const Compliance& compliance_;
  double water_stiffness_;
};

}  // namespace floe::coupling
