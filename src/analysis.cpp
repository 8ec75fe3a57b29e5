#include "analysis_stages.hpp"

#include <floe/analysis.hpp>

#include <optional>

namespace floe {

void analyse(const Case& data, Log& log, Store& store) {
  StageClock clock;

  // Read the meshes and hold them against the waves and the memory
  const Meshes meshes = clock.time("mesh", [&] { return prepare_meshes(data, log); });
  const SeaBand band = prepare_seas(data, meshes, log);
  store.begin(data, meshes.fluid, plan_of(data, meshes));

  // Find how the plate moves when it is dry
  log.progress(0.0, "dry plate");
  const bool modal = data.route == SolverRoute::kModal;
  const PlateModel plate = clock.time(modal ? "dry modes" : "plate", [&] {
    return prepare_plate(data, meshes, modal ? store.known_modes() : std::nullopt);
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
  const double count = static_cast<double>(data.omega.size());
  for (std::size_t i = 0; i < data.omega.size(); ++i) {
    log.progress(static_cast<double>(i) / count,
                 "frequency " + std::to_string(i + 1) + " of " + std::to_string(data.omega.size()));
    const auto solve = modal ? solve_frequency : solve_frequency_direct;
    const std::optional<FrequencyResult> known = store.known_frequency(i);
    store.frequency(known ? *known : solve(data, plate, fluid(), data.omega[i], clock));
  }

  // Put the plate into the seas
  if (band.asked()) {
    if (const std::optional<SeaGridReport> known = store.known_sea_grid())
      repeat_seas(data, *known, store);
    else
      solve_seas(data, band, plate, fluid(), clock, log, store);
  }
  log.progress(1.0, "done");
  store.finish(clock.times());
}

}  // namespace floe
