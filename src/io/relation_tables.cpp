#include "io/relation_tables.hpp"

#include "io/csv_table.hpp"

#include <floe/response/design_values.hpp>

#include <cmath>

namespace floe::io {
namespace {

const std::vector<std::string> kPairNames = {"cross_spectra.csv", "covariances.csv"};
const std::vector<std::string> kCombinationNames = {"combinations.csv", "combination_spectra.csv"};

std::vector<std::string> comments(const std::string& what,
                                  const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = {what};
  lines.insert(lines.end(), remarks.begin(), remarks.end());
  return lines;
}

void begin_pair(CsvTable& table, const Case& data, const SeaResult& result,
                const QuantityPair& pair) {
  table << result.sea << result.mean_heading_deg;
  for (const PointQuantity& of : {pair.first, pair.second})
    table << data.points[of.point].name << response::name(data.quantities[of.quantity]);
}

void write_pairs(const std::filesystem::path& folder, const std::vector<std::string>& remarks,
                 const Case& data, const std::vector<SeaResult>& results) {
  CsvTable spectra(folder / kPairNames[0],
                   comments("one-sided cross-spectra ∑ y1* y2 of quantities at points, "
                            "e^{-iωt}, product of the SI units per rad/s",
                            remarks),
                   {"sea", "mean_heading_deg", "point_1", "quantity_1", "point_2", "quantity_2",
                    "omega", "re", "im"});
  CsvTable covariances(folder / kPairNames[1],
                       comments("covariance at the same time and correlation of quantities at "
                                "points, product of the SI units",
                                remarks),
                       {"sea", "mean_heading_deg", "point_1", "quantity_1", "point_2", "quantity_2",
                        "covariance", "correlation"});
  for (const SeaResult& result : results)
    for (std::size_t p = 0; p < result.pairs.size(); ++p) {
      const PairResult& pair = result.pairs[p];
      for (Index j = 0; j < pair.spectrum.size(); ++j) {
        begin_pair(spectra, data, result, data.relations.pairs[p]);
        spectra << result.omega[static_cast<std::size_t>(j)] << pair.spectrum[j].real()
                << pair.spectrum[j].imag();
        spectra.end_row();
      }
      begin_pair(covariances, data, result, data.relations.pairs[p]);
      covariances << pair.covariance << pair.correlation;
      covariances.end_row();
    }
  spectra.commit();
  covariances.commit();
}

void write_combinations(const std::filesystem::path& folder,
                        const std::vector<std::string>& remarks, const Case& data,
                        const std::vector<SeaResult>& results) {
  CsvTable values(folder / kCombinationNames[0],
                  comments("combinations: root mean square, moments ∫ω^j S dω, period 2π√(m0/m2) "
                           "[s], and the most probable largest of the duration [s]; SI units",
                           remarks),
                  {"sea", "mean_heading_deg", "combination", "std", "m0", "m1", "m2", "m4",
                   "zero_crossing_period", "duration", "most_probable_maximum"});
  CsvTable spectra(folder / kCombinationNames[1],
                   comments("one-sided spectra of combinations, (SI unit)² per rad/s", remarks),
                   {"sea", "mean_heading_deg", "combination", "omega", "spectrum"});
  for (const SeaResult& result : results)
    for (std::size_t c = 0; c < result.combinations.size(); ++c) {
      const CombinationResult& own = result.combinations[c];
      const std::string& name = data.relations.combinations[c].name;
      const VecXd& m = own.moments;
      if (!(m[2] > 0.0)) continue;  // nothing moves: no period
      values << result.sea << result.mean_heading_deg << name << std::sqrt(m[0]) << m[0] << m[1]
             << m[2] << m[3]
             << response::design_values(m[0], m[2], result.duration).zero_crossing_period
             << result.duration << own.most_probable_maximum;
      values.end_row();
      for (Index j = 0; j < own.spectrum.size(); ++j) {
        spectra << result.sea << result.mean_heading_deg << name
                << result.omega[static_cast<std::size_t>(j)] << own.spectrum[j];
        spectra.end_row();
      }
    }
  values.commit();
  spectra.commit();
}

}  // namespace

std::vector<std::string> relation_table_names(const SeaRelations& relations) {
  std::vector<std::string> names;
  if (!relations.pairs.empty()) names = kPairNames;
  if (!relations.combinations.empty())
    names.insert(names.end(), kCombinationNames.begin(), kCombinationNames.end());
  return names;
}

void write_relation_tables(const std::filesystem::path& folder,
                           const std::vector<std::string>& remarks, const Case& data,
                           const std::vector<SeaResult>& results) {
  if (!data.relations.pairs.empty()) write_pairs(folder, remarks, data, results);
  if (!data.relations.combinations.empty()) write_combinations(folder, remarks, data, results);
}

}  // namespace floe::io
