#include <floe/coupling/coupled_operator.hpp>

namespace floe::coupling {

CoupledOperator::CoupledOperator(const krylov::LinearOperator& fluid, const Compliance& compliance,
                                 double water_stiffness)
    : fluid_(fluid), compliance_(compliance), water_stiffness_(water_stiffness) {}

void CoupledOperator::apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const {
  const MatXcd hydrostatic = water_stiffness_ * compliance_.deflection(x);
  fluid_.apply(x - hydrostatic, y);
  y += hydrostatic;
}

}  // namespace floe::coupling
