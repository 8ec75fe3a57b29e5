#include "program/commands.hpp"

#include <floe/io/case_file.hpp>
#include <floe/io/statistics_store.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/io/stored_transfers.hpp>
#include <floe/numeric/error.hpp>
#include <floe/sea_statistics.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace floe::program {
namespace {

// Remembers the warnings, which go into the files too
class RememberedLog final : public Log {
 public:
  explicit RememberedLog(Account& account) : account_(account) {}
  void info(const std::string& text) override { account_.info(text); }
  void notice(const std::string& text) override { account_.notice(text); }
  void warning(const std::string& text) override {
    warnings.push_back(text);
    account_.warning(text);
  }
  void progress(double share, const std::string& now) override { account_.progress(share, now); }

  std::vector<std::string> warnings;

 private:
  Account& account_;  // borrowed
};

// The frequencies were chosen for other seas: a narrow spectrum may fall between them
void warn_of_coarse_grid(const wave::SeaState& sea, const std::vector<double>& omega, Log& log) {
  const std::vector<double> weight = response::trapezoid_weights(omega);
  double sum = 0.0;
  for (std::size_t i = 0; i < omega.size(); ++i) sum += weight[i] * sea.density(omega[i]);
  const double error = std::abs(sum - sea.variance(omega.front(), omega.back())) / sea.m0();
  if (error > 1e-2)
    log.warning(
        fmt::format("sea {}: the frequencies of the run give its m0 with an error of "
                    "{:.2g} % (run the case with this sea for closer ones)",
                    sea.name, 100.0 * error));
}

}  // namespace

void tell_statistics(const StatsOptions& options) {
  // Read the run and the seas
  const auto start = std::chrono::steady_clock::now();
  Account account(ProgressStyle::kAuto);
  RememberedLog log(account);
  const io::StoredRun run(options.directory);
  const std::vector<wave::SeaState> seas = io::read_sea_file(options.sea_file);
  const io::StoredTransfers transfers(run);
  for (const std::string& warning : transfers.warnings()) log.warning(warning);
  const SeaGridReport& grid = transfers.grid();
  for (const wave::SeaState& sea : seas) {
    require_band(sea, grid.omega.front(), grid.omega.back(), "run with a wider sea_grid.omega",
                 log);
    warn_of_coarse_grid(sea, grid.omega, log);
  }

  // Put the seas on them
  SeaStatistics statistics(seas, transfers.observation(), grid.omega, grid.headings,
                           run.data().relations);
  for (std::size_t i = 0; i < grid.omega.size(); ++i) {
    log.progress(static_cast<double>(i) / static_cast<double>(grid.omega.size()),
                 fmt::format("{:.3f} rad/s", grid.omega[i]));
    statistics.add(transfers.transfer(i));
  }
  const std::vector<SeaResult> results = statistics.results();
  for (const SeaResult& result : results) account.sea(result);

  // Store what came out
  Case data = run.data();
  data.seas = seas;
  const std::filesystem::path output =
      options.output.empty() ? options.sea_file.stem().string() + ".out" : options.output.string();
  const std::vector<std::string> files =
      io::store_statistics(output, options.fresh ? io::Existing::kReplace : io::Existing::kRefuse,
                           data, run.fluid_mesh(), grid, results, log.warnings);
  account.show_warnings();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  account.gap();
  account.fact("results", fmt::format("{}/ ({})", output.string(),
                                      counted(static_cast<Index>(files.size()), "file")));
  account.fact("done", fmt::format("{} for {} frequencies and {} headings of {}",
                                   format_duration(elapsed.count()), grid.omega.size(),
                                   grid.headings, run.directory().string()));
}

}  // namespace floe::program
