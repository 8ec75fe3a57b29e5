#pragma once

#include <floe/analysis.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// A Bretschneider–Mitsuyasu sea with cos² spreading.
struct SeaTemplate {
  double significant_height = 0.0;  ///< H1/3 [m]
  double significant_period = 0.0;  ///< T1/3 [s]
};

/// What a new case file is to say; everything else is written as comments with the defaults.
struct CaseTemplate {
  std::string title;
  double depth = 0.0;      ///< [m], or infinite
  double thickness = 0.0;  ///< [m]
  std::string mesh_file;   ///< as the case names it; empty: the rectangle
  mesh::RectangleOptions rectangle;
  int mode_count = 30;
  double omega_from = 0.0, omega_to = 0.0;  ///< of the regular waves [rad/s]
  std::vector<double> heading_deg;          ///< of the regular waves, and means of the sea
  std::optional<SeaTemplate> sea;
  std::vector<NamedPoint> points;
};

/// A whole case file that `read_case` accepts, each key with its unit and what it means. Keys that
/// are not needed stand in comments, all of them. Material values are those of the plate of Li et
/// al. (2014), marked to be edited.
std::string case_text(const CaseTemplate& wanted);

/// Writes it. Throws StoreError when there is anything under that name already.
void write_new_case(const std::filesystem::path& path, const CaseTemplate& wanted);

}  // namespace floe::io
