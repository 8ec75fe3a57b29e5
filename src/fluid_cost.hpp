#pragma once

#include <floe/analysis.hpp>
#include <floe/mesh/q8_mesh.hpp>

#include <vector>

namespace floe {

/// What the fluid's equation is asked for, in numbers.
struct FluidWork {
  double nodes = 0.0;
  double elements = 0.0;
  double box = 1.0;             ///< area of the bounding rectangle over that of the plates, ≥ 1
  std::vector<double> lengths;  ///< k times the longer side of the box, one a frequency
  double columns = 0.0;         ///< solved together: modes, or headings of the direct route
  double later_columns = 0.0;   ///< solved by themselves: waves whose pressure is wanted
};

FluidWork fluid_work(const Case& data, const mesh::Q8Mesh& mesh);

struct FluidCost {
  double memory = 0.0;   ///< beside the Krylov space and the columns themselves [byte]
  double seconds = 0.0;  ///< of one thread, all frequencies
};

/// Operator applications a column to 1e-6: with the length of the plates in waves, and more the
/// fewer columns share a space. Measured from kL = 31 to 240 and from 1 to 100 columns, see
/// docs/theory/solver.md.
double applications_a_column(double length, double columns);

/// By one of the methods, not `auto`: fixed rates of one current core, rounded, so that the same
/// case gives the same figures on every machine.
FluidCost fluid_cost(SolverMethod method, const FluidWork& work);

}  // namespace floe
