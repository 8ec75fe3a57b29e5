#include "io/result_records.hpp"

#include <string>

namespace floe::io {
namespace {

template <typename Number>
VecXd as_vector(const std::vector<Number>& values) {
  VecXd vector(static_cast<Index>(values.size()));
  for (Index i = 0; i < vector.size(); ++i)
    vector[i] = static_cast<double>(values[static_cast<std::size_t>(i)]);
  return vector;
}

template <typename Number>
std::vector<Number> as_list(const MatXd& values) {
  std::vector<Number> list;
  for (Index i = 0; i < values.size(); ++i) list.push_back(static_cast<Number>(values(i)));
  return list;
}

}  // namespace

Record record_of(const mesh::Q8Mesh& mesh) {
  Record record;
  record.put("nodes", mesh.nodes());
  record.put("elements", mesh.elements().cast<double>());
  return record;
}

mesh::Q8Mesh mesh_from(const Record& record) {
  return mesh::Q8Mesh(record.real("nodes"), record.real("elements").cast<Index>());
}

Record record_of(const plate::DryModes& modes) {
  Record record;
  record.put("omega", modes.omega);
  record.put("shape", modes.shape);
  record.put("modal_mass", modes.modal_mass);
  record.put("rigid_count", static_cast<double>(modes.rigid_count));
  record.put("estimated_frequency_error", modes.estimated_frequency_error);
  return record;
}

plate::DryModes modes_from(const Record& record) {
  plate::DryModes modes;
  modes.omega = record.real("omega");
  modes.shape = record.real("shape");
  modes.modal_mass = record.real("modal_mass");
  modes.rigid_count = static_cast<int>(record.number("rigid_count"));
  modes.estimated_frequency_error = record.number("estimated_frequency_error");
  return modes;
}

Record record_of(const FrequencyResult& result) {
  Record record;
  record.put("omega", result.omega);
  record.put("wavenumber", result.wavenumber);
  record.put("added_mass", result.added_mass);
  record.put("damping", result.damping);
  record.put("exciting_force", result.exciting_force);
  record.put("froude_krylov_force", result.froude_krylov_force);
  record.put("amplitudes", result.amplitudes);
  record.put("line_deflection", result.line_deflection);
  record.put("point_deflection", result.point_deflection);
  record.put("wave_elevation", result.wave_elevation);
  record.put("quantities", static_cast<double>(result.point_quantities.size()));
  for (std::size_t q = 0; q < result.point_quantities.size(); ++q)
    record.put("quantity " + std::to_string(q), result.point_quantities[q]);
  record.put("fields", static_cast<double>(result.fields.size()));
  for (std::size_t f = 0; f < result.fields.size(); ++f) {
    const NodeField& field = result.fields[f];
    MatXcd values(field.deflection.size(), 4);
    values << field.deflection, field.rotation_x, field.rotation_y, field.pressure;
    record.put("field " + std::to_string(f), values);
    record.put("field heading " + std::to_string(f), field.heading_deg);
  }
  const FrequencyReport& report = result.report;
  record.put("method", report.method);
  record.put("report", VecXd{{static_cast<double>(report.iterations),
                              static_cast<double>(report.applications), report.true_residual,
                              report.kernel_error, report.reciprocity_error, report.energy_error,
                              report.seconds}});
  return record;
}

FrequencyResult frequency_from(const Record& record) {
  FrequencyResult result;
  result.omega = record.number("omega");
  result.wavenumber = record.number("wavenumber");
  result.added_mass = record.real("added_mass");
  result.damping = record.real("damping");
  result.exciting_force = record.complex("exciting_force");
  result.froude_krylov_force = record.complex("froude_krylov_force");
  result.amplitudes = record.complex("amplitudes");
  result.line_deflection = record.complex("line_deflection");
  result.point_deflection = record.complex("point_deflection");
  result.wave_elevation = record.complex("wave_elevation");
  const auto count = static_cast<std::size_t>(record.number("quantities"));
  for (std::size_t q = 0; q < count; ++q)
    result.point_quantities.push_back(record.complex("quantity " + std::to_string(q)));
  const auto fields = static_cast<std::size_t>(record.number("fields"));
  for (std::size_t f = 0; f < fields; ++f) {
    const MatXcd values = record.complex("field " + std::to_string(f));
    result.fields.push_back({result.omega, record.number("field heading " + std::to_string(f)),
                             values.col(0), values.col(1), values.col(2), values.col(3)});
  }
  const std::vector<double> report = as_list<double>(record.real("report"));
  result.report = {.omega = result.omega,
                   .method = record.text("method"),
                   .iterations = static_cast<int>(report.at(0)),
                   .applications = static_cast<long>(report.at(1)),
                   .true_residual = report.at(2),
                   .kernel_error = report.at(3),
                   .reciprocity_error = report.at(4),
                   .energy_error = report.at(5),
                   .seconds = report.at(6)};
  return result;
}

Record record_of(const SeaObservation& observation, const SeaGridReport& grid) {
  Record record;
  record.put("quantity", as_vector(observation.quantity));
  record.put("derivative", as_vector(observation.derivative));
  record.put("points", observation.points);
  record.put("lines", observation.lines);
  record.put("nodes", observation.nodes);
  record.put("omega", as_vector(grid.omega));
  record.put("headings", static_cast<double>(grid.headings));
  return record;
}

SeaObservation observation_from(const Record& record) {
  return {as_list<std::size_t>(record.real("quantity")), as_list<int>(record.real("derivative")),
          record.real("points"), record.real("lines"), record.real("nodes")};
}

SeaGridReport sea_grid_from(const Record& record) {
  return {as_list<double>(record.real("omega")), static_cast<int>(record.number("headings")), 0.0,
          0};
}

Record record_of(const SeaGridReport& grid) {
  Record record;
  record.put("omega", as_vector(grid.omega));
  record.put("headings", static_cast<double>(grid.headings));
  record.put("interpolation_error", grid.interpolation_error);
  record.put("solved_frequencies", static_cast<double>(grid.solved_frequencies));
  return record;
}

SeaGridReport finished_grid_from(const Record& record) {
  SeaGridReport grid = sea_grid_from(record);
  grid.interpolation_error = record.number("interpolation_error");
  grid.solved_frequencies = static_cast<int>(record.number("solved_frequencies"));
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

Record record_of(const SeaResult& result) {
  Record record;
  record.put("sea", result.sea);
  record.put("omega", as_vector(result.omega));
  record.put("quantity", as_vector(result.quantity));
  for (std::size_t q = 0; q < result.quantity.size(); ++q) {
    record.put("spectra " + std::to_string(q), result.spectra[q]);
    record.put("moments " + std::to_string(q), result.moments[q]);
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
  result.line_deviation = record.real("line_deviation");
  result.node_moments = record.real("node_moments");
  const std::vector<double> facts = as_list<double>(record.real("facts"));
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
