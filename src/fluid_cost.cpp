#include "fluid_cost.hpp"

#include "analysis_stages.hpp"

#include <floe/krylov/gmres.hpp>
#include <floe/wave/dispersion.hpp>

#include <algorithm>
#include <cmath>

namespace floe {
namespace {

constexpr double kFactorRate = 2.5e10;        // complex LU and products [flop/s]
constexpr double kKernelRate = 5e7;           // Green function and weights [evaluations/s]
constexpr double kSmallWork = 0.04;           // grids, plans and steps of the smallest mesh [s]
constexpr double kPointsPerElement = 9.0;     // far quadrature
constexpr double kNearWork = 2000.0;          // kernel evaluations of the near elements, a node
constexpr double kBytesOfIntegrals = 1000.0;  // rules, locator and sources, a node
constexpr double kOrthogonalising = 2e-9;     // of a node and pair of directions [s]
constexpr double kReadingOff = 1e-6;          // matrices and checks, a node and column [s]

constexpr double kCheaperStepsBelow = 3e-5;  // tolerances for which they pay
constexpr double kPasses = 2.0;              // of cheaper steps, and what they cost in directions
constexpr double kCheaperStepsMore = 1.35;
constexpr double kSinglePrecisionFrom = 5e-7;  // its rounding leaves residuals of 3e-7

// One node's share: seconds of a step's application with its preconditioner, of the same for each
// bounding box that the plates would fill, of an application that recomputes a residual, of the
// set-up a frequency and of the plan; bytes held. Where steps are cheaper they have their own sums
struct Rates {
  double application, box_application, check, setup, plan, bytes, box_bytes;
};

Rates rates_of(SolverMethod method, bool cheaper_steps) {
  if (method == SolverMethod::kLattice) return {1.0e-7, 1.0e-7, 2e-7, 6e-7, 3e-6, 300.0, 200.0};
  if (method == SolverMethod::kPfft)
    return cheaper_steps ? Rates{2.7e-7, 1.0e-7, 1.4e-6, 4e-5, 2.5e-4, 10500.0, 500.0}
                         : Rates{2.7e-7, 1.0e-7, 3.7e-7, 1e-5, 8.5e-5, 3500.0, 200.0};
  return cheaper_steps ? Rates{4.5e-7, 0.5e-7, 3.5e-6, 1e-4, 2.5e-4, 16000.0, 50.0}
                       : Rates{4.5e-7, 0.5e-7, 5.0e-7, 3e-5, 1.05e-4, 4500.0, 50.0};
}

// Waves whose pressure is solved for by itself: all where forces need it, else those of the fields
double waves_by_themselves(const Case& data) {
  if (data.route == SolverRoute::kDirect) return 0.0;
  if (wants_pressure(data)) return static_cast<double>(data.heading_deg.size());
  const double count = static_cast<double>(data.omega.size());
  return std::min(1.0,
                  (data.fields.empty() ? 10.0 : static_cast<double>(data.fields.size())) / count);
}

FluidCost dense_cost(const FluidWork& work) {
  const double n = work.nodes;
  const double assembly = n * (work.elements * kPointsPerElement + kNearWork) / kKernelRate;
  const double factor = 8.0 / 3.0 * n * n * n / kFactorRate;
  const double solve = 8.0 * n * n * (work.columns + work.later_columns) / kFactorRate;
  return {.memory = 32.0 * n * n,
          .seconds = static_cast<double>(work.lengths.size()) * (assembly + factor + solve)};
}

}  // namespace

FluidWork fluid_work(const Case& data, const mesh::Q8Mesh& mesh) {
  const Point2 extent = mesh.upper() - mesh.lower();
  FluidWork work{.nodes = static_cast<double>(mesh.node_count()),
                 .elements = static_cast<double>(mesh.element_count()),
                 .box = std::max(1.0, extent.prod() / mesh.area()),
                 .lengths = {},
                 .columns = data.route == SolverRoute::kDirect
                                ? static_cast<double>(data.heading_deg.size())
                                : static_cast<double>(data.mode_count),
                 .later_columns = waves_by_themselves(data),
                 .tolerance = data.tolerance};
  for (const double omega : data.omega)
    work.lengths.push_back(wave::wavenumber(omega, data.water) * extent.maxCoeff());
  return work;
}

double applications_a_column(double length, double columns, double tolerance) {
  const double sharing = std::pow(30.0 / std::max(1.0, columns), columns < 30.0 ? 0.45 : 0.2);
  return (4.8 + 0.041 * length) * sharing * std::log10(std::min(0.1, tolerance)) / -6.0;
}

bool has_cheaper_steps(SolverMethod method, double tolerance) {
  return (method == SolverMethod::kPfft || method == SolverMethod::kFmm) &&
         tolerance < kCheaperStepsBelow;
}

double krylov_memory(const KrylovPlan& plan, const FluidWork& work) {
  constexpr double kProducts = 3.0;  // square matrices of the directions' products
  double longest = 0.0;
  for (const double length : work.lengths) longest = std::max(longest, length);
  const double column = 16.0 * work.nodes, kept = plan.in_float ? 0.5 : 1.0;
  const double directions =
      std::min(work.columns * applications_a_column(longest, work.columns, work.tolerance) *
                   (plan.in_float ? kCheaperStepsMore : 1.0),
               plan.memory / (kept * column));
  return std::min(plan.memory,
                  column * (kept * directions + krylov::kScratchColumns * work.columns)) +
         kProducts * 16.0 * directions * directions;
}

bool gains_by_single_precision(SolverMethod method, double tolerance) {
  return has_cheaper_steps(method, tolerance) ||
         (method == SolverMethod::kLattice && tolerance >= kSinglePrecisionFrom);
}

FluidCost fluid_cost(SolverMethod method, const FluidWork& work) {
  if (method == SolverMethod::kDense) return dense_cost(work);
  const bool cheaper = has_cheaper_steps(method, work.tolerance);
  const Rates rates = rates_of(method, cheaper);
  const double application = rates.application + rates.box_application * work.box;
  double seconds = rates.plan;  // a node
  for (const double length : work.lengths) {
    seconds += rates.setup;
    for (const double columns : {work.columns, work.later_columns}) {
      if (columns == 0.0) continue;
      const double directions = columns * applications_a_column(length, columns, work.tolerance) *
                                (cheaper ? kCheaperStepsMore : 1.0);
      seconds += directions * application + (cheaper ? kPasses : 1.0) * columns * rates.check +
                 kOrthogonalising * directions * directions + kReadingOff * columns;
    }
  }
  return {.memory = work.nodes * (rates.bytes + rates.box_bytes * work.box + kBytesOfIntegrals),
          .seconds = work.nodes * seconds + kSmallWork * static_cast<double>(work.lengths.size())};
}

}  // namespace floe
