#include "io/result_tables.hpp"

#include <floe/response/stations.hpp>

#include <stdexcept>

namespace floe::io {
namespace {

std::vector<std::string> comments(const std::string& what,
                                  const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = {what};
  lines.insert(lines.end(), remarks.begin(), remarks.end());
  return lines;
}

std::vector<std::string> per_amplitude(const std::string& what,
                                       const std::vector<std::string>& remarks) {
  return comments(
      what + " per metre of wave amplitude, time factor e^{-iωt}, phases relative to the origin",
      remarks);
}

void add_points(CsvTable& table, const std::vector<NamedPoint>& points, const Case& data,
                double omega, const MatXcd& value) {
  for (Index h = 0; h < value.cols(); ++h)
    for (Index i = 0; i < value.rows(); ++i) {
      const NamedPoint& point = points[static_cast<std::size_t>(i)];
      table << omega << data.heading_deg[static_cast<std::size_t>(h)] << point.name
            << point.position.x() << point.position.y() << value(i, h);
      table.end_row();
    }
}

void add_lines(CsvTable& table, const Case& data, const FrequencyResult& result) {
  for (Index h = 0; h < result.line_deflection.cols(); ++h) {
    Index station = 0;
    for (const NamedLine& line : data.lines) {
      const Points2 at = response::line_stations(line.from, line.to, line.count);
      for (int i = 0; i < line.count; ++i, ++station) {
        const double s = (line.to - line.from).norm() * i / (line.count - 1);
        table << result.omega << data.heading_deg[static_cast<std::size_t>(h)] << line.name << s
              << at(0, i) << at(1, i) << result.line_deflection(station, h);
        table.end_row();
      }
    }
  }
}

void add_quantities(CsvTable& table, const Case& data, const FrequencyResult& result) {
  if (result.point_quantities.empty()) return;
  for (Index h = 0; h < result.point_quantities.front().cols(); ++h)
    for (std::size_t i = 0; i < data.points.size(); ++i)
      for (std::size_t j = 0; j < data.quantities.size(); ++j) {
        table << result.omega << data.heading_deg[static_cast<std::size_t>(h)]
              << data.points[i].name << response::name(data.quantities[j])
              << result.point_quantities[j](static_cast<Index>(i), h);
        table.end_row();
      }
}

void add_coefficients(CsvTable& table, const FrequencyResult& result) {
  for (Index i = 0; i < result.added_mass.rows(); ++i)
    for (Index j = 0; j < result.added_mass.cols(); ++j) {
      table << result.omega << i + 1 << j + 1 << result.added_mass(i, j) << result.damping(i, j);
      table.end_row();
    }
}

void add_forces(CsvTable& table, const Case& data, const FrequencyResult& result) {
  for (Index h = 0; h < result.exciting_force.cols(); ++h)
    for (Index i = 0; i < result.exciting_force.rows(); ++i) {
      const Complex force = result.exciting_force(i, h);
      table << result.omega << data.heading_deg[static_cast<std::size_t>(h)] << i + 1
            << force.real() << force.imag();
      table.end_row();
    }
}

// The shapes that `add` relies on; a mismatch is a fault of the caller
void expect_shapes(const Case& data, const FrequencyResult& result) {
  const Index headings = static_cast<Index>(data.heading_deg.size());
  Index stations = 0;
  for (const NamedLine& line : data.lines) stations += line.count;
  const auto fits = [&](const MatXcd& value, std::size_t rows) {
    return value.rows() == static_cast<Index>(rows) && (rows == 0 || value.cols() == headings);
  };
  bool good = fits(result.point_deflection, data.points.size()) &&
              fits(result.line_deflection, static_cast<std::size_t>(stations)) &&
              fits(result.wave_elevation, data.wave_points.size()) &&
              result.exciting_force.cols() == headings &&
              (data.points.empty() || result.point_quantities.size() == data.quantities.size());
  for (const MatXcd& value : result.point_quantities)
    good = good && fits(value, data.points.size());
  if (!good) throw std::logic_error("results of a frequency do not have the shapes of the case");
}

}  // namespace

ResultTables::ResultTables(const std::filesystem::path& folder,
                           const std::vector<std::string>& remarks, SolverRoute route)
    : points_(folder / "rao_points.csv", per_amplitude("deflection [m/m] at points", remarks),
              {"omega", "heading_deg", "point", "x", "y", "re_w", "im_w", "abs_w"}),
      lines_(folder / "rao_lines.csv", per_amplitude("deflection [m/m] along lines", remarks),
             {"omega", "heading_deg", "line", "s", "x", "y", "re_w", "im_w", "abs_w"}),
      quantities_(folder / "rao_quantities.csv",
                  per_amplitude("quantities at points, SI units", remarks),
                  {"omega", "heading_deg", "point", "quantity", "re", "im", "abs"}),
      waves_(folder / "wave_points.csv", per_amplitude("free-surface elevation [m/m]", remarks),
             {"omega", "heading_deg", "point", "x", "y", "re", "im", "abs"}) {
  if (route == SolverRoute::kDirect) return;
  coefficients_.emplace(
      folder / "hydro_coefficients.csv",
      comments("added mass [-] and damping [1/s] in mass-normalised dry modes", remarks),
      std::vector<std::string>{"omega", "mode_i", "mode_j", "added_mass", "damping"});
  forces_.emplace(folder / "exciting_force.csv",
                  per_amplitude("exciting force on mass-normalised dry modes", remarks),
                  std::vector<std::string>{"omega", "heading_deg", "mode", "re", "im"});
}

void ResultTables::add(const Case& data, const FrequencyResult& result) {
  expect_shapes(data, result);
  each([&](CsvTable& table) { table.let_unknown(!result.report.failure.empty()); });
  add_points(points_, data.points, data, result.omega, result.point_deflection);
  add_lines(lines_, data, result);
  add_quantities(quantities_, data, result);
  add_points(waves_, data.wave_points, data, result.omega, result.wave_elevation);
  if (coefficients_) add_coefficients(*coefficients_, result);
  if (forces_) add_forces(*forces_, data, result);
}

void ResultTables::mark() {
  each([](CsvTable& table) { table.mark(); });
}

void ResultTables::rollback() {
  each([](CsvTable& table) { table.rollback(); });
}

void ResultTables::commit() {
  each([](CsvTable& table) { table.commit(); });
}

void write_dry_modes(const std::filesystem::path& folder, const std::vector<std::string>& remarks,
                     const plate::DryModes& modes) {
  CsvTable table(folder / "dry_modes.csv",
                 comments("natural frequencies of the dry plate [rad/s]", remarks),
                 {"mode", "omega"});
  for (Index i = 0; i < modes.count(); ++i) {
    table << i + 1 << modes.omega[i];
    table.end_row();
  }
  table.commit();
}

}  // namespace floe::io
