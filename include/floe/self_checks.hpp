#pragma once

#include <floe/analysis.hpp>

#include <string>
#include <vector>

/// What the results tell about themselves: identities that the exact solution satisfies.
namespace floe {

enum class CheckStatus {
  kGood,       ///< within the limit
  kAttention,  ///< up to ten times the limit
  kBad         ///< more, or not finite
};

/// The worst case of one identity over all frequencies.
struct SelfCheck {
  std::string name;
  double value = 0.0;
  double limit = 0.0;
  double omega = 0.0;  ///< where it is worst [rad/s]
  CheckStatus status = CheckStatus::kGood;
  std::string meaning;  ///< in plain words, and what to do where it fails
};

inline constexpr double kKernelLimit = 1e-9;
/// Of the reciprocity and the energy error, which are about a tenth of the error of the largest
/// RAO: the plate of Table 1 has 1.3e-4 at 6 m elements, ω = 1.01, where its RAOs are good to 2e-3.
inline constexpr double kIdentityLimit = 1e-3;
/// Most negative eigenvalue of the damping matrix over its largest, sign turned.
inline constexpr double kPassivityLimit = 1e-4;

/// Residual of the fluid's equation, error of the Green function's table, symmetry of the fluid
/// matrix, radiated energy, damping without a negative eigenvalue, nodes a wavelength. The direct
/// route has no damping, and one heading alone no reciprocity. Empty without a finished frequency.
std::vector<SelfCheck> self_checks(const Case& data, const mesh::Q8Mesh& mesh,
                                   const std::vector<FrequencyResult>& results);

}  // namespace floe
