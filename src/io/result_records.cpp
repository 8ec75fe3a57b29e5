#include "io/result_records.hpp"

#include "io/record_numbers.hpp"

#include <string>

namespace floe::io {
namespace {

// Node numbers; those out of range are left to the mesh to refuse
mesh::Connectivity elements_of(const MatXd& stored) {
  FLOE_VALIDATE_AS(StoreError, stored.rows() == 8, "a record's elements have no eight nodes");
  return stored.unaryExpr([](double node) { return static_cast<double>(count_of<Index>(node)); })
      .cast<Index>();
}

}  // namespace

Record record_of(const mesh::Q8Mesh& mesh) {
  Record record;
  record.put("nodes", mesh.nodes());
  record.put("elements", mesh.elements().cast<double>());
  return record;
}

mesh::Q8Mesh mesh_from(const Record& record) {
  const MatXd nodes = record.real("nodes");
  FLOE_VALIDATE_AS(StoreError, nodes.rows() == 2, "a record's nodes have no two coordinates");
  return mesh::Q8Mesh(nodes, elements_of(record.real("elements")));
}

Record record_of(const plate::DryModes& modes) {
  Record record;
  record.put("omega", modes.omega);
  record.put("shape", modes.shape);
  record.put("modal_mass", modes.modal_mass);
  record.put("rigid_count", static_cast<double>(modes.rigid_count));
  record.put("rotary_inertia", modes.rotary_inertia);
  record.put("estimated_frequency_error", modes.estimated_frequency_error);
  record.put("orthonormality_error", modes.orthonormality_error);
  record.put("rigid_force_error", modes.rigid_force_error);
  return record;
}

plate::DryModes modes_from(const Record& record) {
  plate::DryModes modes;
  modes.omega = record.real("omega");
  modes.shape = record.real("shape");
  modes.modal_mass = record.real("modal_mass");
  modes.rigid_count = count_of<int>(record.number("rigid_count"));
  modes.rotary_inertia = record.real("rotary_inertia");
  modes.estimated_frequency_error = record.number("estimated_frequency_error");
  modes.orthonormality_error = record.number("orthonormality_error");
  modes.rigid_force_error = record.number("rigid_force_error");
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
                              report.exact_residual, report.passivity_error,
                              report.residual_between_nodes, report.mode_change}});
  record.put(kSeconds, report.seconds);
  record.put(kProcessor, report.processor);
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
  const auto count = count_of<std::size_t>(record.number("quantities"));
  for (std::size_t q = 0; q < count; ++q)
    result.point_quantities.push_back(record.complex("quantity " + std::to_string(q)));
  const auto fields = count_of<std::size_t>(record.number("fields"));
  for (std::size_t f = 0; f < fields; ++f) {
    const MatXcd values = record.complex("field " + std::to_string(f));
    FLOE_VALIDATE_AS(StoreError, values.cols() == 4, "a record's field has no four columns");
    result.fields.push_back({result.omega, record.number("field heading " + std::to_string(f)),
                             values.col(0), values.col(1), values.col(2), values.col(3)});
  }
  const std::vector<double> report = facts_of(record, "report", 10);
  result.report = {.omega = result.omega,
                   .method = record.text("method"),
                   .iterations = static_cast<int>(report.at(0)),
                   .applications = static_cast<long>(report.at(1)),
                   .true_residual = report.at(2),
                   .kernel_error = report.at(3),
                   .reciprocity_error = report.at(4),
                   .energy_error = report.at(5),
                   .exact_residual = report.at(6),
                   .residual_between_nodes = report.at(8),
                   .mode_change = report.at(9),
                   .passivity_error = report.at(7),
                   .seconds = record.number(kSeconds),
                   .processor = record.holds(kProcessor) ? record.text(kProcessor) : ""};
  return result;
}

Record record_of_failure(const FrequencyReport& report) {
  Record record;
  record.put("omega", report.omega);
  record.put("failure", report.failure);
  return record;
}

std::string failure_from(const Record& record) { return record.text("failure"); }

}  // namespace floe::io
