#pragma once

#include <floe/analysis.hpp>
#include <floe/io/stored_run.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// One sea for the report. Means are mean headings; arrays run over mean heading, quantity of the
/// case, point of the case, the last one fastest.
struct ReportSea {
  std::string name;
  std::string text;  ///< spectrum, heights, periods and spreading in words
  std::vector<double> mean_heading_deg;
  std::vector<double> std, zero_crossing_period, significant, most_probable_maximum;
  std::vector<double> spectrum_omega;  ///< [rad/s]
  std::vector<double> spectra;         ///< as above, then the frequencies
  MatXd deflection_std;                ///< nodes of the plate's mesh × means [m]; empty if unknown
};

/// Motions of all nodes in some waves, where there are no modes to sum up: every one of the
/// frequencies with every one of the headings, headings faster.
struct ReportMotions {
  std::vector<std::size_t> frequencies, headings;  ///< places among the results, and in the case
  MatXd parts;  ///< 3N × 2 waves: (w, θx, θy) per metre, real and imaginary parts in turn
};

/// All that a report is made of.
struct ReportContent {
  const Case& data;
  const mesh::Q8Mesh& mesh;  ///< of modes or motions: the plate's own, or else the fluid's
  Index fluid_nodes = 0;
  Index fluid_elements = 0;
  const plate::DryModes& modes;                 ///< none on the direct route
  const std::vector<FrequencyResult>& results;  ///< by rising frequency; fields are not needed
  std::string status = "complete";              ///< or why the run ended early
  std::vector<std::string> warnings;
  std::vector<StageTime> stages;
  std::string case_text;  ///< the case as the user wrote it, or as it was resolved
  std::vector<ReportSea> seas;
  ReportMotions motions = {};                       ///< of the direct route
  std::optional<plate::PlateRegions> regions = {};  ///< where the case has any and they are known
  double seconds_before = 0.0;                      ///< of stages of runs that were resumed [s]
  std::vector<SelfCheck> checks = {};               ///< of the run; empty: made of the results
};

/// One HTML page with everything in it, no network: summary, checks, curves, the moving plate in
/// 3-D with its bending moments (of the modes alone), spectra, convergence and times. Under 5 MB:
/// large meshes are drawn by a choice of nodes and modes by 16-bit numbers (error 2e-5 of the
/// largest value of a mode). The same content gives the same bytes.
std::string report_page(const ReportContent& content);

/// The same of a stored run, with its seas; of the direct route those waves whose fields are
/// stored. Throws StoreError when records are damaged or no field is stored.
std::string report_page(const StoredRun& run);

/// Writes the page of a stored run; it appears under its name when it is complete.
void write_report(const StoredRun& run, const std::filesystem::path& path);

/// Whether this build contains the page's scripts (FLOE_REPORT); without them report_page throws
/// UsageError.
bool report_available();

}  // namespace floe::io
