#include "program/commands.hpp"
#include "program/exit_code.hpp"

#include <floe/io/case_file.hpp>
#include <floe/io/statistics_store.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/io/stored_transfers.hpp>
#include <floe/long_term_statistics.hpp>
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
void warn_of_coarse_grid(const std::string& sea, double error, Log& log) {
  if (error > 1e-2)
    log.warning(
        fmt::format("{}: the frequencies of the run give its m0 with an error of "
                    "{:.2g} % (run the case with closer ones)",
                    sea, 100.0 * error));
}

double grid_error(const wave::SeaState& sea, const std::vector<double>& omega) {
  const std::vector<double> weight = response::trapezoid_weights(omega);
  double sum = 0.0;
  for (std::size_t i = 0; i < omega.size(); ++i) sum += weight[i] * sea.density(omega[i]);
  return std::abs(sum - sea.variance(omega.front(), omega.back())) / sea.m0();
}

void check_seas(const io::SeaFile& file, const std::vector<double>& omega, Log& log) {
  const std::string remedy = "run with a wider sea_grid.omega";
  for (const wave::SeaState& sea : file.seas) {
    require_band(sea, omega.front(), omega.back(), remedy, log);
    warn_of_coarse_grid("sea " + sea.name, grid_error(sea, omega), log);
  }
  for (const wave::WaveClimate& climate : file.climates)
    require_band(climate, omega.front(), omega.back(), remedy, log);
}

// Results that replaced the run would take away what they are made from
void require_elsewhere(const std::filesystem::path& output, const std::filesystem::path& run) {
  std::error_code absent;
  if (std::filesystem::equivalent(output, run, absent))
    throw UsageError("invalid -o = " + output.string() + " (must not be the run itself)");
}

// The largest values of the longest return period
void tell_climate(const LongTermResult& result, const Case& data, Account& account) {
  account.info(fmt::format(" scatter {}: {}, {:.2g} % of the energy outside {}",
                           result.climate.name, result.climate.description,
                           100.0 * result.energy_outside(), "the frequencies"));
  const double years = result.climate.return_period_years.back();
  for (std::size_t k = 0; k < result.quantity.size(); ++k) {
    const response::Quantity quantity = data.quantities[result.quantity[k]];
    double largest = 0.0;
    std::string where;
    for (std::size_t i = 0; i < data.points.size(); ++i) {
      const auto distribution = result.distribution(k, static_cast<Index>(i));
      const double value =
          distribution.moves() ? distribution.return_value(years * 365.25 * 86'400.0) : 0.0;
      if (value > largest) where = data.points[i].name;
      largest = std::max(largest, value);
    }
    if (largest > 0.0)
      account.info(fmt::format("   in {} years {} {:.4g} {} at {}", years,
                               response::label(quantity), largest, response::unit(quantity),
                               where));
  }
}

}  // namespace

void tell_statistics(const StatsOptions& options) {
  // Read the run and the seas
  const auto start = std::chrono::steady_clock::now();
  Account account(ProgressStyle::kAuto);
  RememberedLog log(account);
  const io::StoredRun run(options.directory);
  const io::SeaFile file = io::read_sea_file(options.sea_file);
  for (const std::string& notice : file.notices) account.notice(notice);
  const io::StoredTransfers transfers(run);
  for (const std::string& warning : transfers.warnings()) log.warning(warning);
  const SeaGridReport& grid = transfers.grid();
  check_seas(file, grid.omega, log);

  // Put the seas on them
  Case data = run.data();
  data.seas = file.seas;
  const std::filesystem::path output =
      options.output.empty() ? options.sea_file.stem().string() + ".out" : options.output.string();
  require_elsewhere(output, run.directory());
  io::StatisticsStore store(output, options.fresh ? io::Existing::kReplace : io::Existing::kRefuse,
                            data, run.fluid_mesh(), grid);
  SeaStatistics statistics(file.seas, transfers.observation(), grid.omega, grid.headings,
                           run.data().relations);
  LongTermStatistics many_years(file.climates, transfers.observation(), grid.omega, grid.headings);
  for (std::size_t i = 0; i < grid.omega.size(); ++i) {
    log.progress(static_cast<double>(i) / static_cast<double>(grid.omega.size()),
                 fmt::format("{:.3f} rad/s", grid.omega[i]));
    const SeaTransfer transfer = transfers.transfer(i);
    statistics.add(transfer, store.node_spectra(i));
    many_years.add(transfer);
  }
  const std::vector<SeaResult> results = statistics.results();
  for (const SeaResult& result : results) {
    account.sea(result);
    for (const std::string& warning : cut_responses(result, data)) log.warning(warning);
  }
  const std::vector<LongTermResult> long_term = many_years.results();
  for (const LongTermResult& result : long_term) {
    warn_of_coarse_grid("scatter " + result.climate.name, result.grid_error, log);
    tell_climate(result, data, account);
  }

  // Store what came out
  const std::vector<std::string> files = store.finish(results, long_term, log.warnings);
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
