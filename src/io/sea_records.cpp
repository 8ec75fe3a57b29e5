#include "io/record_numbers.hpp"
#include "io/result_records.hpp"

#include <sstream>
#include <string>

namespace floe::io {
namespace {

constexpr Index kSolvedRows = 13;

// One column each, but the method
MatXd as_table(const std::vector<SolvedSeaFrequency>& all) {
  MatXd table(kSolvedRows, static_cast<Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const FrequencyReport& r = all[i].report;
    table.col(static_cast<Index>(i)) << r.omega, static_cast<double>(r.iterations),
        static_cast<double>(r.applications), r.true_residual, r.kernel_error, r.reciprocity_error,
        r.energy_error, r.exact_residual, r.residual_between_nodes, r.mode_change,
        r.passivity_error, all[i].pressure_error, all[i].response;
  }
  return table;
}

void put_solved(const std::vector<SolvedSeaFrequency>& all, Record& record) {
  std::string methods;
  for (const SolvedSeaFrequency& one : all) methods += one.report.method + " ";
  record.put("worth", as_table(all));
  record.put("methods", methods);
}

std::vector<SolvedSeaFrequency> solved_of(const Record& record) {
  const MatXd table = record.real("worth");
  FLOE_VALIDATE_AS(StoreError, table.rows() == kSolvedRows || table.size() == 0,
                   "a record's solved frequencies have no " << kSolvedRows << " numbers");
  std::istringstream methods(record.text("methods"));
  std::vector<SolvedSeaFrequency> all(static_cast<std::size_t>(table.cols()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const VecXd t = table.col(static_cast<Index>(i));
    all[i] = {.report = {.omega = t[0],
                         .method = {},
                         .iterations = count_of<int>(t[1]),
                         .applications = count_of<long>(t[2]),
                         .true_residual = t[3],
                         .kernel_error = t[4],
                         .reciprocity_error = t[5],
                         .energy_error = t[6],
                         .exact_residual = t[7],
                         .residual_between_nodes = t[8],
                         .mode_change = t[9],
                         .passivity_error = t[10]},
              .pressure_error = t[11],
              .response = t[12]};
    methods >> all[i].report.method;
  }
  return all;
}

}  // namespace

Record record_of(const SeaObservation& observation, const SeaGridReport& grid) {
  Record record;
  record.put("quantity", as_vector(observation.quantity));
  record.put("derivative", as_vector(observation.derivative));
  record.put("phase", as_vector(observation.phase));
  record.put("points", observation.points);
  record.put("lines", observation.lines);
  record.put("nodes", observation.nodes);
  record.put("omega", as_vector(grid.omega));
  record.put("headings", static_cast<double>(grid.headings));
  return record;
}

SeaObservation observation_from(const Record& record) {
  return {as_list<std::size_t>(record.real("quantity")),
          as_list<int>(record.real("derivative")),
          as_list<double>(record.real("phase")),
          record.real("points"),
          record.real("lines"),
          record.real("nodes")};
}

SeaGridReport sea_grid_from(const Record& record) {
  SeaGridReport grid;
  grid.omega = as_list<double>(record.real("omega"));
  grid.headings = count_of<int>(record.number("headings"));
  return grid;
}

Record record_of(const SeaGridReport& grid) {
  Record record;
  record.put("omega", as_vector(grid.omega));
  record.put("headings", static_cast<double>(grid.headings));
  record.put("interpolation_error", grid.interpolation_error);
  record.put("solved_frequencies", static_cast<double>(grid.solved_frequencies));
  record.put("pressure_error", grid.pressure_error);
  put_solved(grid.solved, record);
  return record;
}

SeaGridReport finished_grid_from(const Record& record) {
  SeaGridReport grid = sea_grid_from(record);
  grid.interpolation_error = record.number("interpolation_error");
  grid.solved_frequencies = count_of<int>(record.number("solved_frequencies"));
  grid.pressure_error = record.number("pressure_error");
  grid.solved = solved_of(record);
  return grid;
}

Record record_of(const SeaTransfer& transfer) {
  Record record;
  record.put("omega", transfer.omega);
  record.put("state", transfer.state);
  for (std::size_t z = 0; z < transfer.zone_states.size(); ++z)
    record.put("zone " + std::to_string(z), transfer.zone_states[z]);
  return record;
}

SeaTransfer transfer_from(const Record& record) {
  SeaTransfer transfer{record.number("omega"), record.complex("state")};
  for (std::size_t z = 0; record.holds("zone " + std::to_string(z)); ++z)
    transfer.zone_states.push_back(record.complex("zone " + std::to_string(z)));
  return transfer;
}

Record record_of(const FluidSample& sample) {
  Record record;
  record.put("omega", sample.omega);
  record.put("pressure", sample.pressure);
  record.put("fluid_matrix", sample.fluid_matrix);
  put_solved({sample.solved}, record);
  return record;
}

FluidSample sample_from(const Record& record) {
  const std::vector<SolvedSeaFrequency> solved = solved_of(record);
  FLOE_VALIDATE_AS(StoreError, solved.size() == 1, "a record's sample has no account of itself");
  return {.omega = record.number("omega"),
          .pressure = record.complex("pressure"),
          .fluid_matrix = record.complex("fluid_matrix"),
          .solved = solved.front()};
}

Record record_of(const SeaMarch& march) {
  Record record;
  record.put("next", static_cast<double>(march.next));
  record.put("interval", static_cast<double>(march.interval));
  record.put("step", march.step);
  record.put("solved", static_cast<double>(march.solved));
  record.put("largest_error", march.largest_error);
  record.put("samples", as_vector(march.samples));
  record.put("largest_response", as_vector(march.largest_response));
  put_solved(march.all_solved, record);
  return record;
}

SeaMarch march_from(const Record& record) {
  return {.next = static_cast<std::size_t>(record.number("next")),
          .interval = static_cast<Index>(record.number("interval")),
          .step = record.number("step"),
          .solved = static_cast<int>(record.number("solved")),
          .largest_error = record.number("largest_error"),
          .samples = as_list<int>(record.real("samples")),
          .largest_response = as_list<double>(record.real("largest_response")),
          .all_solved = solved_of(record)};
}

Record record_of(const SeaResult& result) {
  Record record;
  record.put("sea", result.sea);
  record.put("omega", as_vector(result.omega));
  record.put("quantity", as_vector(result.quantity));
  for (std::size_t q = 0; q < result.quantity.size(); ++q) {
    record.put("spectra " + std::to_string(q), result.spectra[q]);
    record.put("moments " + std::to_string(q), result.moments[q]);
  }
  record.put("pairs", static_cast<double>(result.pairs.size()));
  for (std::size_t p = 0; p < result.pairs.size(); ++p) {
    record.put("pair " + std::to_string(p), MatXcd(result.pairs[p].spectrum));
    record.put("covariance " + std::to_string(p),
               VecXd{{result.pairs[p].covariance, result.pairs[p].correlation}});
  }
  record.put("combinations", static_cast<double>(result.combinations.size()));
  for (std::size_t c = 0; c < result.combinations.size(); ++c) {
    const CombinationResult& combination = result.combinations[c];
    record.put("combination " + std::to_string(c), combination.spectrum);
    VecXd facts(5);
    facts << combination.moments, combination.most_probable_maximum;
    record.put("combination moments " + std::to_string(c), facts);
  }
  record.put("line_deviation", result.line_deviation);
  record.put("node_moments", result.node_moments);
  record.put("facts", VecXd{{result.mean_heading_deg, result.duration, result.significant_height,
                             result.share_outside, result.grid_error, result.spreading_sum,
                             result.band_height}});
  return record;
}

SeaResult sea_from(const Record& record) {
  SeaResult result;
  result.sea = record.text("sea");
  result.omega = as_list<double>(record.real("omega"));
  result.quantity = as_list<std::size_t>(record.real("quantity"));
  for (std::size_t q = 0; q < result.quantity.size(); ++q) {
    result.spectra.push_back(record.real("spectra " + std::to_string(q)));
    result.moments.push_back(record.real("moments " + std::to_string(q)));
  }
  for (std::size_t p = 0; p < static_cast<std::size_t>(record.number("pairs")); ++p) {
    const MatXd covariance = record.real("covariance " + std::to_string(p));
    result.pairs.push_back(
        {record.complex("pair " + std::to_string(p)), covariance(0), covariance(1)});
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(record.number("combinations")); ++c) {
    const VecXd facts = record.real("combination moments " + std::to_string(c));
    result.combinations.push_back(
        {record.real("combination " + std::to_string(c)), facts.head(4), facts[4]});
  }
  result.line_deviation = record.real("line_deviation");
  result.node_moments = record.real("node_moments");
  const std::vector<double> facts = facts_of(record, "facts", 5);
  result.mean_heading_deg = facts.at(0);
  result.duration = facts.at(1);
  result.significant_height = facts.at(2);
  result.share_outside = facts.at(3);
  result.grid_error = facts.at(4);
  if (facts.size() > 6) {  // version 0.1 did not keep these
    result.spreading_sum = facts[5];
    result.band_height = facts[6];
  }
  return result;
}

}  // namespace floe::io
