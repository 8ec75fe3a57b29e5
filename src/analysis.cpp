#include "analysis_stages.hpp"
#include "second_try.hpp"
#include "work_share.hpp"

#include <floe/analysis.hpp>
#include <floe/unsolved_frequency.hpp>

#include <optional>

namespace floe {
namespace {

FrequencyResult solve_or_tell(const Case& data, const PlateModel& plate, FluidModel& fluid,
                              double omega, StageClock& clock, Log& log) {
  const auto solve = data.route == SolverRoute::kModal ? solve_frequency : solve_frequency_direct;
  try {
    return solve_or_retry(data, fluid, omega, log,
                          [&] { return solve(data, plate, fluid, omega, clock); });
  } catch (const ConvergenceError& error) {
    log.warning(error.what());
    return unsolved_frequency(data, plate.modes.count(), omega, error.what());
  }
}

}  // namespace

void analyse(const Case& data, Log& log, Store& store) {
  StageClock clock;

  // Read the meshes and hold them against the waves and the memory
  const Meshes meshes = clock.time("mesh", [&] { return prepare_meshes(data, log); });
  const SeaBand band = prepare_seas(data, meshes.fluid, meshes.own(), meshes.regions, log);
  const Estimate plan = plan_of(data, meshes);
  WorkShare work(plan, data);
  store.begin(data, meshes.fluid, plan);

  // Find how the plate moves when it is dry
  const bool modal = data.route == SolverRoute::kModal;
  log.progress(0.0, "dry plate");
  std::optional<plate::DryModes> known_modes = modal ? store.known_modes() : std::nullopt;
  work.plate(known_modes.has_value());
  const PlateModel plate = clock.time(modal ? "dry modes" : "plate", [&] {
    return prepare_plate(data, meshes, std::move(known_modes));
  });
  if (modal) store.modes(plate.modes, meshes.plate());

  // Prepare what no frequency changes, once something is to be solved
  std::optional<FluidModel> prepared;
  const auto fluid = [&]() -> FluidModel& {
    if (!prepared) {
      prepared.emplace(
          clock.time("geometry", [&] { return prepare_fluid(data, meshes, plate, band); }));
      prepared->pause = [&log] { log.pause(); };
    }
    return *prepared;
  };

  // Solve one frequency after the other, and go on where one cannot be solved
  std::vector<FrequencyReport> reports;
  for (std::size_t i = 0; i < data.omega.size(); ++i) {
    if (!data.shard.holds(i)) continue;
    log.progress(work.share(),
                 "frequency " + std::to_string(i + 1) + " of " + std::to_string(data.omega.size()));
    const std::optional<FrequencyResult> known = store.known_frequency(i);
    const FrequencyResult result =
        known ? *known : solve_or_tell(data, plate, fluid(), data.omega[i], clock, log);
    store.frequency(result);
    reports.push_back(result.report);
    work.frequency(known.has_value());
  }

  // Put the plate into the seas
  if (band.asked() && data.shard.holds_seas()) {
    if (const std::optional<SeaGridReport> known = store.known_sea_grid())
      repeat_seas(data, *known, log, store);
    else
      solve_seas(data, band, plate, fluid(), clock, work, log, store);
  }
  log.progress(1.0, "done");
  store.finish(clock.times());
  const std::string unsolved = describe_unsolved(reports);
  FLOE_VALIDATE_AS(ConvergenceError, unsolved.empty(), unsolved);
}

}  // namespace floe
