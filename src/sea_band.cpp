#include "analysis_stages.hpp"

#include <floe/hydro/flexural_gravity.hpp>
#include <floe/long_term_statistics.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>
#include <floe/sea_band.hpp>
#include <floe/sea_statistics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace floe {
namespace {

constexpr double kShareBelow = 1e-3;
constexpr double kShareAbove = 5e-3;
constexpr double kShareRefused = 0.05;
constexpr double kShareOfModes = 0.9;       // of m0: the modes should do up to there
constexpr double kShareThatMatters = 0.01;  // of the largest at any point: a free edge has none
constexpr double kShareAtEnd = 0.25;        // of a response's largest spectral value
constexpr double kHighest = 50.0;           // [rad/s]

// Where `wanted` of a sea's m0 lie below
double quantile(const wave::SeaState& sea, double wanted) {
  double low = 1e-4, high = kHighest;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (sea.variance(0.0, middle) < wanted * sea.m0() ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// What the mesh gives waves of one frequency
class MeshLook {
 public:
  MeshLook(const Case& data, const mesh::Q8Mesh& fluid, const mesh::Q8Mesh* plate_mesh,
           const plate::PlateRegions& regions)
      : data_(data), fluid_(fluid), plate_mesh_(plate_mesh), regions_(regions) {}

  Preflight at(double omega) {
    data_.omega = {omega};
    return preflight(data_, fluid_, plate_mesh_, &regions_);
  }
  double nodes(double omega) { return at(omega).resolution.front().least_nodes(); }

 private:
  Case data_;
  const mesh::Q8Mesh& fluid_;
  const mesh::Q8Mesh* plate_mesh_;
  const plate::PlateRegions& regions_;
};

// The highest frequency that the meshes resolve with the nodes wanted a wavelength
double resolved_frequency(MeshLook& look) {
  double low = 1e-3, high = kHighest;
  if (look.nodes(high) >= kNodesWanted) return high;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (look.nodes(middle) >= kNodesWanted ? low : high) = middle;
  }
  return low;
}

// A band of the case's own ends where the mesh still has nodes enough
void require_resolved(const Case& data, double to, MeshLook& look, Log& log) {
  const double nodes = look.nodes(to);
  FLOE_VALIDATE(nodes >= kNodesRequired || (data.allow_coarse && nodes >= kNodesAtLeast),
                "invalid sea_grid.omega = up to "
                    << to << " rad/s, where the mesh has " << fmt::format("{:.2g}", nodes)
                    << " nodes per wavelength (must be at least " << kNodesRequired
                    << "; end lower, refine the mesh or give --allow-coarse)");
  if (nodes < kNodesWanted)
    log.warning(
        fmt::format("coarse mesh: {:.2g} nodes per wavelength at {:.4g} rad/s, where "
                    "sea_grid.omega ends ({} or more are good)",
                    nodes, to, kNodesWanted));
}

// Where most of the seas' energy lies, the modes should do
void warn_about_few_modes(const Case& data, double to, MeshLook& look, Log& log) {
  double omega = 0.0;
  for (const wave::SeaState& sea : data.seas)
    omega = std::max(omega, std::min(to, quantile(sea, kShareOfModes)));
  const bool told =
      !data.omega.empty() && omega <= *std::max_element(data.omega.begin(), data.omega.end());
  if (omega == 0.0 || told) return;
  const std::string few = look.at(omega).few_modes;
  if (!few.empty()) log.warning(fmt::format("seas up to {:.3g} rad/s: {}", omega, few));
}

// What a share of a sea's energy outside the band means: nothing, a warning or an error
void judge(const std::string& sea, double outside, bool allowed, double from, double to,
           const std::string& remedy, Log& log) {
  const std::string told = fmt::format(
      "{}: {:.2g} % of its m0 lie outside the frequencies that are computed, {:.4g} … {:.4g} rad/s",
      sea, 100.0 * outside, from, to);
  if (outside > kShareRefused && !allowed)
    throw DataError(told + " (at most 5 %; " + remedy + ", or set allow_truncation = true)");
  if (outside > kShareTold) log.warning(told + " (" + remedy + ")");
}

// The response whose spectrum is cut the most at one end of the frequencies
struct Cut {
  double share = 0.0;  // value at the end over the largest
  std::size_t quantity = 0;
  Index point = 0;
};

Cut worst_cut(const SeaResult& result, bool at_high_end) {
  Cut worst;
  for (std::size_t q = 0; q < result.spectra.size(); ++q) {
    const MatXd& spectra = result.spectra[q];
    if (spectra.size() == 0) continue;
    const double least = kShareThatMatters * spectra.maxCoeff();
    for (Index i = 0; i < spectra.rows(); ++i) {
      const double largest = spectra.row(i).maxCoeff();
      if (!(largest > least)) continue;
      const double share = spectra(i, at_high_end ? spectra.cols() - 1 : 0) / largest;
      if (share > worst.share) worst = {share, result.quantity[q], i};
    }
  }
  return worst;
}

}  // namespace

void require_band(const wave::SeaState& sea, double from, double to, const std::string& remedy,
                  Log& log) {
  judge("sea " + sea.name, 1.0 - sea.variance(from, to) / sea.m0(), sea.allow_truncation, from, to,
        remedy, log);
}

void require_band(const wave::WaveClimate& climate, double from, double to,
                  const std::string& remedy, Log& log) {
  double outside = 0.0, all = 0.0;
  for (std::size_t j = 0; j < climate.scatter.period.size(); ++j) {
    const double energy = climate.energy(j);
    if (!(energy > 0.0)) continue;
    const wave::Spectrum spectrum = climate.spectrum(j);
    outside += energy * (1.0 - spectrum.variance(from, to) / spectrum.m0());
    all += energy;
  }
  judge("scatter " + climate.name, outside / all, climate.allow_truncation, from, to, remedy, log);
}

std::vector<std::string> cut_responses(const SeaResult& result, const Case& data) {
  std::vector<std::string> warnings;
  for (const bool high : {false, true}) {
    const Cut cut = worst_cut(result, high);
    if (cut.share <= kShareAtEnd) continue;
    warnings.push_back(fmt::format(
        "sea {}, mean heading {:g}°: the spectrum of {} at {} is {:.0f} % of its peak where the "
        "frequencies {}, {:.4g} rad/s: more of the response lies beyond (widen sea_grid.omega)",
        result.sea, result.mean_heading_deg, response::label(data.quantities[cut.quantity]),
        data.points[static_cast<std::size_t>(cut.point)].name, 100.0 * cut.share,
        high ? "end" : "begin", high ? result.omega.back() : result.omega.front()));
  }
  return warnings;
}

SeaBand prepare_seas(const Case& data, const mesh::Q8Mesh& fluid, const mesh::Q8Mesh* plate_mesh,
                     const plate::PlateRegions& regions, Log& log) {
  if (data.seas.empty() && !(data.sea_grid.from && data.sea_grid.to)) return {};
  check_zones(data, fluid, log);
  MeshLook look(data, fluid, plate_mesh, regions);
  SeaBand band{std::numeric_limits<double>::infinity(), 0.0};
  for (const wave::SeaState& sea : data.seas) {
    band.from = std::min(band.from, quantile(sea, kShareBelow));
    band.to = std::max(band.to, quantile(sea, 1.0 - kShareAbove));
  }
  if (data.sea_grid.from) band.from = *data.sea_grid.from;
  if (data.sea_grid.to) {
    band.to = *data.sea_grid.to;
    require_resolved(data, band.to, look, log);
  } else {
    band.to = std::min(band.to, resolved_frequency(look));
  }
  if (!(band.to > band.from))
    throw DataError(
        fmt::format("the mesh resolves waves up to {:.3g} rad/s, below the seas' own "
                    "frequencies from {:.3g} rad/s (refine the mesh)",
                    band.to, band.from));
  for (const wave::SeaState& sea : data.seas)
    require_band(sea, band.from, band.to, "widen sea_grid.omega, refine the mesh", log);
  warn_about_few_modes(data, band.to, look, log);
  return band;
}

}  // namespace floe
