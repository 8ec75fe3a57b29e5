#pragma once

#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/wave/dispersion.hpp>

/// A plate on water at one frequency, solved densely: what many hydrodynamic tests start from.
namespace floe::test {

/// The water of the paper's Table 1.
inline wave::Water table1_water() { return {.depth = 58.5, .density = 1025.0, .gravity = 9.81}; }

/// Heave w = 1, pitch w = x/(L/2), roll w = y/(B/2) at the nodes, N × 3, the order of the
/// reference.
inline MatXd rigid_deflections(const mesh::Q8Mesh& mesh) {
  MatXd deflection(mesh.node_count(), 3);
  deflection.col(0).setOnes();
  deflection.col(1) = mesh.nodes().row(0).transpose() / mesh.upper().x();
  deflection.col(2) = mesh.nodes().row(1).transpose() / mesh.upper().y();
  return deflection;
}

inline green::GreenTable green_table(double omega, const wave::Water& water, double reach) {
  return {green::GreenFunction(wave::deep_wavenumber(omega, water), water.depth), reach};
}

/// Radiation by given deflections (default: rigid motions).
struct SolvedPlate {
  SolvedPlate(const mesh::Q8Mesh& plate_mesh, double frequency, const wave::Water& calm_water,
              double reach = 0.0)
      : mesh(plate_mesh),
        omega(frequency),
        water(calm_water),
        wavenumber(wave::wavenumber(omega, water)),
        integrals(mesh),
        green(green_table(omega, water,
                          reach > 0.0 ? reach : 1.01 * (mesh.upper() - mesh.lower()).norm())),
        pressure_operator(integrals, green),
        surface_mass(hydro::surface_mass(mesh)),
        deflection(rigid_deflections(mesh)),
        radiation(hydro::solve_radiation(pressure_operator, deflection, surface_mass, omega, water,
                                         1e-10)) {}

  const mesh::Q8Mesh& mesh;
  double omega;
  wave::Water water;
  double wavenumber;
  bem::ElementIntegrals integrals;
  green::GreenTable green;
  bem::DensePressureOperator pressure_operator;
  SparseMatrix surface_mass;
  MatXd deflection;
  hydro::Radiation radiation;
};

}  // namespace floe::test
