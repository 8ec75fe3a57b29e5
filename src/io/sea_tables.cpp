#include "io/sea_tables.hpp"

#include "io/csv_table.hpp"

#include <floe/response/design_values.hpp>
#include <floe/response/stations.hpp>

#include <cmath>

namespace floe::io {
namespace {

std::vector<std::string> comments(const std::string& what,
                                  const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = {what};
  lines.insert(lines.end(), remarks.begin(), remarks.end());
  return lines;
}

// Every point and quantity of a sea and mean heading, after the cells that all tables begin with
template <typename Row>
void each_quantity(CsvTable& table, const Case& data, const SeaResult& result, Row row) {
  const auto begin = [&](const NamedPoint& point, std::size_t k) {
    table << result.sea << result.mean_heading_deg << point.name
          << response::name(data.quantities[result.quantity[k]]);
  };
  for (std::size_t i = 0; i < data.points.size(); ++i)
    for (std::size_t k = 0; k < result.quantity.size(); ++k)
      row(static_cast<Index>(i), k, [&, i, k] { begin(data.points[i], k); });
}

void add_spectra(CsvTable& table, const Case& data, const SeaResult& result) {
  each_quantity(table, data, result, [&](Index i, std::size_t k, auto begin_row) {
    for (std::size_t j = 0; j < result.omega.size(); ++j) {
      begin_row();
      table << result.omega[j] << result.spectra[k](i, static_cast<Index>(j));
      table.end_row();
    }
  });
}

void add_moments(CsvTable& table, const Case& data, const SeaResult& result) {
  each_quantity(table, data, result, [&](Index i, std::size_t k, auto begin_row) {
    const auto m = result.moments[k].row(i);
    begin_row();
    table << std::sqrt(m[0]) << m[0] << m[1] << m[2] << m[3];
    table.end_row();
  });
}

// Rows where nothing moves have no period and are left out
void add_design_values(CsvTable& table, const Case& data, const SeaResult& result) {
  each_quantity(table, data, result, [&](Index i, std::size_t k, auto begin_row) {
    const auto m = result.moments[k].row(i);
    if (!(m[2] > 0.0)) return;
    const response::DesignValues values = response::design_values(m[0], m[2], result.duration);
    begin_row();
    table << values.zero_crossing_period << values.significant << result.duration
          << values.most_probable_maximum;
    table.end_row();
  });
}

void add_lines(CsvTable& table, const Case& data, const SeaResult& result) {
  Index station = 0;
  for (const NamedLine& line : data.lines) {
    const Points2 at = response::line_stations(line.from, line.to, line.count);
    for (int i = 0; i < line.count; ++i, ++station) {
      const double s = (line.to - line.from).norm() * i / (line.count - 1);
      table << result.sea << result.mean_heading_deg << line.name << s << at(0, i) << at(1, i)
            << "deflection" << result.line_deviation[station];
      table.end_row();
    }
  }
}

}  // namespace

const std::vector<std::string>& sea_table_names() {
  static const std::vector<std::string> names = {"spectra_points.csv", "statistics_points.csv",
                                                 "design_values.csv", "statistics_lines.csv"};
  return names;
}

void write_sea_tables(const std::filesystem::path& folder, const std::vector<std::string>& remarks,
                      const Case& data, const std::vector<SeaResult>& results) {
  const std::vector<std::string>& names = sea_table_names();
  CsvTable spectra(
      folder / names[0],
      comments("one-sided spectra of quantities at points, (SI unit)² per rad/s", remarks),
      {"sea", "mean_heading_deg", "point", "quantity", "omega", "spectrum"});
  CsvTable moments(
      folder / names[1],
      comments("standard deviation and moments ∫ω^j S dω of quantities at points, SI units",
               remarks),
      {"sea", "mean_heading_deg", "point", "quantity", "std", "m0", "m1", "m2", "m4"});
  CsvTable design(
      folder / names[2],
      comments("single amplitudes of a narrow-banded Gaussian response, SI units: mean of the "
               "highest third, most probable largest of the duration [s]",
               remarks),
      {"sea", "mean_heading_deg", "point", "quantity", "zero_crossing_period", "significant",
       "duration", "most_probable_maximum"});
  CsvTable lines(folder / names[3],
                 comments("standard deviation of the deflection [m] along lines", remarks),
                 {"sea", "mean_heading_deg", "line", "s", "x", "y", "quantity", "std"});
  for (const SeaResult& result : results) {
    add_spectra(spectra, data, result);
    add_moments(moments, data, result);
    add_design_values(design, data, result);
    add_lines(lines, data, result);
  }
  for (CsvTable* table : {&spectra, &moments, &design, &lines}) table->commit();
}

}  // namespace floe::io
