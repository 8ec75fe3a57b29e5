#pragma once

#include <floe/analysis.hpp>

#include <string>
#include <vector>

/// What a run writes at the top of its directory whatever its case asks for.
namespace floe::io {

/// By any route.
const std::vector<std::string>& product_names();

/// By this route, and those that it leaves out because they hold modes.
std::vector<std::string> product_names(SolverRoute route);
std::vector<std::string> left_out(SolverRoute route);

}  // namespace floe::io
