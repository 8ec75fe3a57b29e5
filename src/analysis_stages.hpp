#pragma once

#include <floe/analysis.hpp>
#include <floe/bem/element_integrals.hpp>
#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/bem/pressure_operator.hpp>
#include <floe/estimate.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/krylov/gmres.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/memory.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/plate/static_correction.hpp>
#include <floe/response/modal_basis.hpp>
#include <floe/sea_band.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

/// The stages of `analyse`, one function each.
namespace floe {

class WorkShare;

/// Adds up wall time under the names of stages.
class StageClock {
 public:
  template <typename Work>
  auto time(const std::string& stage, Work work) {
    const auto start = std::chrono::steady_clock::now();
    const Stop stop{*this, stage, start};
    try {
      return work();
    } catch (const std::bad_alloc&) {
      throw BudgetError("out of memory in the stage " + stage +
                        " (give fewer nodes or modes, or run floe check for the need)");
    }
  }
  const std::vector<StageTime>& times() const { return times_; }

 private:
  using TimePoint = std::chrono::steady_clock::time_point;
  struct Stop {
    StageClock& clock;
    const std::string& stage;
    TimePoint start;
    ~Stop() { clock.add(stage, std::chrono::steady_clock::now() - start); }
  };
  void add(const std::string& stage, std::chrono::duration<double> elapsed);

  std::vector<StageTime> times_;
};

/// The fluid's mesh, and the plate's own if it has one.
struct Meshes {
  mesh::Q8Mesh fluid;
  std::optional<mesh::Q8Mesh> own_plate;
  plate::PlateRegions regions;  ///< of the plate's mesh
  const mesh::Q8Mesh& plate() const { return own_plate ? *own_plate : fluid; }
  /// The plate's own mesh, null where it has none.
  const mesh::Q8Mesh* own() const { return own_plate ? &*own_plate : nullptr; }
};

/// The dry plate and what is read off its modes.
struct PlateModel {
  plate::PlateRegions regions;  ///< of the plate's mesh
  plate::DryModes modes;        ///< on the plate's mesh
  plate::DryModes fluid_modes;  ///< the same at the fluid's nodes
  response::ModalBasis points;
  response::ModalBasis lines;
  std::optional<plate::StaticCorrection> correction;  ///< where section forces are wanted
  SparseMatrix to_fluid;  ///< from the plate's own mesh to the fluid's nodes; empty if they are one
  std::optional<plate::PlateMatrices> matrices;  ///< on the direct route, which has no modes
};

/// What an operator needs at every frequency, according to the method.
struct FluidOperators {
  SolverMethod method = SolverMethod::kDense;  ///< never kAuto
  std::shared_ptr<const bem::LatticePlan> lattice;
  std::shared_ptr<const bem::FastPressurePlan> sums;
  std::shared_ptr<const bem::FastPressurePlan> step_sums;  ///< cheaper, for the steps; or none
  KrylovPlan space;                                        ///< of the iteration
};

/// What the fluid needs at every frequency.
struct FluidModel {
  FluidOperators operators;
  bem::ElementIntegrals integrals;
  SparseMatrix surface_mass;
  MatXd deflection;        ///< w of the modes at the fluid's nodes, N × q
  SparseMatrix at_points;  ///< interpolation to Case::points
  Points2 wave_points;
  std::vector<double> heading;       ///< [rad]
  double reach = 0.0;                ///< largest distance that the Green function is asked for [m]
  std::function<void()> pause = {};  ///< Log::pause
};

/// What the run will take.
Estimate plan_of(const Case& data, const Meshes& meshes);
Meshes prepare_meshes(const Case& data, Log& log);
/// With the modes that are known, or else computes them.
PlateModel prepare_plate(const Case& data, const Meshes& meshes,
                         std::optional<plate::DryModes> known);
/// For frequencies up to `highest` [rad/s].
FluidOperators prepare_operators(const Case& data, const mesh::Q8Mesh& mesh, double highest);
FluidModel prepare_fluid(const Case& data, const Meshes& meshes, const PlateModel& plate,
                         const SeaBand& band);
std::unique_ptr<const bem::PressureOperator> make_operator(const Case& data,
                                                           const FluidModel& fluid,
                                                           const green::GreenTable& green);
/// I + κ𝒢 by the fast operator of the plan, or dense without a factorisation.
std::unique_ptr<const krylov::LinearOperator> make_action(const FluidModel& fluid,
                                                          const green::GreenTable& green);
/// The same less accurately, for the steps of the iteration; null where it would not pay.
std::unique_ptr<const krylov::LinearOperator> make_step_action(const FluidModel& fluid,
                                                               const green::GreenTable& green);
/// How the iteration keeps its space.
krylov::GmresOptions iteration_options(const Case& data, const FluidModel& fluid);
FrequencyResult solve_frequency(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                                double omega, StageClock& clock);
/// The same by one coupled equation (C.4) without modes, one column a heading.
FrequencyResult solve_frequency_direct(const Case& data, const PlateModel& plate,
                                       const FluidModel& fluid, double omega, StageClock& clock);
/// Whether the pressure under the moving plate is needed in every heading.
bool wants_pressure(const Case& data);
/// Headings whose node fields are wanted at a frequency; nothing asked for means the first heading
/// at ten frequencies at most, evenly spread.
std::vector<Index> field_headings(const Case& data, double omega);
/// Pressure and relative elevation at the points from the pressure of all headings.
void add_pressures(const Case& data, const FluidModel& fluid, const MatXcd& pressure,
                   FrequencyResult& result);
/// Waves around the plate from the same.
void add_wave_elevation(const Case& data, const FluidModel& fluid, const green::GreenTable& green,
                        const MatXcd& pressure, FrequencyResult& result);

void solve_seas(const Case& data, const SeaBand& band, const PlateModel& plate, FluidModel& fluid,
                StageClock& clock, WorkShare& work, Log& log, Store& store);
/// Amplitudes (E.23) of all zones of all seas that have any, nodes × zones.
MatXd all_zone_amplitudes(const std::vector<wave::SeaState>& seas, const mesh::Q8Mesh& mesh);
/// Holds the zones against the plate and the lengths of their waves.
void check_zones(const Case& data, const mesh::Q8Mesh& mesh, Log& log);
/// The same from transfer functions that the store holds; no solve.
void repeat_seas(const Case& data, const SeaGridReport& grid, Log& log, Store& store);
/// The residual that a solution of the fluid's equation must have.
double residual_limit(const Case& data, const FluidModel& fluid);

}  // namespace floe
