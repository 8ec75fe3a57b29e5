#pragma once

#include <floe/analysis.hpp>
#include <floe/estimate.hpp>
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
  double tolerance = 1e-6;      ///< of the residuals
};

FluidWork fluid_work(const Case& data, const mesh::Q8Mesh& mesh);

struct FluidCost {
  double memory = 0.0;   ///< beside the Krylov space and the columns themselves [byte]
  double seconds = 0.0;  ///< of one thread, all frequencies
};

/// Steps' applications a column: with the length of the plates in waves, the digits asked for, and
/// more the fewer columns share a space. Measured from kL = 31 to 240 and from 1 to 150 columns,
/// see docs/theory/solver.md.
double applications_a_column(double length, double columns, double tolerance);

/// Whether the steps go with cheaper sums, the residual with accurate ones (S.8): on general meshes
/// where the tolerance asked for needs accurate ones.
bool has_cheaper_steps(SolverMethod method, double tolerance);

/// Whether a basis in single precision costs less than one in double: with cheaper steps, whose
/// residuals are recomputed anyway, and on a lattice, where to orthogonalise is half of the work.
bool gains_by_single_precision(SolverMethod method, double tolerance);

/// What the iteration will hold beside x and b in its longest solve: directions and scratch [byte].
double krylov_memory(const KrylovPlan& plan, const FluidWork& work);

/// By one of the methods, not `auto`: fixed rates of one current core, rounded, so that the same
/// case gives the same figures on every machine.
FluidCost fluid_cost(SolverMethod method, const FluidWork& work);

}  // namespace floe
