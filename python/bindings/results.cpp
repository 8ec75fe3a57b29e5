#include "bindings.hpp"

#include <floe/self_checks.hpp>

namespace floe::python {
namespace {

using Frequencies = std::vector<FrequencyResult>;

// frequency × heading × row of a matrix rows × headings that every frequency has
py::array_t<Complex> by_wave(const Frequencies& frequencies, MatXcd FrequencyResult::*matrix) {
  if (frequencies.empty()) return py::array_t<Complex>(std::vector<py::ssize_t>{0, 0, 0});
  const MatXcd& first = frequencies.front().*matrix;
  return stack_transposed<Complex>(
      frequencies.size(), first.rows(), first.cols(),
      [&](std::size_t i) -> const MatXcd& { return frequencies[i].*matrix; });
}

// frequency × influenced mode × radiating mode
py::array_t<double> by_mode(const Frequencies& frequencies, MatXd FrequencyResult::*matrix) {
  if (frequencies.empty()) return py::array_t<double>(std::vector<py::ssize_t>{0, 0, 0});
  const MatXd& first = frequencies.front().*matrix;
  return stack_transposed<double>(
      frequencies.size(), first.cols(), first.rows(),
      [&](std::size_t i) -> MatXd { return (frequencies[i].*matrix).transpose(); });
}

template <typename Number>
py::array_t<Number> one_each(const Frequencies& frequencies, Number FrequencyResult::*member) {
  py::array_t<Number> array(static_cast<py::ssize_t>(frequencies.size()));
  for (std::size_t i = 0; i < frequencies.size(); ++i)
    array.mutable_data()[i] = frequencies[i].*member;
  return array;
}

py::dict quantity_dictionary(const RunResults& results) {
  py::dict quantities;
  if (results.frequencies.empty()) return quantities;
  for (std::size_t q = 0; q < results.data.quantities.size(); ++q) {
    const MatXcd& first = results.frequencies.front().point_quantities[q];
    quantities[py::str(std::string(response::name(results.data.quantities[q])))] =
        stack_transposed<Complex>(results.frequencies.size(), first.rows(), first.cols(),
                                  [&](std::size_t i) -> const MatXcd& {
                                    return results.frequencies[i].point_quantities[q];
                                  });
  }
  return quantities;
}

py::dict named_points(const std::vector<NamedPoint>& points) {
  py::dict named;
  for (const NamedPoint& point : points)
    named[py::str(point.name)] = py::make_tuple(point.position.x(), point.position.y());
  return named;
}

py::list line_list(const std::vector<NamedLine>& lines) {
  py::list list;
  for (const NamedLine& line : lines)
    list.append(py::make_tuple(line.name, py::make_tuple(line.from.x(), line.from.y()),
                               py::make_tuple(line.to.x(), line.to.y()), line.count));
  return list;
}

py::list field_list(const Frequencies& frequencies) {
  py::list list;
  for (const FrequencyResult& result : frequencies)
    for (const NodeField& field : result.fields)
      list.append(py::dict(py::arg("omega") = field.omega,
                           py::arg("heading_deg") = field.heading_deg,
                           py::arg("deflection") = vector_array(field.deflection),
                           py::arg("rotation_x") = vector_array(field.rotation_x),
                           py::arg("rotation_y") = vector_array(field.rotation_y),
                           py::arg("pressure") = vector_array(field.pressure)));
  return list;
}

py::list report_list(const Frequencies& frequencies) {
  py::list list;
  for (const FrequencyResult& result : frequencies) {
    const FrequencyReport& report = result.report;
    list.append(py::dict(py::arg("omega") = report.omega, py::arg("method") = report.method,
                         py::arg("iterations") = report.iterations,
                         py::arg("applications") = report.applications,
                         py::arg("true_residual") = report.true_residual,
                         py::arg("kernel_error") = report.kernel_error,
                         py::arg("reciprocity_error") = report.reciprocity_error,
                         py::arg("energy_error") = report.energy_error,
                         py::arg("exact_residual") = report.exact_residual,
                         py::arg("residual_between_nodes") = report.residual_between_nodes,
                         py::arg("mode_change") = report.mode_change,
                         py::arg("seconds") = report.seconds, py::arg("failure") = report.failure));
  }
  return list;
}

std::vector<SelfCheck> checks_of(const RunResults& results) {
  if (results.frequencies.empty() || !results.fluid_mesh) return {};
  std::vector<FrequencyReport> reports;
  for (const FrequencyResult& result : results.frequencies) reports.push_back(result.report);
  const plate::PlateRegions regions = plate_regions(results.data);
  const plate::PlateRegions* const known = results.data.plate_mesh.empty() ? &regions : nullptr;
  std::vector<Resolution> resolution =
      preflight(results.data, *results.fluid_mesh, nullptr, known).resolution;
  const std::vector<SolvedSeaFrequency>& seas = results.sea_grid.solved;
  const std::vector<Resolution> of_seas =
      sea_resolution(results.data, seas, *results.fluid_mesh, nullptr, known);
  resolution.insert(resolution.end(), of_seas.begin(), of_seas.end());
  return self_checks(results.data, resolution, results.modes, reports, seas);
}

py::list check_list(const std::vector<SelfCheck>& checks) {
  py::list list;
  for (const SelfCheck& check : checks) {
    list.append(py::dict(py::arg("name") = check.name, py::arg("value") = check.value,
                         py::arg("limit") = check.limit, py::arg("omega") = check.omega,
                         py::arg("status") = status_name(check.status),
                         py::arg("meaning") = check.meaning));
  }
  return list;
}

py::array_t<double> matrix_array(const MatXd& matrix) {
  return stack_transposed<double>(1, matrix.cols(), matrix.rows(),
                                  [&](std::size_t) -> MatXd { return matrix.transpose(); })
      .reshape(std::vector<py::ssize_t>{matrix.rows(), matrix.cols()});
}

py::dict combination_dictionary(const Case& data, const SeaResult& sea) {
  py::dict combinations;
  for (std::size_t i = 0; i < sea.combinations.size(); ++i) {
    const CombinationResult& found = sea.combinations[i];
    combinations[py::str(data.relations.combinations[i].name)] =
        py::dict(py::arg("spectrum") = vector_array(found.spectrum),
                 py::arg("moments") = vector_array(found.moments),
                 py::arg("most_probable_maximum") = found.most_probable_maximum);
  }
  return combinations;
}

py::list pair_list(const Case& data, const SeaResult& sea) {
  const auto named = [&](const PointQuantity& of) {
    return py::make_tuple(data.points[of.point].name,
                          std::string(response::name(data.quantities[of.quantity])));
  };
  py::list pairs;
  for (std::size_t i = 0; i < sea.pairs.size(); ++i) {
    const QuantityPair& pair = data.relations.pairs[i];
    const PairResult& found = sea.pairs[i];
    pairs.append(py::dict(
        py::arg("first") = named(pair.first), py::arg("second") = named(pair.second),
        py::arg("spectrum") = vector_array(found.spectrum),
        py::arg("covariance") = found.covariance, py::arg("correlation") = found.correlation));
  }
  return pairs;
}

py::dict sea_dictionary(const Case& data, const SeaResult& sea) {
  py::dict spectra, moments;
  for (std::size_t i = 0; i < sea.quantity.size(); ++i) {
    const py::str name(std::string(response::name(data.quantities[sea.quantity[i]])));
    spectra[name] = matrix_array(sea.spectra[i]);
    moments[name] = matrix_array(sea.moments[i]);
  }
  return py::dict(
      py::arg("sea") = sea.sea, py::arg("mean_heading_deg") = sea.mean_heading_deg,
      py::arg("omega") = py::array_t<double>(sea.omega.size(), sea.omega.data()),
      py::arg("spectra") = spectra, py::arg("moments") = moments,
      py::arg("line_deviation") = vector_array(sea.line_deviation),
      py::arg("node_moments") = matrix_array(sea.node_moments), py::arg("duration") = sea.duration,
      py::arg("significant_height") = sea.significant_height,
      py::arg("share_outside") = sea.share_outside, py::arg("grid_error") = sea.grid_error,
      py::arg("combinations") = combination_dictionary(data, sea),
      py::arg("pairs") = pair_list(data, sea));
}

}  // namespace

py::array_t<double> shape_array(const MatXd& shape) {
  py::array_t<double> array({shape.cols(), shape.rows() / 3, Index{3}});
  std::copy(shape.data(), shape.data() + shape.size(), array.mutable_data());
  return array;
}

py::list sea_list(const Case& data, const std::vector<SeaResult>& seas) {
  py::list list;
  for (const SeaResult& sea : seas) list.append(sea_dictionary(data, sea));
  return list;
}

py::dict dictionary_of(const RunResults& results) {
  const Frequencies& waves = results.frequencies;
  py::dict all;
  all["title"] = results.data.title;
  all["case_text"] = results.data.text;
  all["water"] = py::dict(py::arg("depth") = results.data.water.depth,
                          py::arg("density") = results.data.water.density,
                          py::arg("gravity") = results.data.water.gravity);
  all["omega"] = one_each(waves, &FrequencyResult::omega);
  all["wavenumber"] = one_each(waves, &FrequencyResult::wavenumber);
  all["heading_deg"] =
      py::array_t<double>(results.data.heading_deg.size(), results.data.heading_deg.data());
  all["mesh"] = results.fluid_mesh;
  all["mode_mesh"] = results.mode_mesh;
  all["mode_omega"] = vector_array(results.modes.omega);
  all["mode_shape"] = shape_array(results.modes.shape);
  all["rigid_count"] = results.modes.rigid_count;
  all["added_mass"] = by_mode(waves, &FrequencyResult::added_mass);
  all["damping"] = by_mode(waves, &FrequencyResult::damping);
  all["exciting_force"] = by_wave(waves, &FrequencyResult::exciting_force);
  all["froude_krylov_force"] = by_wave(waves, &FrequencyResult::froude_krylov_force);
  all["amplitudes"] = by_wave(waves, &FrequencyResult::amplitudes);
  all["points"] = named_points(results.data.points);
  all["point_deflection"] = by_wave(waves, &FrequencyResult::point_deflection);
  all["quantities"] = quantity_dictionary(results);
  all["_lines"] = line_list(results.data.lines);
  all["_line_deflection"] = by_wave(waves, &FrequencyResult::line_deflection);
  all["wave_points"] = named_points(results.data.wave_points);
  all["wave_elevation"] = by_wave(waves, &FrequencyResult::wave_elevation);
  all["fields"] = field_list(waves);
  all["seas"] = sea_list(results.data, results.seas);
  all["reports"] = report_list(waves);
  const std::vector<SelfCheck> checks = checks_of(results);
  std::vector<std::string> warnings = results.warnings;
  for (const std::string& warning : warnings_of(checks)) warnings.push_back(warning);
  all["checks"] = check_list(checks);
  all["notices"] = results.notices;
  all["warnings"] = warnings;
  return all;
}

}  // namespace floe::python
