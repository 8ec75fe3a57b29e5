#include "io/csv_table.hpp"
#include "io/vtu.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/green/green_table.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/hydro/wave_field.hpp>
#include <floe/io/interchange.hpp>
#include <floe/mesh/point_locator.hpp>
#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kMostPoints = 4e6;

std::string wave_name(const NodeField& field) {
  return "omega_" + shortest(field.omega) + "_heading_" + shortest(field.heading_deg);
}

// One period of the plate's motion
void write_animation(const std::filesystem::path& folder, const mesh::Q8Mesh& mesh,
                     const NodeField& field, int phases, std::vector<std::string>& files) {
  std::vector<PvdEntry> frames;
  for (int i = 0; i < phases; ++i) {
    const double phase = kTurn * i / phases;
    files.push_back(fmt::format("plate_{}_phase_{:03}.vtu", wave_name(field), i));
    write_phase_vtu(folder / files.back(), mesh, field, phase);
    frames.push_back({.omega = phase / field.omega, .heading = 0, .file = files.back()});
  }
  files.push_back("plate_" + wave_name(field) + ".pvd");
  write_pvd(folder / files.back(), frames);
}

// Around the bounding box of the plate
PointGrid grid_around(const mesh::Q8Mesh& mesh, const ParaviewOptions& options) {
  const double step = options.step;
  FLOE_VALIDATE(step > 0.0 && std::isfinite(step),
                "invalid step = " << step << " m (must be positive)");
  FLOE_VALIDATE(options.margin >= 0.0 && std::isfinite(options.margin),
                "invalid margin = " << options.margin << " m (must not be negative)");
  const Point2 size = mesh.upper() - mesh.lower() + Point2::Constant(2.0 * options.margin);
  const double columns = std::ceil(size.x() / step) + 1.0, rows = std::ceil(size.y() / step) + 1.0;
  FLOE_VALIDATE(columns * rows <= kMostPoints,
                "invalid step = " << step << " m: " << columns << " x " << rows
                                  << " points (must be at most " << kMostPoints << ")");
  return {.origin = mesh.lower() - Point2::Constant(options.margin),
          .step = step,
          .columns = static_cast<Index>(columns),
          .rows = static_cast<Index>(rows)};
}

// The water around the plate and under it
class Surface {
 public:
  Surface(const StoredRun& run, const mesh::Q8Mesh& mesh, const ParaviewOptions& options)
      : run_(run), mesh_(mesh), integrals_(mesh), grid_(grid_around(mesh, options)) {
    points_ = grid_.points();
    const mesh::PointLocator locator(mesh);
    for (Index i = 0; i < points_.cols(); ++i)
      on_plate_.push_back(locator.locate(points_.col(i)) ? 1 : 0);
  }

  // All fields of one frequency
  void write(const std::filesystem::path& folder, const FrequencyResult& result,
             std::vector<std::string>& files) {
    const wave::Water& water = run_.data().water;
    std::vector<double> heading;
    MatXcd pressure(mesh_.node_count(), static_cast<Index>(result.fields.size()));
    for (std::size_t i = 0; i < result.fields.size(); ++i) {
      heading.push_back(result.fields[i].heading_deg * kTurn / 360.0);
      pressure.col(static_cast<Index>(i)) = result.fields[i].pressure;
    }
    const double reach =
        grid_.step *
        Point2(static_cast<double>(grid_.columns), static_cast<double>(grid_.rows)).norm();
    const green::GreenTable green(
        green::GreenFunction(wave::deep_wavenumber(result.omega, water), water.depth), reach);
    const MatXcd elevation = hydro::wave_elevation(
        integrals_, green, water, points_,
        hydro::incident_elevation(points_, result.wavenumber, heading), pressure);
    for (std::size_t i = 0; i < result.fields.size(); ++i) {
      const NodeField& field = result.fields[i];
      files.push_back("water_" + wave_name(field) + ".vti");
      write_surface_vti(folder / files.back(), grid_, elevation.col(static_cast<Index>(i)),
                        on_plate_, field.omega, field.heading_deg);
      const auto& headings = run_.data().heading_deg;
      const auto place = std::find(headings.begin(), headings.end(), field.heading_deg);
      entries_.push_back({field.omega, static_cast<int>(place - headings.begin()), files.back()});
    }
  }

  void write_collection(const std::filesystem::path& folder, std::vector<std::string>& files) {
    files.emplace_back("water.pvd");
    write_pvd(folder / files.back(), entries_);
  }

 private:
  const StoredRun& run_;      // borrowed
  const mesh::Q8Mesh& mesh_;  // borrowed
  bem::ElementIntegrals integrals_;
  PointGrid grid_;
  Points2 points_;
  std::vector<std::uint8_t> on_plate_;
  std::vector<PvdEntry> entries_;
};

}  // namespace

std::vector<std::filesystem::path> write_paraview(const StoredRun& run,
                                                  const std::filesystem::path& folder,
                                                  const ParaviewOptions& options) {
  FLOE_VALIDATE(options.phases >= 2 && options.phases <= 999,
                "invalid phases = " << options.phases << " (must be 2 to 999)");
  const mesh::Q8Mesh mesh = run.fluid_mesh();
  std::optional<Surface> surface;
  if (options.step != 0.0) surface.emplace(run, mesh, options);
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  FLOE_VALIDATE_AS(FileError, !error,
                   "cannot write to " << folder.string() << ": " << error.message());

  std::vector<std::string> files;
  for (std::size_t i = 0; i < run.data().omega.size(); ++i) {
    if (!run.has_frequency(i)) continue;
    const FrequencyResult result = run.frequency(i);
    for (const NodeField& field : result.fields)
      write_animation(folder, mesh, field, options.phases, files);
    if (surface && !result.fields.empty()) surface->write(folder, result, files);
  }
  FLOE_VALIDATE_AS(StoreError, !files.empty(),
                   run.directory().string() << " holds no node field (ask for output.fields)");
  if (surface) surface->write_collection(folder, files);
  std::vector<std::filesystem::path> paths;
  for (const std::string& file : files) paths.push_back(folder / file);
  return paths;
}

}  // namespace floe::io
