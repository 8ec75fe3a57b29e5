#pragma once

#include <floe/analysis.hpp>

#include <string>
#include <vector>

/// What a run will take, told before anything is allocated.
namespace floe {

/// Memory held at the height of one stage, and its time.
struct StageEstimate {
  std::string stage;
  double memory = 0.0;   ///< [byte]
  double seconds = 0.0;  ///< of the whole run, all frequencies
};

struct Estimate {
  std::string method;  ///< name of the method that the run will use
  std::string route;   ///< modal or direct
  Index nodes = 0;     ///< of the fluid's mesh
  std::vector<StageEstimate> stages;
  double memory = 0.0;   ///< the largest of the stages, plus what all of them share [byte]
  double seconds = 0.0;  ///< the sum of the stages
  std::string knobs;     ///< what the user can turn to need less
};

/// The method that a case gets: its own, or for `auto` the one that takes the least time for all of
/// its frequencies by a fixed table of costs: node count, number of modes and headings, length in
/// waves, how much of the bounding rectangle the plates fill. Lattice only where all elements are
/// equal rectangles. The machine has no say.
SolverMethod resolve_method(const Case& data, const mesh::Q8Mesh& mesh);

/// The memory that methods are planned for where no limit is given [byte]: what a machine of 16 GB
/// can give.
inline constexpr double kPlannedMemory = 12e9;

/// The memory that methods are planned for [byte]: Case::plan_memory, Case::memory_limit or
/// kPlannedMemory, the first that is given. What is free at the moment only refuses, so that the
/// same case gives the same bits. A run keeps it for those that go on with it.
double plan_budget(const Case& data);

/// The Krylov space of an iterative solution.
struct KrylovPlan {
  double memory = 0.0;    ///< what all columns need together, less where the budget is small [byte]
  Index steps = 0;        ///< for which there is room
  bool in_float = false;  ///< in single precision: where double does not fit or gains nothing
  Index most_steps = 500;  ///< of all cycles together, then it has not converged
};
KrylovPlan plan_krylov(const Case& data, const mesh::Q8Mesh& mesh);

/// For what that one did not solve: double precision, a thousand directions between two restarts
/// where there is room for them, twice as many steps.
KrylovPlan longest_krylov(const Case& data, const mesh::Q8Mesh& mesh);

/// Sizes follow from the counts of the case; times from fixed rates of a current core (a factor of
/// two either way), so that the same case gives the same plan on every machine. `plate_mesh` is the
/// plate's own mesh, null if it shares the fluid's; `threads` ≥ 1.
Estimate estimate(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                  int threads);

/// Throws BudgetError naming the numbers and the knobs when the estimate exceeds `budget` [byte].
void require_budget(const Estimate& needed, double budget);

/// "1.50 GB", "20.3 MB": decimal units, three digits.
std::string format_bytes(double bytes);

}  // namespace floe
