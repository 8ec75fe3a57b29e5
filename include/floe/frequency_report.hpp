#pragma once

#include <string>

namespace floe {

/// What a frequency's solution is worth.
struct FrequencyReport {
  double omega = 0.0;              ///< [rad/s]
  std::string method;              ///< method_name of what was used
  int iterations = 0;              ///< 0 for a direct solution
  long applications = 0;           ///< operator applications
  double true_residual = 0.0;      ///< largest ‖b - Ax‖/‖b‖ over all columns
  double kernel_error = 0.0;       ///< relative error of G from its table, sampled
  double reciprocity_error = 0.0;  ///< ‖P - Pᵀ‖/‖P‖ of the hydrodynamic part
  double energy_error = 0.0;       ///< damping against radiated energy, relative to ω·max|a|
  double exact_residual = 0.0;     ///< as true_residual, by the exact operator on sampled rows
  /// In the middles of elements, where nothing was asked of the solution: what the mesh costs.
  double residual_between_nodes = 0.0;
  /// By leaving out the highest quarter of the elastic modes, relative to the largest deflection.
  double mode_change = 0.0;
  double passivity_error = 0.0;  ///< most negative eigenvalue of the damping over the largest
  double seconds = 0.0;          ///< wall time
  std::string processor = {};    ///< numeric::processor_kind of what solved it
  std::string failure = {};      ///< why there is no result; empty: there is one
};

}  // namespace floe
