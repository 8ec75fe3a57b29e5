#include "io/report_moments.hpp"

#include "io/packed_array.hpp"

#include <floe/plate/section_forces.hpp>

namespace floe::io {

nlohmann::ordered_json moments_json(const ReportContent& content, const MatXd& shapes,
                                    const mesh::Drawing& drawing) {
  const Case& data = content.data;
  if (data.structure || (!data.regions.empty() && !content.regions)) return nullptr;
  const plate::PlateRegions regions = content.regions.value_or(data.plate);
  const MatXd forces = plate::section_forces(content.mesh, regions, shapes);
  const auto component = [&](plate::SectionForce force) {
    nlohmann::ordered_json modes = nlohmann::ordered_json::array();
    for (Index mode = 0; mode < shapes.cols(); ++mode) {
      std::vector<double> values;
      for (const Index node : drawing.nodes)
        values.push_back(forces(plate::kSectionForces * node + force, mode));
      modes.push_back(packed_short(values));
    }
    return modes;
  };
  return {{"x", component(plate::kBendingMomentX)}, {"y", component(plate::kBendingMomentY)}};
}

}  // namespace floe::io
