#include "io/node_spectra_file.hpp"

#include <floe/numeric/error.hpp>

#include <string>
#include <vector>

namespace floe::io {

NodeSpectraFile::NodeSpectraFile(const std::filesystem::path& folder, const mesh::Q8Mesh& mesh,
                                 const std::vector<wave::SeaState>& seas,
                                 const std::vector<double>& omega)
    : pending_(folder / kName), file_(NetcdfFile::create_classic(pending_.temporary())) {
  std::vector<std::string> names;
  std::vector<double> headings;
  for (const wave::SeaState& sea : seas)
    for (const double heading : sea.mean_heading_deg) {
      names.push_back(sea.name);
      headings.push_back(heading);
    }
  file_.add_dimension("sea", names.size());
  file_.add_dimension("omega", omega.size());
  file_.add_dimension("node", static_cast<std::size_t>(mesh.node_count()));
  file_.add_texts("sea_name", {"sea"}, names);
  file_.add_numbers("mean_heading_deg", {"sea"}, headings);
  file_.add_numbers("omega", {"omega"}, omega);
  file_.add_attribute("omega", "units", "rad/s");
  for (const int axis : {0, 1}) {
    const std::string name = axis == 0 ? "x" : "y";
    const VecXd values = mesh.nodes().row(axis).transpose();
    file_.add_numbers(name, {"node"}, {values.data(), static_cast<std::size_t>(values.size())});
    file_.add_attribute(name, "units", "m");
  }
  file_.define_parts("spectrum", {"sea", "omega", "node"}, 2);
  file_.add_attribute("spectrum", "units", "m^2 s/rad");
  file_.add_attribute("spectrum", "long_name",
                      "one-sided spectrum of the deflection over angular frequency");
}

void NodeSpectraFile::put(std::size_t result, std::size_t frequency, const VecXd& spectrum) {
  FLOE_VALIDATE_AS(ConvergenceError, spectrum.allFinite(),
                   "invalid spectrum in " << kName << " (must be finite)");
  const auto nodes = static_cast<std::size_t>(spectrum.size());
  file_.put_part("spectrum", {result, frequency, 0}, {1, 1, nodes}, {spectrum.data(), nodes});
}

void NodeSpectraFile::commit() {
  file_.close();
  pending_.commit();
}

}  // namespace floe::io
