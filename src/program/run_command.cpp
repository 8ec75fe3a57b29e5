#include "program/commands.hpp"
#include "program/exit_code.hpp"
#include "program/signals.hpp"

#include <floe/estimate.hpp>
#include <floe/io/case_file.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/numeric/blas_check.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/memory.hpp>

#include <fmt/format.h>
#include <omp.h>
#include <sched.h>

#include <chrono>
#include <cmath>
#include <latch>
#include <system_error>
#include <thread>
#include <vector>

namespace floe::program {
namespace {

std::string describe_waves(const Case& data) {
  const std::string range =
      data.omega.size() == 1
          ? fmt::format("{:.4g} rad/s", data.omega.front())
          : fmt::format("{:.4g} … {:.4g} rad/s", data.omega.front(), data.omega.back());
  const std::string depth = std::isinf(data.water.depth)
                                ? "infinite depth"
                                : fmt::format("depth {:.4g} m", data.water.depth);
  const Index count = static_cast<Index>(data.omega.size());
  return fmt::format("{} {}, {}, {}", count, count == 1 ? "frequency" : "frequencies", range,
                     counted(static_cast<Index>(data.heading_deg.size()), "heading")) +
         ", " + depth;
}

// Tells what is stored as it is stored, and stops between two units when asked to
class ToldStore final : public Store {
 public:
  ToldStore(io::DirectoryStore& store, Account& account) : store_(store), account_(account) {}

  std::optional<plate::DryModes> known_modes() override { return store_.known_modes(); }
  std::optional<FrequencyResult> known_frequency(std::size_t place) override {
    return store_.known_frequency(place);
  }
  std::optional<SeaGridReport> known_sea_grid() override { return store_.known_sea_grid(); }
  SeaTransfer known_transfer(std::size_t place) override { return store_.known_transfer(place); }
  SeaObservation known_observation() override { return store_.known_observation(); }
  std::optional<SeaMarch> known_sea_march() override { return store_.known_sea_march(); }
  std::optional<FluidSample> known_sea_sample(int number) override {
    return store_.known_sea_sample(number);
  }

  void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) override {
    account_.fact("mesh", fmt::format("{}, {}, {}, {:.6g} m²", counted(mesh.node_count(), "node"),
                                      counted(mesh.element_count(), "element"),
                                      counted(mesh.piece_count(), "piece"), mesh.area()));
    account_.fact("waves", describe_waves(data));
    account_.fact("plan", fmt::format("{}, {}, about {} and {}", plan.method,
                                      counted(omp_get_max_threads(), "thread"),
                                      format_duration(plan.seconds), format_bytes(plan.memory)));
    store_.begin(data, mesh, plan);
    stop_if_asked();
  }

  void modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) override {
    store_.modes(modes, mesh);
    const std::string elastic =
        modes.count() > modes.rigid_count
            ? fmt::format(", first elastic {:.4g} rad/s, last {:.4g}",
                          modes.omega[modes.rigid_count], modes.omega.maxCoeff())
            : "";
    // Of modes from elsewhere nothing is known
    const std::string error =
        modes.estimated_frequency_error > 0.0
            ? fmt::format(", good to {:.1g} or better", modes.estimated_frequency_error)
            : "";
    account_.fact(
        "modes", fmt::format("{}, {} rigid{}{}", modes.count(), modes.rigid_count, elastic, error));
    account_.show_warnings();
    stop_if_asked();
  }

  void frequency(const FrequencyResult& result) override {
    store_.frequency(result);
    if (result.report.failure.empty()) ++finished_;
    account_.frequency(result);
    stop_if_asked();
  }

  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned) override {
    store_.begin_seas(observation, planned);
  }

  void sea_sample(int number, const FluidSample& sample) override {
    store_.sea_sample(number, sample);
    stop_if_asked();
  }

  void sea_march(const SeaMarch& march) override { store_.sea_march(march); }

  void sea_transfer(const SeaTransfer& transfer) override {
    store_.sea_transfer(transfer);
    stop_if_asked();
  }

  void node_spectrum(std::size_t result, std::size_t frequency, const VecXd& spectrum) override {
    store_.node_spectrum(result, frequency, spectrum);
  }

  void sea(const SeaResult& result) override {
    store_.sea(result);
    account_.sea(result);
  }

  void end_seas(const SeaGridReport& grid) override {
    store_.end_seas(grid);
    account_.fact("seas", fmt::format("{} frequencies from {} solved, interpolated to {:.1g}; {} "
                                      "headings around the circle",
                                      grid.omega.size(), grid.solved_frequencies,
                                      grid.interpolation_error, grid.headings));
    if (grid.pressure_error > 0.0)
      account_.fact("pressures", fmt::format("at the points to {:.1g} of the diffraction problem",
                                             grid.pressure_error));
  }

  void finish(const std::vector<StageTime>& times) override { store_.finish(times); }

  Index finished() const { return finished_; }

 private:
  io::DirectoryStore& store_;  // borrowed
  Account& account_;           // borrowed
  Index finished_ = 0;
};

// OpenMP ends the program where the system has no more threads
void require_threads(int count) {
  std::vector<std::jthread> started;
  std::latch end(1);
  try {
    while (static_cast<int>(started.size()) + 1 < count)
      started.emplace_back([&end] { end.wait(); });
  } catch (const std::system_error& error) {
    end.count_down();
    throw BudgetError(
        fmt::format("cannot start {} threads, the system gives {}: {} (give "
                    "--threads, or raise `ulimit -u`)",
                    count, started.size() + 1, error.code().message()));
  }
  end.count_down();
}

// Keeps what was finished; a failure on the way out does not hide the first one
void stop_store(io::DirectoryStore& store, const std::string& why) {
  try {
    store.stop(why);
  } catch (const std::exception& error) {
    print_error(fmt::format("floe: error: {}\n", error.what()));
  }
}

std::filesystem::path output_of(const RunOptions& options) {
  if (!options.output.empty()) return options.output;
  return options.case_file.stem().string() + ".out";
}

}  // namespace

std::string counted(Index count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void use_threads(int threads, Account& account) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const bool known = ::sched_getaffinity(0, sizeof allowed, &allowed) == 0;
  if (known && threads > CPU_COUNT(&allowed))
    account.notice(fmt::format("{} asked for, the process may use {}", counted(threads, "thread"),
                               counted(CPU_COUNT(&allowed), "processor")));
  if (threads > 0) omp_set_num_threads(threads);
  require_threads(omp_get_max_threads());
}

Case read_case_for(const RunOptions& options, Account& account) {
  io::CaseFile file = io::read_case(options.case_file);
  account.fact("floe", fmt::format("{}{}{}", FLOE_VERSION, file.data.title.empty() ? "" : " · ",
                                   file.data.title));
  account.fact("case", options.case_file.string());
  for (const std::string& notice : file.notices) account.notice(notice);
  for (const std::string& warning : file.warnings) account.warning(warning);
  file.data.allow_coarse = options.allow_coarse;
  file.data.memory_limit = options.memory;
  file.data.shard = options.shard;
  return std::move(file.data);
}

void run_case(const RunOptions& options) {
  // Read the case and claim the output directory before anything is computed
  const auto start = std::chrono::steady_clock::now();
  if (options.max_time > 0.0) limit_time(options.max_time);
  Account account(options.progress);
  Case data = read_case_for(options, account);
  use_threads(options.threads, account);
  numeric::require_working_blas();
  io::DirectoryStore store(output_of(options), options.fresh    ? io::Existing::kReplace
                                               : options.resume ? io::Existing::kResume
                                                                : io::Existing::kRefuse);
  data.plan_memory = store.earlier_plan_memory();

  if (!store.locks())
    account.warning(store.directory().string() +
                    ": the file system has no locks, nothing keeps a second run out");

  // Compute; whatever ends the run early, finished frequencies stay
  ToldStore told(store, account);
  try {
    analyse(data, account, told);
  } catch (...) {
    const Failure failure = describe(std::current_exception());
    account.show_warnings();
    stop_store(store, failure.text);
    if (told.finished() > 0)
      account.fact("kept", fmt::format("{} of {} frequencies in {}/", told.finished(),
                                       data.omega.size(), store.directory().string()));
    throw;
  }

  // Tell where everything lies
  for (const std::string& damaged : store.damaged_records())
    account.warning(damaged + ", computed again");
  for (const std::string& warning : warnings_of(store.checks())) account.warning(warning);
  account.show_warnings();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  account.gap();
  account.fact("results", fmt::format("{}/ ({})", store.directory().string(),
                                      counted(static_cast<Index>(store.files().size()), "file")));
  account.fact("done", fmt::format("{}, peak memory {}", format_duration(elapsed.count()),
                                   format_bytes(numeric::peak_memory())));
}

}  // namespace floe::program
