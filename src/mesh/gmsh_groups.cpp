#include "mesh/gmsh_groups.hpp"

#include <algorithm>

namespace floe::mesh {

void GmshGroups::put_surface(std::int64_t surface, std::int64_t group) {
  std::vector<std::int64_t>& groups = of_surface_[surface];
  if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
}

void GmshGroups::put_element_of(std::int64_t surface, Index quad) {
  const auto groups = of_surface_.find(surface);
  if (groups == of_surface_.end()) return;
  for (const std::int64_t group : groups->second) put_element(group, quad);
}

std::vector<ElementGroup> GmshGroups::named() const {
  std::vector<ElementGroup> groups;
  for (const auto& [number, elements] : elements_) {
    const auto name = names_.find(number);
    groups.push_back({name == names_.end() ? std::to_string(number) : name->second, elements});
  }
  return groups;
}

}  // namespace floe::mesh
