#include <floe/analysis.hpp>

#include <array>

namespace floe {

const char* method_name(SolverMethod method) {
  constexpr std::array<const char*, 5> names = {"auto", "dense", "lattice", "pfft", "fmm"};
  return names[static_cast<std::size_t>(method)];
}

const char* route_name(SolverRoute route) {
  return route == SolverRoute::kDirect ? "direct" : "modal";
}

}  // namespace floe
