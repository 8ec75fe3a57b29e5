#include "io/product_names.hpp"

#include <algorithm>

namespace floe::io {

const std::vector<std::string>& product_names() {
  static const std::vector<std::string> names = {"dry_modes.csv",      "rao_points.csv",
                                                 "rao_lines.csv",      "rao_quantities.csv",
                                                 "wave_points.csv",    "hydro_coefficients.csv",
                                                 "exciting_force.csv", "fields.pvd",
                                                 "result.nc",          "run.json"};
  return names;
}

std::vector<std::string> product_names(SolverRoute route) {
  std::vector<std::string> names = product_names();
  const std::vector<std::string> without = left_out(route);
  std::erase_if(names, [&](const std::string& name) {
    return std::find(without.begin(), without.end(), name) != without.end();
  });
  return names;
}

std::vector<std::string> left_out(SolverRoute route) {
  if (route == SolverRoute::kModal) return {};
  return {"dry_modes.csv", "hydro_coefficients.csv", "exciting_force.csv", "result.nc"};
}

}  // namespace floe::io
