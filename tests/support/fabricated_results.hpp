#pragma once

#include <floe/analysis.hpp>

/// Results without a solver: numbers that are easy to recognise.
namespace floe::test {

/// A case of a 4 × 2 element rectangle with two points, one line, one wave point, two quantities.
inline Case small_case() {
  Case data;
  data.title = "small";
  data.water = {.depth = 20.0};
  data.plate = {.thickness = 2.0,
                .youngs_modulus = 1.19e10,
                .poisson_ratio = 0.13,
                .density = 256.25,
                .shear_correction = 5.0 / 6.0,
                .loss_factor = 0.0};
  data.mesh =
      mesh::RectangleOptions{.length = 40.0, .width = 20.0, .nx = 4, .ny = 2, .grading = 1.0};
  data.mode_count = 4;
  data.omega = {0.4, 0.5};
  data.heading_deg = {0.0, 30.0};
  data.points = {{"P1", Point2(-20.0, -10.0)}, {"P2", Point2(0.0, 0.0)}};
  data.lines = {{"centreline", Point2(-20.0, 0.0), Point2(20.0, 0.0), 5}};
  data.wave_points = {{"lee", Point2(60.0, 0.0)}};
  data.quantities = {response::Quantity::kDeflection, response::Quantity::kPressure};
  return data;
}

inline mesh::Q8Mesh small_mesh() {
  return mesh::make_rectangle(std::get<mesh::RectangleOptions>(small_case().mesh));
}

/// Heave, roll and pitch of a body of 4 kg and a bent shape, as if mass-normalised.
inline plate::DryModes small_modes() {
  plate::DryModes modes;
  modes.omega = (VecXd(4) << 0.0, 0.0, 0.0, 1.0 / 3.0).finished();
  modes.rigid_count = 3;
  modes.rotary_inertia = VecXd::Zero(1);
  modes.modal_mass = MatXd::Identity(4, 4);
  const mesh::Q8Mesh mesh = small_mesh();
  modes.shape = MatXd::Zero(3 * mesh.node_count(), 4);
  for (Index n = 0; n < mesh.node_count(); ++n) {
    const double x = mesh.nodes()(0, n), y = mesh.nodes()(1, n);
    modes.shape.middleRows<3>(3 * n) << 0.5, 0.1 * y, -0.05 * x, 1e-3 * x * x,  //
        0.0, 0.1, 0.0, 0.0,                                                     //
        0.0, 0.0, 0.05, -2e-3 * x;
  }
  return modes;
}

/// Entry (i, j) is (omega + i, 0.1 + j).
inline MatXcd numbered(double omega, Index rows, Index columns) {
  MatXcd value(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j)
      value(i, j) = {omega + static_cast<double>(i), 0.1 + static_cast<double>(j)};
  return value;
}

inline FrequencyResult small_result(double omega) {
  FrequencyResult result;
  result.omega = omega;
  result.wavenumber = omega * omega / 9.81;
  result.added_mass = numbered(omega, 4, 4).real();
  result.damping = numbered(omega, 4, 4).imag();
  result.exciting_force = numbered(omega, 4, 2);
  result.froude_krylov_force = numbered(0.5 * omega, 4, 2);
  result.amplitudes = numbered(omega, 4, 2);
  result.line_deflection = numbered(omega, 5, 2);
  result.point_deflection = numbered(omega, 2, 2);
  result.point_quantities = {numbered(omega, 2, 2), 1000.0 * numbered(omega, 2, 2)};
  result.wave_elevation = numbered(omega, 1, 2);
  const Index nodes = small_mesh().node_count();
  NodeField field;
  field.omega = omega;
  field.heading_deg = 30.0;
  field.deflection = numbered(omega, nodes, 1);
  field.rotation_x = numbered(2.0 * omega, nodes, 1);
  field.rotation_y = numbered(3.0 * omega, nodes, 1);
  field.pressure = numbered(4.0 * omega, nodes, 1);
  result.fields = {field};
  result.report.omega = omega;
  result.report.method = "dense";
  result.report.true_residual = 1e-14;
  return result;
}

}  // namespace floe::test
