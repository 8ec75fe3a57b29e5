#include "io/long_term_tables.hpp"

#include "io/csv_table.hpp"
#include "io/scatter_csv.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kYear = 365.25 * 86'400.0;  // [s]
constexpr int kLevelsADecade = 4;

std::vector<std::string> comments(const std::string& what,
                                  const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = {what};
  lines.insert(lines.end(), remarks.begin(), remarks.end());
  return lines;
}

// Every point and quantity of a climate
template <typename Row>
void each_quantity(const Case& data, const LongTermResult& result, Row row) {
  for (std::size_t i = 0; i < data.points.size(); ++i)
    for (std::size_t k = 0; k < result.quantity.size(); ++k)
      row(data.points[i].name, response::name(data.quantities[result.quantity[k]]),
          static_cast<Index>(i), k);
}

// Rows where nothing moves have no period and are left out
void add_short_term(CsvTable& table, const Case& data, const LongTermResult& result) {
  const wave::WaveClimate& climate = result.climate;
  const std::size_t periods = climate.scatter.period.size();
  for (std::size_t h = 0; h < climate.mean_heading_deg.size(); ++h)
    for (std::size_t j = 0; j < periods; ++j)
      each_quantity(data, result, [&](const auto& point, auto quantity, Index i, std::size_t k) {
        const auto column = static_cast<Index>(h * periods + j);
        const double m0 = result.m0[k](i, column), m2 = result.m2[k](i, column);
        if (!(m2 > 0.0)) return;
        table << climate.name << climate.mean_heading_deg[h] << climate.scatter.period[j]
              << climate.peak_period(j) << result.share_outside[j] << point << quantity
              << std::sqrt(m0) << 2.0 * std::numbers::pi * std::sqrt(m0 / m2);
        table.end_row();
      });
}

// Four levels a decade of the exceedance, down to the longest return period and one decade on
void add_long_term(CsvTable& table, const Case& data, const LongTermResult& result) {
  const double years = result.climate.return_period_years.back();
  each_quantity(data, result, [&](const auto& point, auto quantity, Index i, std::size_t k) {
    const response::LongTermDistribution distribution = result.distribution(k, i);
    if (!distribution.moves()) return;
    const double peaks = distribution.peak_rate() * kYear;
    for (int step = 1;; ++step) {
      const double exceedance = std::pow(10.0, -static_cast<double>(step) / kLevelsADecade);
      if (exceedance * peaks * years < 0.1) break;
      table << result.climate.name << point << quantity << exceedance
            << distribution.level(exceedance) << exceedance * peaks;
      table.end_row();
    }
  });
}

void add_return_values(CsvTable& table, const Case& data, const LongTermResult& result) {
  each_quantity(data, result, [&](const auto& point, auto quantity, Index i, std::size_t k) {
    const response::LongTermDistribution distribution = result.distribution(k, i);
    if (!distribution.moves()) return;
    for (const double years : result.climate.return_period_years) {
      const double level = distribution.return_value(years * kYear);
      const SeaClass worst = result.worst_class(k, i, level);
      table << result.climate.name << point << quantity << years << level
            << 1.0 / distribution.peak_rate() << worst.height << worst.period
            << worst.mean_heading_deg << worst.share;
      table.end_row();
    }
  });
}

}  // namespace

const std::vector<std::string>& long_term_table_names() {
  static const std::vector<std::string> names = {"short_term.csv", "long_term.csv",
                                                 "return_values.csv"};
  return names;
}

void write_long_term_tables(const std::filesystem::path& folder,
                            const std::vector<std::string>& remarks, const Case& data,
                            const std::vector<LongTermResult>& results) {
  const std::vector<std::string>& names = long_term_table_names();
  CsvTable short_term(
      folder / names[0],
      comments("response to each period of a scatter diagram: standard deviation per metre of "
               "significant height, period of its peaks, SI units",
               remarks),
      {"scatter", "mean_heading_deg", "period", "peak_period", "share_outside", "point", "quantity",
       "std_per_metre", "zero_crossing_period"});
  CsvTable long_term(
      folder / names[1],
      comments("long-term distribution of the single amplitudes: probability that a peak exceeds "
               "the level (SI unit of the quantity), and how often that is a year",
               remarks),
      {"scatter", "point", "quantity", "exceedance", "level", "per_year"});
  CsvTable values(
      folder / names[2],
      comments("single amplitudes (SI unit of the quantity) that are exceeded once in the return "
               "period on average, and the class of sea states that most of them come from",
               remarks),
      {"scatter", "point", "quantity", "return_period_years", "level", "mean_period",
       "worst_height", "worst_period", "worst_mean_heading_deg", "worst_share"});
  for (const LongTermResult& result : results) {
    add_short_term(short_term, data, result);
    add_long_term(long_term, data, result);
    add_return_values(values, data, result);
  }
  for (CsvTable* table : {&short_term, &long_term, &values}) table->commit();
}

}  // namespace floe::io
