#include <floe/analysis.hpp>

#include <array>

namespace floe {

const char* method_name(SolverMethod method) {
  constexpr std::array<const char*, 5> names = {"auto", "dense", "lattice", "pfft", "fmm"};
  return names[static_cast<std::size_t>(method)];
}

}  // namespace floe
