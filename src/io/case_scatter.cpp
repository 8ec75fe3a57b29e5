#include "io/case_sections.hpp"
#include "io/case_spectra.hpp"
#include "io/scatter_csv.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace floe::io {
namespace {

constexpr NumberRule kProbability{"", "must be finite and at least 0",
                                  [](double x) { return std::isfinite(x) && x >= 0.0; }};
constexpr NumberRule kYears{"years", "must be 0.001 to 1e6",
                            [](double x) { return x >= 1e-3 && x <= 1e6; }};

wave::PeriodType read_period_type(const Section& scatter) {
  const std::string name = chosen_name(scatter, "period_type", {"Tz", "Tp", "Te"});
  if (name == "Tz") return wave::PeriodType::kZeroCrossing;
  return name == "Tp" ? wave::PeriodType::kPeak : wave::PeriodType::kEnergy;
}

double read_peakedness(const Section& scatter) {
  const std::string kind =
      chosen_name(scatter, "spectrum", {"bretschneider", "pierson-moskowitz", "jonswap"});
  if (kind == "jonswap") return scatter.number_or("gamma", gamma_rule(), 3.3);
  refuse_keys_of_others(scatter, "spectrum", kind, {"gamma"}, {});
  return 1.0;
}

// Headings and how often the waves travel there; with several, the shares must be said
void read_headings(const Section& scatter, wave::WaveClimate& climate) {
  climate.mean_heading_deg = scatter.numbers("mean_heading_deg", heading_rule()).value;
  const std::size_t count = climate.mean_heading_deg.size();
  if (std::set<double>(climate.mean_heading_deg.begin(), climate.mean_heading_deg.end()).size() !=
      count)
    scatter.source().refuse(scatter.find("mean_heading_deg")->source(),
                            fmt::format("invalid {} (each heading must be given once)",
                                        scatter.full_name("mean_heading_deg")));
  if (count == 1 && !scatter.find("heading_probability")) {
    climate.heading_probability = {1.0};
    return;
  }
  scatter.require("heading_probability", "required: one number for each mean heading");
  const NumberList given = scatter.numbers("heading_probability", kProbability);
  double sum = 0.0;
  for (const double value : given.value) sum += value;
  if (given.value.size() != count || !(std::abs(sum - 1.0) <= 1e-3))
    scatter.source().refuse(
        scatter.find("heading_probability")->source(),
        fmt::format("invalid {} = a list of {} with the sum {} (must be one for each mean heading, "
                    "{}, and add up to 1)",
                    scatter.full_name("heading_probability"), given.value.size(), sum, count));
  for (const double value : given.value) climate.heading_probability.push_back(value / sum);
}

wave::WaveClimate read_scatter(const toml::table& table, std::size_t number,
                               const std::filesystem::path& folder, CaseSource& source) {
  const Section scatter(
      table, fmt::format("scatter[{}]", number), source,
      {"name", "file", "period_type", "spectrum", "gamma", "spreading", "n", "s", "std_deg",
       "mean_heading_deg", "heading_probability", "return_period_years", "allow_truncation"});
  wave::WaveClimate climate;
  const toml::node& name = scatter.require("name", "required: a name for the tables of results");
  climate.name = scatter.text_or("name", "");
  check_name(climate.name, name.source(), scatter.full_name("name"), source);
  const wave::PeriodType type = read_period_type(scatter);
  climate.gamma = read_peakedness(scatter);
  climate.spreading = read_spreading(scatter);
  read_headings(scatter, climate);
  climate.return_period_years = {1.0, 10.0, 100.0};
  if (scatter.find("return_period_years")) {
    climate.return_period_years = scatter.numbers("return_period_years", kYears).value;
    std::sort(climate.return_period_years.begin(), climate.return_period_years.end());
  }
  climate.allow_truncation = scatter.flag_or("allow_truncation", false);
  scatter.require("file", "required: a table of heights and periods, CSV");
  climate.scatter = read_scatter_diagram(folder / scatter.text_or("file", ""), type);
  climate.description = fmt::format(
      "{} heights × {} {}, {}{}, spreading {}", climate.scatter.height.size(),
      climate.scatter.period.size(), period_name(type), scatter.text_or("spectrum", ""),
      climate.gamma > 1.0 ? fmt::format(" γ = {}", climate.gamma) : "", spreading_words(scatter));
  return climate;
}

}  // namespace

std::vector<wave::WaveClimate> read_wave_climates(const Section& root,
                                                  const std::filesystem::path& folder) {
  std::vector<wave::WaveClimate> climates;
  const toml::node* node = root.find("scatter");
  if (!node) return climates;
  const toml::array* list = node->as_array();
  if (!list || !list->is_array_of_tables())
    root.source().refuse(node->source(), fmt::format("invalid scatter = {} (must be tables "
                                                     "[[scatter]])",
                                                     shown(*node)));
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::table& table = *(*list)[i].as_table();
    climates.push_back(read_scatter(table, i, folder, root.source()));
    if (!names.insert(climates.back().name).second)
      root.source().refuse(
          table.get("name")->source(),
          fmt::format("invalid scatter[{}].name = {} (must differ from the others)", i,
                      shown_text(climates.back().name)));
  }
  return climates;
}

}  // namespace floe::io
