#include <floe/analysis.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace floe {
namespace {

const mesh::ElementGroup& find_group(const std::string& name,
                                     const std::vector<mesh::ElementGroup>& groups) {
  const auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const mesh::ElementGroup& g) { return g.name == name; });
  if (group != groups.end()) return *group;
  std::vector<std::string> known;
  for (const mesh::ElementGroup& g : groups) known.push_back(g.name);
  throw InputError(fmt::format(
      "invalid plate.region.name = {} (must be a group of the mesh's elements, {})", name,
      known.empty() ? "of which it has none: physical surfaces of Gmsh, cell data region of VTU"
                    : fmt::format("one of {}", fmt::join(known, ", "))));
}

}  // namespace

const MeshSource& plate_source(const Case& data) {
  return data.plate_mesh.empty() ? data.mesh : data.plate_mesh.front();
}

plate::PlateRegions plate_regions(const Case& data, Index element_count,
                                  const std::vector<mesh::ElementGroup>& groups) {
  if (data.regions.empty()) return data.plate;
  std::vector<plate::PlateProperties> properties{data.plate};
  std::vector<int> of_element(element_count, 0);
  for (const PlateRegion& region : data.regions) {
    const auto number = static_cast<int>(properties.size());
    properties.push_back(region.properties);
    for (const Index element : find_group(region.name, groups).elements) {
      int& own = of_element[element];
      FLOE_VALIDATE(own == 0, "invalid plate.region.name = "
                                  << region.name << ": element " << element + 1
                                  << " lies in the region " << data.regions[own - 1].name
                                  << " too (must lie in one)");
      own = number;
    }
  }
  return {std::move(properties), std::move(of_element)};
}

plate::PlateRegions plate_regions(const Case& data) {
  if (data.regions.empty()) return data.plate;
  const mesh::MeshFile file = load_mesh(plate_source(data));
  return plate_regions(data, file.mesh.element_count(), file.groups);
}

}  // namespace floe
