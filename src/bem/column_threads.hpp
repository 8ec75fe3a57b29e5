#pragma once

#include <floe/numeric/types.hpp>

#include <omp.h>

#include <algorithm>

namespace floe::bem {

/// Nodes of plates whose columns are shared out among the threads whole: one column is little work
/// then, and its grids stay in cache.
inline constexpr Index kSmallPlate = 20000;

/// Calls work(begin, end) for ranges of columns: a range a thread for a small plate, so that what
/// is parallel within a column runs on that thread alone, else all columns at once. The calls may
/// be concurrent.
template <class Work>
void for_columns(Index nodes, Index columns, const Work& work) {
  const Index threads = std::min<Index>(columns, omp_get_max_threads());
  if (nodes > kSmallPlate || threads < 2 || omp_in_parallel()) return work(Index{0}, columns);

    // NOTE: not one region with `if`: within it, inner regions would start new threads each time
#pragma omp parallel for schedule(static)
  for (Index t = 0; t < threads; ++t) work(columns * t / threads, columns * (t + 1) / threads);
}

}  // namespace floe::bem
