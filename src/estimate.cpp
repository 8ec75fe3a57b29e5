#include "fluid_cost.hpp"

#include <floe/bem/element_lattice.hpp>
#include <floe/estimate.hpp>
#include <floe/krylov/gmres.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/memory.hpp>
#include <floe/response/modal_basis.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace floe {
namespace {

// Rates of one current core, rounded
constexpr double kFactorRate = 2.5e10;     // products of small dense matrices [flop/s]
constexpr double kSparseRate = 1e9;        // sparse Cholesky and its solves [flop/s]
constexpr double kAssembling = 4.0;        // matrix, order and factor over the factor alone
constexpr double kLoading = 3e-7;          // pressures to loads and back, a node and column [s]
constexpr double kBytesOfProgram = 2.5e7;  // code, libraries, tables
constexpr double kLanczosSolves = 4.0;     // solves per mode

constexpr double kKrylovLeast = 0.25;  // of the budget, and how much of what others leave
constexpr double kKrylovMost = 0.8;
constexpr double kAmpleSteps = 30.0;

constexpr double kSeaSolves = 40.0;    // frequencies that a sea makes the program solve
constexpr double kSeaSamples = 9.0;    // of these in memory
constexpr double kSeaHeadings = 32.0;  // whose wave loads a thread holds

struct Sizes {
  double nodes, elements, plate_nodes, modes, headings, frequencies, outputs;
  double influences;  // section forces and pressures at points, columns of the seas' radiation
};

Sizes sizes_of(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh& plate_mesh) {
  double stations = static_cast<double>(data.points.size()) *
                        (1.0 + static_cast<double>(data.quantities.size())) +
                    static_cast<double>(data.wave_points.size());
  for (const NamedLine& line : data.lines) stations += line.count;
  return {.nodes = static_cast<double>(mesh.node_count()),
          .elements = static_cast<double>(mesh.element_count()),
          .plate_nodes = static_cast<double>(plate_mesh.node_count()),
          .modes = static_cast<double>(data.mode_count),
          .headings = static_cast<double>(data.heading_deg.size()),
          .frequencies = static_cast<double>(data.omega.size()),
          .outputs = stations,
          .influences =
              static_cast<double>(data.points.size()) *
              (static_cast<double>(std::count_if(data.quantities.begin(), data.quantities.end(),
                                                 response::is_section_force)) +
               (std::all_of(data.quantities.begin(), data.quantities.end(), response::is_structural)
                    ? 0.0
                    : 1.0))};
}

// Sparse factor of a plane mesh by nested dissection: n log n entries, n^1.5 operations
StageEstimate estimate_modes(const Sizes& s) {
  const double unknowns = 3.0 * s.plate_nodes;
  const double factor = 31.0 * unknowns * std::log2(std::max(2.0, unknowns)) / 4.0;
  const double matrices = 2.0 * 60.0 * unknowns;
  const double lanczos = 5.0 * s.modes * unknowns;
  const double work =
      400.0 * std::pow(unknowns, 1.5) / 4.0 + kLanczosSolves * s.modes * 4.0 * factor;
  return {.stage = "dry modes",
          .memory = 16.0 * matrices + 16.0 * factor + 8.0 * lanczos,
          .seconds = work / kSparseRate};
}

// On the direct route the factor alone, with the matrix beside it, once a frequency; a solve for
// each application, real and imaginary parts
StageEstimate estimate_plate(const Sizes& s, const FluidWork& work) {
  const double unknowns = 3.0 * s.plate_nodes;
  const double factor = 31.0 * unknowns * std::log2(std::max(2.0, unknowns)) / 4.0;
  double seconds = 0.0;
  for (const double length : work.lengths) {
    const double applications =
        work.columns * applications_a_column(length, work.columns, work.tolerance);
    seconds +=
        (kAssembling * 400.0 * std::pow(unknowns, 1.5) / 4.0 + 2.0 * applications * 4.0 * factor) /
            kSparseRate +
        kLoading * applications * s.nodes;
  }
  return {
      .stage = "plate", .memory = 16.0 * 4.0 * 60.0 * unknowns + 16.0 * factor, .seconds = seconds};
}

// Right-hand sides, solutions and residuals
double columns_memory(double nodes, const Case& data) {
  const double modes = data.route == SolverRoute::kDirect ? 0.0 : data.mode_count;
  return 16.0 * nodes * (2.5 * modes + 2.0 * static_cast<double>(data.heading_deg.size()));
}

// The operator, the Krylov space and the columns beside them
StageEstimate estimate_radiation(const FluidCost& cost, double krylov, double columns,
                                 int threads) {
  return {.stage = "radiation",
          .memory = cost.memory + krylov + columns,
          .seconds = cost.seconds / threads};
}

StageEstimate estimate_response(const Sizes& s) {
  const double work =
      8.0 * s.headings * s.modes * (s.outputs + 4.0 * s.nodes) + 8.0 * std::pow(s.modes, 3);
  return {.stage = "response",
          .memory = 16.0 * s.headings * (s.outputs + 4.0 * s.nodes),
          .seconds = s.frequencies * work / kSparseRate};
}

// As many radiation problems as the error estimate may ask for, the latest of them held
StageEstimate estimate_seas(const Sizes& s, const StageEstimate& radiation, int threads) {
  const double columns = s.modes + s.influences;
  const double share = columns / (s.modes + s.headings);
  return {.stage = "seas",
          .memory = radiation.memory + 16.0 * s.nodes * kSeaSamples * columns +
                    8.0 * s.nodes * kSeaHeadings * threads,
          .seconds = kSeaSolves * share * radiation.seconds / std::max(1.0, s.frequencies)};
}

// What the operator and the columns leave
double krylov_budget(const Case& data, SolverMethod method, const FluidWork& work) {
  const double all = plan_budget(data);
  const double others = fluid_cost(method, work).memory + columns_memory(work.nodes, data);
  return std::max(kKrylovLeast * all, kKrylovMost * (all - others));
}

}  // namespace

SolverMethod resolve_method(const Case& data, const mesh::Q8Mesh& mesh) {
  if (data.method != SolverMethod::kAuto) return data.method;
  const FluidWork work = fluid_work(data, mesh);
  SolverMethod cheapest = SolverMethod::kDense;
  double least = fluid_cost(cheapest, work).seconds;
  for (const SolverMethod method :
       {SolverMethod::kLattice, SolverMethod::kPfft, SolverMethod::kFmm}) {
    const double seconds = fluid_cost(method, work).seconds;
    if (seconds >= least) continue;
    if (method == SolverMethod::kLattice && !bem::find_element_lattice(mesh)) continue;
    cheapest = method;
    least = seconds;
  }
  return cheapest;
}

double plan_budget(const Case& data) {
  if (data.plan_memory > 0.0) return data.plan_memory;
  return data.memory_limit > 0.0 ? data.memory_limit : kPlannedMemory;
}

KrylovPlan plan_krylov(const Case& data, const mesh::Q8Mesh& mesh) {
  const SolverMethod method = resolve_method(data, mesh);
  const FluidWork work = fluid_work(data, mesh);
  const double budget = krylov_budget(data, method, work);

  // Room for all columns in one block. Where the budget is small, single precision first, then as
  // many directions as expected: blocks of fewer columns need twice the applications
  double longest = 0.0;
  for (const double length : work.lengths) longest = std::max(longest, length);
  const double expected =
      std::ceil(1.4 * applications_a_column(longest, work.columns, work.tolerance)) + 2.0;
  const double column = 16.0 * work.nodes * work.columns;
  const auto need = [&](double steps, bool in_float) {
    return ((in_float ? 0.5 : 1.0) * steps + krylov::kScratchColumns + 1.0) * column;
  };
  KrylovPlan plan;
  double steps = std::max(kAmpleSteps, expected);
  plan.in_float = need(steps, false) > budget || gains_by_single_precision(method, data.tolerance);
  if (need(steps, plan.in_float) > budget) steps = expected;
  plan.steps = static_cast<Index>(steps);
  plan.memory = std::min(need(steps, plan.in_float), budget);
  return plan;
}

KrylovPlan longest_krylov(const Case& data, const mesh::Q8Mesh& mesh) {
  constexpr Index kSteps = 100, kMostSteps = 1000;
  constexpr double kDirections = 1000.0;  // their products with each other take memory too
  const FluidWork work = fluid_work(data, mesh);
  const double scratch = (krylov::kScratchColumns + 1.0) * work.columns;
  return {.memory = std::min((kDirections + scratch) * 16.0 * work.nodes,
                             krylov_budget(data, resolve_method(data, mesh), work)),
          .steps = kSteps,
          .in_float = false,
          .most_steps = kMostSteps};
}

Estimate estimate(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                  int threads) {
  Sizes s = sizes_of(data, mesh, plate_mesh ? *plate_mesh : mesh);
  const bool direct = data.route == SolverRoute::kDirect;
  if (direct) s.modes = 0.0;
  Estimate needed;
  const SolverMethod method = resolve_method(data, mesh);
  needed.method = method_name(method);
  needed.route = route_name(data.route);
  needed.nodes = mesh.node_count();
  const FluidWork work = fluid_work(data, mesh);
  const double krylov =
      method == SolverMethod::kDense ? 0.0 : krylov_memory(plan_krylov(data, mesh), work);
  const StageEstimate radiation = estimate_radiation(
      fluid_cost(method, work), krylov, columns_memory(s.nodes, data), std::max(1, threads));
  needed.stages = {direct ? estimate_plate(s, work) : estimate_modes(s), radiation,
                   estimate_response(s)};
  if (!data.seas.empty() || (data.sea_grid.from && data.sea_grid.to))
    needed.stages.push_back(estimate_seas(s, radiation, std::max(1, threads)));
  needed.knobs = data.memory_limit > 0.0
                     ? "a coarser mesh, fewer modes, a larger --memory"
                     : "a coarser mesh, fewer modes, --memory, with which less is planned for";

  // Mode shapes, on the plate's and the fluid's nodes, and the mesh live through all stages
  const double shared =
      kBytesOfProgram + 8.0 * (3.0 * s.plate_nodes + 4.0 * s.nodes) * s.modes + 300.0 * s.elements;
  for (const StageEstimate& stage : needed.stages) {
    needed.memory = std::max(needed.memory, shared + stage.memory);
    needed.seconds += stage.seconds;
  }
  return needed;
}

void require_budget(const Estimate& needed, double budget) {
  FLOE_VALIDATE_AS(BudgetError, needed.memory <= budget,
                   "invalid memory need = "
                       << format_bytes(needed.memory) << " by method " << needed.method << " at "
                       << needed.nodes << " nodes (must be at most " << format_bytes(budget)
                       << "; what lowers or allows it: " << needed.knobs << ")");
}

std::string format_bytes(double bytes) {
  constexpr std::array<const char*, 6> units = {"B", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  while (bytes >= 999.5 && unit + 1 < units.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  const int decimals = unit == 0 || bytes >= 99.95 ? 0 : bytes >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f} {}", bytes, decimals, units[unit]);
}

}  // namespace floe
