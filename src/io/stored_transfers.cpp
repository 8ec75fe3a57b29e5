#include <floe/io/stored_transfers.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/response/stations.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace floe::io {
namespace {

constexpr double kTurn = 360.0;

double on_circle(double degrees) {
  const double angle = std::remainder(degrees, kTurn);
  return angle < 0.0 ? angle + kTurn : angle;
}

// Places of the headings 0, 360°/n, …; empty where they are others
std::vector<Index> around_the_circle(const std::vector<double>& heading_deg) {
  std::vector<Index> order(heading_deg.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto angle = [&](Index b) { return on_circle(heading_deg[static_cast<std::size_t>(b)]); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return angle(a) < angle(b); });
  const double step = kTurn / static_cast<double>(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (std::abs(angle(order[i]) - static_cast<double>(i) * step) > 1e-6) return {};
  return order.size() % 4 == 0 ? order : std::vector<Index>{};
}

MatXd deflections(const plate::DryModes& modes) {
  return modes.shape(Eigen::seq(0, Eigen::last, plate::kUnknownsPerNode), Eigen::all);
}

// Deflection of the modes at the stations of all lines
MatXd at_lines(const mesh::Q8Mesh& mesh, const MatXd& deflection,
               const std::vector<NamedLine>& lines) {
  MatXd all(0, deflection.cols());
  for (const NamedLine& line : lines) {
    const std::vector<std::string> names(static_cast<std::size_t>(line.count), line.name);
    const MatXd own = response::interpolation_to(
                          mesh, response::line_stations(line.from, line.to, line.count), names) *
                      deflection;
    all.conservativeResize(all.rows() + own.rows(), Eigen::NoChange);
    all.bottomRows(own.rows()) = own;
  }
  return all;
}

}  // namespace

StoredTransfers::StoredTransfers(const StoredRun& run) : run_(run) {
  if (!run.has_transfers()) {
    take_from_waves();
    return;
  }
  observation_ = run.observation();
  grid_ = run.sea_grid();
}

SeaTransfer StoredTransfers::transfer(std::size_t place) const {
  return of_waves_.empty() ? run_.transfer(place) : of_waves_.at(place);
}

// The state of a wave is ξ and every quantity at every point
void StoredTransfers::take_from_waves() {
  const Case& data = run_.data();
  const std::vector<Index> order = around_the_circle(data.heading_deg);
  const std::vector<FrequencyResult> results = run_.frequencies();
  FLOE_VALIDATE_AS(StoreError, !order.empty() && results.size() >= 2,
                   run_.directory().string()
                       << " holds no transfer functions for seas (run the case with a [[sea]], or "
                          "with sea_grid.omega = { from, to }, or with two or more frequencies and "
                          "headings all around the circle in [waves], 0, 360/n, …, n a multiple of "
                          "four)");

  // What the points, lines and nodes see of a state
  const mesh::Q8Mesh plate_mesh = run_.mode_mesh(), fluid_mesh = run_.fluid_mesh();
  const plate::DryModes modes = run_.modes();
  const Index points = static_cast<Index>(data.points.size());
  const Index rows = points * static_cast<Index>(data.quantities.size());
  observation_.points = MatXd::Zero(rows, modes.count() + rows);
  observation_.points.rightCols(rows).setIdentity();
  for (std::size_t q = 0; q < data.quantities.size(); ++q) observation_.quantity.push_back(q);
  observation_.derivative.assign(data.quantities.size(), 0);
  observation_.phase.assign(data.quantities.size(), 0.0);
  observation_.lines = at_lines(plate_mesh, deflections(modes), data.lines);
  observation_.nodes = data.plate_mesh.empty()
                           ? deflections(modes)
                           : deflections(plate::interpolate_modes(modes, plate_mesh, fluid_mesh));

  for (const FrequencyResult& result : results) {
    grid_.omega.push_back(result.omega);
    MatXcd state(modes.count() + rows, static_cast<Index>(order.size()));
    state.topRows(modes.count()) = result.amplitudes(Eigen::all, order);
    for (std::size_t q = 0; q < data.quantities.size(); ++q)
      state.middleRows(modes.count() + static_cast<Index>(q) * points, points) =
          result.point_quantities.at(q)(Eigen::all, order);
    of_waves_.push_back({result.omega, std::move(state)});
  }
  grid_.headings = static_cast<int>(order.size());
  grid_.solved_frequencies = static_cast<int>(results.size());

  if (results.size() < data.omega.size())
    warnings_.push_back(
        fmt::format("{} of the {} frequencies of the run have no result; spectra are integrated "
                    "across the gaps",
                    data.omega.size() - results.size(), data.omega.size()));

  // As many headings as the response to the shortest wave has harmonics
  const double radius = 0.5 * (fluid_mesh.upper() - fluid_mesh.lower()).norm();
  const double needed = 2.0 * wave::wavenumber(grid_.omega.back(), data.water) * radius + 20.0;
  if (grid_.headings < needed)
    warnings_.push_back(
        fmt::format("the {} headings of the run do not resolve the response at {:.4g} rad/s "
                    "({:.0f} would)",
                    grid_.headings, grid_.omega.back(), std::ceil(needed / 4.0) * 4.0));
}

}  // namespace floe::io
