#include "io/output_directory.hpp"
#include "io/record_names.hpp"

#include <floe/io/run_state.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>

namespace floe::io {
namespace {

RunState::Frequency look_at_frequency(const StoredRun& run, std::size_t place) {
  RunState::Frequency found{.omega = run.data().omega[place]};
  try {
    found.failure = run.failure(place);
    if (!found.failure.empty()) found.part = RunState::Part::kFailed;
    if (!run.has_frequency(place)) return found;
    const FrequencyReport report = run.frequency(place).report;
    found.part = RunState::Part::kDone;
    found.seconds = report.seconds;
    found.true_residual = report.true_residual;
  } catch (const StoreError&) {
    found.part = RunState::Part::kDamaged;
  }
  return found;
}

void look_at_seas(const StoredRun& run, RunState& state) {
  state.seas_asked = run.wants_seas();
  try {
    state.seas_done = run.finished_seas().has_value();
    if (run.has_transfers()) state.transfers = run.sea_grid().omega.size();
  } catch (const StoreError&) {  // a damaged one is computed again
    state.seas_done = false;
  }
  while (
      state.transfers_done < state.transfers &&
      std::filesystem::exists(run.directory() / numbered_record("transfer", state.transfers_done)))
    ++state.transfers_done;
}

// The prediction, scaled by what the frequencies that are done took
double estimate_left(const StoredRun& run, const RunState& state) {
  const Estimate plan = run.plan();
  double frequency = 0.0, seas = 0.0;
  for (const StageEstimate& stage : plan.stages) {
    if (stage.stage == "seas")
      seas = stage.seconds;
    else if (stage.stage != "dry modes")
      frequency += stage.seconds / static_cast<double>(run.data().omega.size());
  }
  const auto done = static_cast<double>(state.count(RunState::Part::kDone));
  double spent = 0.0;
  for (const RunState::Frequency& one : state.frequencies) spent += one.seconds;
  const double scale = done > 0.0 && frequency > 0.0 ? spent / done / frequency : 1.0;
  double left = frequency * (static_cast<double>(state.frequencies.size()) - done);
  if (state.seas_asked && !state.seas_done)
    left += seas * (state.transfers > 0 ? 1.0 - static_cast<double>(state.transfers_done) /
                                                    static_cast<double>(state.transfers)
                                        : 1.0);
  return scale * left;
}

}  // namespace

std::size_t RunState::count(Part part) const {
  return static_cast<std::size_t>(
      std::count_if(frequencies.begin(), frequencies.end(),
                    [&](const Frequency& frequency) { return frequency.part == part; }));
}

RunState look_at_run(const std::filesystem::path& directory) {
  const StoredRun run(directory);
  RunState state;
  state.title = run.data().title;
  state.shard = run.data().shard;
  state.holder = holder_of(directory);
  for (std::size_t i = 0; i < run.data().omega.size(); ++i)
    if (state.shard.holds(i)) state.frequencies.push_back(look_at_frequency(run, i));
  look_at_seas(run, state);
  state.status =
      run.status() == "running" && state.holder.empty() ? "stopped without notice" : run.status();
  state.seconds_left = state.complete() ? 0.0 : estimate_left(run, state);
  return state;
}

}  // namespace floe::io
