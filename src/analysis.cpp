#include "analysis_stages.hpp"
#include "name_frequency.hpp"
#include "work_share.hpp"

#include <floe/analysis.hpp>

#include <optional>

namespace floe {

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
  const auto fluid = [&]() -> const FluidModel& {
    if (!prepared)
      prepared.emplace(
          clock.time("geometry", [&] { return prepare_fluid(data, meshes, plate, band); }));
    return *prepared;
  };

  // Solve one frequency after the other
  for (std::size_t i = 0; i < data.omega.size(); ++i) {
    if (!data.shard.holds(i)) continue;
    log.progress(work.share(),
                 "frequency " + std::to_string(i + 1) + " of " + std::to_string(data.omega.size()));
    const auto solve = modal ? solve_frequency : solve_frequency_direct;
    const std::optional<FrequencyResult> known = store.known_frequency(i);
    store.frequency(known ? *known : name_frequency(data.omega[i], data.water, meshes.fluid, [&] {
      return solve(data, plate, fluid(), data.omega[i], clock);
    }));
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
}

}  // namespace floe
