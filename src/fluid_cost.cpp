#include "fluid_cost.hpp"

#include "analysis_stages.hpp"

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

// One node's share: seconds of an application (with preconditioner), of the same for each bounding
// box that the plates would fill, of the set-up a frequency and of the plan; bytes held
struct Rates {
  double application, box_application, setup, plan, bytes, box_bytes;
};

Rates rates_of(SolverMethod method) {
  if (method == SolverMethod::kLattice) return {1.0e-7, 1.0e-7, 6e-7, 1e-7, 300.0, 200.0};
  if (method == SolverMethod::kPfft) return {2.0e-7, 1.0e-7, 6e-6, 8.5e-5, 4300.0, 200.0};
  return {6e-7, 0.5e-7, 1.9e-5, 1.05e-4, 7000.0, 50.0};
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
                 .later_columns = waves_by_themselves(data)};
  for (const double omega : data.omega)
    work.lengths.push_back(wave::wavenumber(omega, data.water) * extent.maxCoeff());
  return work;
}

double applications_a_column(double length, double columns) {
  return (4.5 + 0.047 * length) * std::pow(30.0 / std::max(1.0, columns), 0.4);
}

FluidCost fluid_cost(SolverMethod method, const FluidWork& work) {
  if (method == SolverMethod::kDense) return dense_cost(work);
  const Rates rates = rates_of(method);
  const double application = rates.application + rates.box_application * work.box;
  double seconds = rates.plan;  // a node
  for (const double length : work.lengths) {
    seconds += rates.setup;
    for (const double columns : {work.columns, work.later_columns}) {
      if (columns == 0.0) continue;
      const double directions = columns * applications_a_column(length, columns);
      seconds += directions * application + 16.0 * directions * directions / kFactorRate;
    }
  }
  return {.memory = work.nodes * (rates.bytes + rates.box_bytes * work.box + kBytesOfIntegrals),
          .seconds = work.nodes * seconds + kSmallWork * static_cast<double>(work.lengths.size())};
}

}  // namespace floe
