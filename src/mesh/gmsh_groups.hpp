#pragma once

#include <floe/mesh/mesh_file.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace floe::mesh {

/// Collects the physical surfaces of a .msh file: their names, which surfaces belong to them (4.1)
/// and which quads (2.2 directly, 4.1 by the surface).
class GmshGroups {
 public:
  void name(std::int64_t group, const std::string& name) { names_[group] = name; }
  void put_surface(std::int64_t surface, std::int64_t group);
  void put_element(std::int64_t group, Index quad) { elements_[group].push_back(quad); }
  void put_element_of(std::int64_t surface, Index quad);

  /// The groups that have quads, by number; without a name they are called by it.
  std::vector<ElementGroup> named() const;

 private:
  std::map<std::int64_t, std::string> names_;
  std::map<std::int64_t, std::vector<std::int64_t>> of_surface_;
  std::map<std::int64_t, std::vector<Index>> elements_;
};

}  // namespace floe::mesh
