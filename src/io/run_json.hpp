#pragma once

#include <floe/analysis.hpp>
#include <floe/estimate.hpp>
#include <floe/long_term_statistics.hpp>
#include <floe/preflight.hpp>
#include <floe/self_checks.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace floe::io {

/// The status of a run that has not ended, or was killed.
inline const std::string kRunning = "running";
/// That of one that has ended with frequencies that could not be solved.
inline const std::string kFailed = "failed";

/// What `run.json` tells about a run.
struct RunAccount {
  std::string status;  ///< "running", "complete", "failed", or why it stopped
  std::string mesh_hash;
  Index nodes = 0;
  Index elements = 0;
  int pieces = 0;
  double area = 0.0;  ///< [m²]
  Estimate plan;
  int threads = 1;
  std::vector<std::string> warnings;
  std::vector<double> dry_omega;   ///< [rad/s]
  double dry_omega_error = 0.0;    ///< largest relative error, estimated
  std::vector<double> wavenumber;  ///< one a finished frequency [rad/m]
  std::vector<FrequencyReport> frequencies;
  std::vector<Resolution> resolution;      ///< of the case's frequencies
  std::vector<SelfCheck> checks;           ///< none before the end
  SeaGridReport sea_grid;                  ///< no frequency: no seas
  std::vector<Resolution> sea_resolution;  ///< of its solved frequencies
  struct Sea {
    std::string name;
    double mean_heading_deg, significant_height, band_height, spreading_sum, share_outside,
        grid_error;
  };
  std::vector<Sea> seas;
  struct Climate {
    std::string name, description;
    double share_outside, grid_error;
  };
  std::vector<Climate> climates;
  std::vector<StageTime> stages;
  double seconds_before = 0.0;        ///< of stages of earlier runs that this one resumed [s]
  double peak_memory = 0.0;           ///< [byte]; 0: of this process
  std::vector<std::string> left_out;  ///< products that its route does not know
  std::vector<std::string> files;     ///< all files of the run, relative
};

/// The kinds of processors that solved the frequencies.
std::set<std::string> processors_of(const RunAccount& account);

/// What the account tells of one sea and mean heading.
RunAccount::Sea summary_of(const SeaResult& result);

/// And of one scatter diagram.
RunAccount::Climate summary_of(const LongTermResult& result);

/// The text of `run.json`; `options` is the case as case_json has it. Numbers that are not finite
/// become null.
std::string run_json(const nlohmann::ordered_json& options, const RunAccount& account);

/// The status that a `run.json` tells; "" where it tells none.
std::string status_of_run(const std::filesystem::path& account);

/// The seconds of all stages that a `run.json` tells, with those of runs that it resumed; 0 where
/// it tells none.
double seconds_of_run(const std::filesystem::path& account);

/// The files that a `run.json` lists as made by its run.
/// Throws StoreError when it is not a readable account of floe.
std::vector<std::string> files_of_run(const std::filesystem::path& account);

}  // namespace floe::io
