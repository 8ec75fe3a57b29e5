#include "io/netcdf_parts.hpp"

#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::array<const char*, 4> kMoments = {"m0", "m1", "m2", "m4"};

// One number a sea and mean heading
template <typename Value>
void add_series(NetcdfFile& file, const std::vector<SeaResult>& seas, const std::string& name,
                const std::string& long_name, const std::string& units, Value value) {
  std::vector<double> values;
  for (const SeaResult& sea : seas) values.push_back(value(sea));
  file.add_numbers(name, {"sea_state"}, values);
  describe(file, name, long_name, units);
}

// Crossings of zero upwards: where nothing moves there are none
double period(double m0, double m2) {
  return m2 > 0.0 ? 2.0 * std::numbers::pi * std::sqrt(m0 / m2) : 0.0;
}

void add_sea_states(NetcdfFile& file, const std::vector<SeaResult>& seas) {
  std::vector<std::string> names;
  for (const SeaResult& sea : seas) names.push_back(sea.sea);
  file.add_dimension("sea_state", seas.size());
  file.add_texts("sea_name", {"sea_state"}, names);
  describe(file, "sea_name", "Sea of each sea state: one a mean heading");
  add_series(file, seas, "sea_wave_direction", "Mean wave direction", "rad",
             [](const SeaResult& sea) { return kDegree * sea.mean_heading_deg; });
  add_series(file, seas, "significant_height",
             "Significant wave height 4 sqrt(m0), all frequencies", "m",
             [](const SeaResult& sea) { return sea.significant_height; });
  add_series(file, seas, "share_outside", "Share of the waves' m0 beyond sea_omega", "1",
             [](const SeaResult& sea) { return sea.share_outside; });
}

// Deflection everywhere
void add_nodes(NetcdfFile& file, const std::vector<SeaResult>& seas, const std::string& node) {
  const auto nodes = static_cast<std::size_t>(seas.front().node_moments.rows());
  for (const char* name : {"response_std", "response_Tz"})
    file.define_parts(name, {"sea_state", node}, 1);
  describe(file, "response_std", "Standard deviation of the deflection", "m");
  describe(file, "response_Tz", "Zero-crossing period of the deflection", "s",
           "2 pi sqrt(m0/m2); 0 where nothing moves");
  for (std::size_t s = 0; s < seas.size(); ++s) {
    std::vector<double> deviation, crossing;
    for (std::size_t n = 0; n < nodes; ++n) {
      const auto moments = seas[s].node_moments.row(static_cast<Index>(n));
      deviation.push_back(std::sqrt(moments[0]));
      crossing.push_back(period(moments[0], moments[2]));
    }
    file.put_part("response_std", {s, 0}, {1, nodes}, deviation);
    file.put_part("response_Tz", {s, 0}, {1, nodes}, crossing);
  }
}

// A number of each sea state, quantity and point
template <typename Value>
void add_statistic(NetcdfFile& file, const std::vector<SeaResult>& seas, const std::string& name,
                   const std::string& long_name, const std::string& comment, Value value) {
  std::vector<double> values;
  for (const SeaResult& sea : seas)
    for (const MatXd& moments : sea.moments)
      for (Index i = 0; i < moments.rows(); ++i) values.push_back(value(moments.row(i)));
  file.add_numbers(name, {"sea_state", "sea_quantity", "point"}, values);
  describe(file, name, long_name, "", comment);
}

// Spectra and moments at the points
void add_quantities(NetcdfFile& file, const Case& data, const std::vector<SeaResult>& seas) {
  const SeaResult& first = seas.front();
  std::vector<std::string> names, units;
  for (const std::size_t q : first.quantity) {
    names.emplace_back(response::name(data.quantities[q]));
    units.emplace_back(response::unit(data.quantities[q]));
  }
  add_axis(file, "sea_quantity", names, "Quantity at points, in seas");
  file.add_texts("sea_quantity_units", {"sea_quantity"}, units);
  describe(file, "sea_quantity_units", "Unit of each quantity");
  file.add_dimension("sea_omega", first.omega.size());
  file.add_numbers("sea_omega", {"sea_omega"}, first.omega);
  describe(file, "sea_omega", "Angular frequency of the spectra", "rad/s");

  std::vector<double> spectra;
  for (const SeaResult& sea : seas)
    for (const MatXd& spectrum : sea.spectra) {
      const MatXd columns = spectrum.transpose();  // points run outside frequencies
      spectra.insert(spectra.end(), columns.data(), columns.data() + columns.size());
    }
  file.add_numbers("response_psd", {"sea_state", "sea_quantity", "point", "sea_omega"}, spectra,
                   Compression::kDeflate);
  describe(file, "response_psd", "One-sided response spectrum", "",
           "square of sea_quantity_units times s/rad");
  for (std::size_t k = 0; k < kMoments.size(); ++k)
    add_statistic(file, seas, kMoments[k],
                  std::string("Spectral moment ") + kMoments[k] + " of the response",
                  "integral of omega^" + std::string(kMoments[k] + 1) + " S over sea_omega",
                  [k](const auto& moments) { return moments[static_cast<Index>(k)]; });
  add_statistic(file, seas, "Tz", "Zero-crossing period [s]",
                "2 pi sqrt(m0/m2); 0 where nothing moves",
                [](const auto& moments) { return period(moments[0], moments[2]); });
}

}  // namespace

void add_seas(NetcdfFile& file, const StoredRun& run) {
  const std::vector<SeaResult> seas = run.seas();
  if (seas.empty()) return;
  add_sea_states(file, seas);
  add_nodes(file, seas, run.data().plate_mesh.empty() ? "node" : "fluid_node");
  if (!run.data().points.empty() && !seas.front().quantity.empty())
    add_quantities(file, run.data(), seas);
}

}  // namespace floe::io
