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
  std::string method;  ///< the method that the run will use: "dense"
  Index nodes = 0;     ///< of the fluid's mesh
  std::vector<StageEstimate> stages;
  double memory = 0.0;   ///< the largest of the stages, plus what all of them share [byte]
  double seconds = 0.0;  ///< the sum of the stages
  std::string knobs;     ///< what the user can turn to need less
};

/// Sizes follow from the counts of the case; times from fixed rates of a current core (a factor of
/// two either way), so that the same case gives the same plan on every machine. `threads` ≥ 1.
Estimate estimate(const Case& data, const mesh::Q8Mesh& mesh, int threads);

/// Throws BudgetError naming the numbers and the knobs when the estimate exceeds `budget` [byte].
void require_budget(const Estimate& needed, double budget);

/// "1.50 GB", "20.3 MB": decimal units, three digits.
std::string format_bytes(double bytes);

}  // namespace floe
