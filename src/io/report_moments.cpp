#include "io/report_moments.hpp"

#include "io/packed_array.hpp"

#include <floe/plate/section_forces.hpp>

namespace floe::io {

nlohmann::ordered_json moments_json(const ReportContent& content, const mesh::Drawing& drawing) {
  const MatXd forces = plate::section_forces(content.mesh, content.data.plate, content.modes.shape);
  const auto component = [&](plate::SectionForce force) {
    nlohmann::ordered_json modes = nlohmann::ordered_json::array();
    for (Index mode = 0; mode < content.modes.count(); ++mode) {
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
