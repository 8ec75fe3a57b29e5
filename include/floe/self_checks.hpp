#pragma once

#include <floe/analysis.hpp>
#include <floe/preflight.hpp>

#include <string>
#include <vector>

/// What the results tell about themselves: identities that the exact solution satisfies.
namespace floe {

enum class CheckStatus {
  kGood,       ///< within the limit
  kAttention,  ///< up to ten times the limit
  kBad         ///< more, or not finite
};

/// "good", "attention", "bad".
const char* status_name(CheckStatus status);

/// The worst case of one identity over all frequencies.
struct SelfCheck {
  std::string name;
  double value = 0.0;
  double limit = 0.0;
  double omega = 0.0;  ///< where it is worst [rad/s]; 0: of the dry plate
  CheckStatus status = CheckStatus::kGood;
  std::string meaning;  ///< in plain words, and what to do where it fails
};

/// One warning a check that is not good: value, limit, meaning and remedy. The nodes a wavelength
/// are left out, of which a run is warned before it starts.
std::vector<std::string> warnings_of(const std::vector<SelfCheck>& checks);

inline constexpr double kKernelLimit = 1e-9;
/// Of the reciprocity and the energy error, which are about a tenth of the error of the largest
/// RAO: the plate of Table 1 has 1.3e-4 at 6 m elements, ω = 1.01, where its RAOs are good to 2e-3.
inline constexpr double kIdentityLimit = 1e-3;
/// Most negative eigenvalue of the damping matrix over its largest, sign turned.
inline constexpr double kPassivityLimit = 1e-4;
/// Change of the deflection by the highest quarter of the elastic modes: about what an engineer
/// reads off a curve.
inline constexpr double kModeChangeLimit = 1e-2;
/// |CᵀMC - modal mass| of modes whose eigenvalues are good to 1e-10.
inline constexpr double kOrthonormalityLimit = 1e-8;
/// |Kc|/|K||c| of the rigid modes: rounding of sums over the elements at a node.
inline constexpr double kRigidLimit = 1e-12;
/// Both, of a structure that another program has made: as it is checked when it is read.
inline constexpr double kGivenLimit = 1e-6;

/// The residual that the exact operator may leave of a solution to `tolerance`: that of the
/// iteration, and twice what the fast operator was asked for (its sums are not asked for more than
/// 1e-7, the exact integrals are good to 1e-8): once on the right-hand side's scale, once on that
/// of the solution, which is no larger where I + κ𝒢 is well conditioned.
double exact_residual_limit(double tolerance);

/// Residual of the fluid's equation, the same by the exact operator, error of the Green function's
/// table, symmetry of the fluid matrix, radiated energy, damping without a negative eigenvalue,
/// orthonormal modes, rigid modes without force, nodes a wavelength. Of the frequencies that
/// were solved; empty without one. Those of `seas` count too: what the mesh and the modes cost
/// there by its share of the largest response in them, for nothing needs accuracy where there is no
/// energy. `resolution` is of all of them.
std::vector<SelfCheck> self_checks(const Case& data, const std::vector<Resolution>& resolution,
                                   const plate::DryModes& modes,
                                   const std::vector<FrequencyReport>& waves,
                                   const std::vector<SolvedSeaFrequency>& seas);

}  // namespace floe
