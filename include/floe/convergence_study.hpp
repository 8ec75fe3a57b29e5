#pragma once

#include <floe/analysis.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// How far the answers of a case are from those of infinitely fine elements and of all modes.
namespace floe {

/// One answer of a case, a quantity at a point in one wave, with what limits it.
struct StudiedAnswer {
  double omega = 0.0;  ///< [rad/s]
  double heading_deg = 0.0;
  std::string point;
  response::Quantity quantity = response::Quantity::kDeflection;
  Complex value;            ///< on the case's own mesh
  Complex extrapolated;     ///< to infinitely fine elements
  double mesh_error = 0.0;  ///< |value - extrapolated|
  double mode_error = 0.0;  ///< change of the value by twice the modes
};

/// All answers of one quantity in the waves of one frequency.
struct StudiedGroup {
  double omega = 0.0;  ///< [rad/s]
  response::Quantity quantity = response::Quantity::kDeflection;
  double largest = 0.0;     ///< largest |value|
  double order = 0.0;       ///< observed, of the elements' size; 0: the answers do not settle
  double mesh_error = 0.0;  ///< largest of the answers, relative to `largest`
  double mode_error = 0.0;  ///< largest of the answers, relative to `largest`
};

struct ConvergenceStudy {
  std::vector<Index> nodes;  ///< of the three meshes, the case's own first
  int modes = 0;             ///< of the case
  int more_modes = 0;        ///< with which the rest is estimated
  std::vector<StudiedAnswer> answers;
  std::vector<StudiedGroup> groups;
};

/// Richardson's extrapolation of answers on three meshes whose elements halve (one column a mesh,
/// one row an answer): the common order p = log2(‖f₁ - f₂‖/‖f₂ - f₃‖), at most 4, and
/// f₃ + (f₃ - f₂)/(2ᵖ - 1). Order 0 and f₃ where the differences do not shrink by √2 or more.
struct Extrapolation {
  double order = 0.0;
  VecXcd value;
};
Extrapolation extrapolate(const Eigen::Ref<const MatXcd>& answers);

/// Solves the case on its mesh and on two finer ones (every element into four, twice), and on its
/// own mesh with twice the modes (not on the direct route, which has none). Only point quantities
/// are computed, no seas. The finer meshes are written to `folder` as refined_1.msh and
/// refined_2.msh, plate_refined_… where the plate has its own. Throws InputError without a point,
/// and as `analyse`.
ConvergenceStudy study_convergence(const Case& data, const std::filesystem::path& folder, Log& log);

/// Names of the meshes that study_convergence writes.
std::vector<std::string> study_meshes(const Case& data);

}  // namespace floe
