#pragma once

#include <floe/analysis.hpp>

namespace floe {

/// What the records and products of a run take on the disk, about [byte]. Follows from the counts
/// of the case alone; fields count in full, tables with the usual length of their numbers.
double estimate_disk(const Case& data, const mesh::Q8Mesh& mesh);

/// Throws BudgetError with both numbers when less than `needed` is free [byte]; `place` is a folder
/// there.
void require_disk(double needed, double free, const std::string& place);

}  // namespace floe
