#include "analysis_stages.hpp"
#include "finite_checks.hpp"

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/residual_between_nodes.hpp>
#include <floe/bem/sampled_residual.hpp>
#include <floe/coupling/coupled_operator.hpp>
#include <floe/hydro/flexural_gravity.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/hydro/wave_field.hpp>
#include <floe/krylov/gmres.hpp>
#include <floe/numeric/blas_check.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/plate_compliance.hpp>
#include <floe/wave/dispersion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe {
namespace {

// The plate as the fluid's nodes feel it: pressures to loads, loads to displacements
class PlateOnWater final : public coupling::Compliance {
 public:
  PlateOnWater(const Case& data, const PlateModel& plate, const FluidModel& fluid, double omega)
      : surface_mass_(fluid.surface_mass),
        to_fluid_(plate.to_fluid),
        compliance_(*plate.matrices, data.plate.loss_factor, omega, foundation(data)) {}

  MatXcd deflection(const Eigen::Ref<const MatXcd>& pressure) const override {
    return deflection_of(displacement(pressure));
  }
  // d on the plate's mesh, 3N × columns
  MatXcd displacement(const Eigen::Ref<const MatXcd>& pressure) const {
    MatXcd load = surface_mass_.cast<Complex>() * pressure;
    if (to_fluid_.size() > 0) load = (to_fluid_.transpose().cast<Complex>() * load).eval();
    return compliance_.displacement(load);
  }
  // An unknown of the plate at the fluid's nodes
  MatXcd deflection_of(const MatXcd& displacement, Index unknown = 0) const {
    const MatXcd value =
        displacement(Eigen::seq(unknown, Eigen::last, plate::kUnknownsPerNode), Eigen::all);
    return to_fluid_.size() > 0 ? MatXcd(to_fluid_.cast<Complex>() * value) : value;
  }

 private:
  // The water's stiffness on the plate's deflections
  SparseMatrix foundation(const Case& data) const {
    const double weight = data.water.density * data.water.gravity;
    if (to_fluid_.size() == 0) return weight * surface_mass_;
    return weight * SparseMatrix(to_fluid_.transpose() * surface_mass_ * to_fluid_);
  }

  const SparseMatrix& surface_mass_;
  const SparseMatrix& to_fluid_;
  plate::PlateCompliance compliance_;
};

// The region of most elements stands for all: this one only speeds the iteration up
bem::FloatingPlate floating_plate(const Case& data, const plate::PlateRegions& regions,
                                  double omega) {
  const std::vector<Index> count = regions.element_counts();
  const plate::PlateProperties& typical =
      regions[static_cast<int>(std::max_element(count.begin(), count.end()) - count.begin())];
  const double weight = data.water.density * data.water.gravity;
  return {.rigidity = typical.bending_rigidity() / weight,
          .inertia = typical.surface_mass() * omega * omega / weight,
          .wavenumber = hydro::flexural_wavenumber(omega, data.water, typical)};
}

// Of the fluid's equation (I + κ𝒢)p = ρg(ζ₀ - w) by the exact operator, relative to ρgζ₀, and what
// it leaves between the nodes
void check_residuals(const Case& data, const FluidModel& fluid, const green::GreenTable& green,
                     const MatXcd& incident, const MatXcd& pressure, const MatXcd& deflection,
                     FrequencyResult& result) {
  const double weight = data.water.density * data.water.gravity;
  const MatXcd known = incident - weight * deflection;
  result.report.exact_residual =
      bem::sampled_residual(fluid.integrals, green, pressure, known, incident);
  result.report.residual_between_nodes =
      bem::residual_between_nodes(fluid.integrals, green, pressure, known);
}

// Power that the waves bring against what they take away and the plate loses (H.10), and what one
// heading's pressure does on another's wave against the reverse
void check_physics(const Case& data, const FluidModel& fluid, const green::GreenTable& green,
                   const MatXcd& pressure, const MatXcd& deflection, FrequencyResult& result) {
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double k = result.wavenumber, weight = data.water.density * data.water.gravity;
  const MatXcd loads = hydro::wave_loads(mesh, k, fluid.heading);
  const MatXcd work = pressure.transpose() * loads.conjugate();  // ∫ p ζ* dS
  const double half_diagonal = 0.5 * (mesh.upper() - mesh.lower()).norm();
  const int count = 20 + 2 * static_cast<int>(std::ceil(k * half_diagonal));
  const MatXcd far =  // headings × count
      hydro::full_circle_transform(mesh, k, count, pressure);
  const VecXd radiated = green.exact().nu() / (4.0 * std::numbers::pi) *
                         std::abs(green.exact().wave().coefficient) / count *
                         far.cwiseAbs2().rowwise().sum();
  for (Index b = 0; b < pressure.cols(); ++b) {
    const Complex absorbed = deflection.col(b).dot(fluid.surface_mass * pressure.col(b));
    const double brought = -weight * work(b, b).imag();
    result.report.energy_error = std::max(
        result.report.energy_error,
        std::abs(brought + weight * absorbed.imag() - radiated[b]) / std::abs(weight * work(b, b)));
  }
  const MatXcd crossed = pressure.transpose() * loads;  // ∫ p_β ζ_γ dS
  result.report.reciprocity_error = (crossed - crossed.transpose()).norm() / crossed.norm();
}

// All that follows from displacement and pressure of every heading
void read_off(const Case& data, const PlateModel& plate, const FluidModel& fluid,
              const PlateOnWater& compliance, const green::GreenTable& green,
              const MatXcd& displacement, const MatXcd& pressure, FrequencyResult& result) {
  const auto deflection = response::Quantity::kDeflection;
  result.point_deflection =
      plate.points.evaluate_displacement(deflection, result.omega, displacement);
  result.line_deflection =
      plate.lines.evaluate_displacement(deflection, result.omega, displacement);
  result.point_quantities.resize(data.quantities.size());
  for (std::size_t q = 0; q < data.quantities.size(); ++q)
    if (response::is_structural(data.quantities[q]))
      result.point_quantities[q] =
          plate.points.evaluate_displacement(data.quantities[q], result.omega, displacement);
  add_pressures(data, fluid, pressure, result);
  add_wave_elevation(data, fluid, green, pressure, result);
  for (const Index b : field_headings(data, result.omega)) {
    const MatXcd column = displacement.col(b);
    result.fields.push_back({result.omega, data.heading_deg[static_cast<std::size_t>(b)],
                             compliance.deflection_of(column, 0),
                             compliance.deflection_of(column, 1),
                             compliance.deflection_of(column, 2), pressure.col(b)});
  }
}

}  // namespace

FrequencyResult solve_frequency_direct(const Case& data, const PlateModel& plate,
                                       const FluidModel& fluid, double omega, StageClock& clock) {
  const auto start = std::chrono::steady_clock::now();
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double weight = data.water.density * data.water.gravity;
  FrequencyResult result;
  result.omega = omega;
  result.wavenumber = wave::wavenumber(omega, data.water);
  result.report.omega = omega;
  result.report.processor = numeric::processor_kind();
  result.report.method = method_name(fluid.operators.method);

  // Set up water and plate
  const green::GreenTable green = clock.time("Green function", [&] {
    const double nu = wave::deep_wavenumber(omega, data.water);
    return green::GreenTable(green::GreenFunction(nu, data.water.depth), fluid.reach);
  });
  const auto action = clock.time("operator", [&] { return make_action(fluid, green); });
  const auto step_action = clock.time("operator", [&] { return make_step_action(fluid, green); });
  const PlateOnWater compliance =
      clock.time("plate", [&] { return PlateOnWater(data, plate, fluid, omega); });
  const coupling::CoupledOperator coupled(*action, compliance, weight);
  const coupling::CoupledOperator step_coupled(step_action ? *step_action : *action, compliance,
                                               weight);

  // Solve for all headings together
  const MatXcd incident =
      weight * hydro::incident_elevation(mesh.nodes(), result.wavenumber, fluid.heading);
  MatXcd total(mesh.node_count(), static_cast<Index>(fluid.heading.size()));
  clock.time("coupled equation", [&] {
    const bem::DampedWavePreconditioner preconditioner(
        mesh, green.exact(), {.plate = floating_plate(data, plate.regions, omega)});
    krylov::GmresOptions options = iteration_options(data, fluid);
    if (step_action) options.step_operator = &step_coupled;
    const krylov::GmresReport solved =
        krylov::solve_gmres(coupled, {.action = &preconditioner}, incident, total, options);
    result.report.iterations = static_cast<int>(solved.iterations);
    result.report.applications = solved.applications;
    result.report.true_residual = solved.true_residual.maxCoeff();
  });

  // Take plate and pressure apart, read off the response
  clock.time("response", [&] {
    const MatXcd displacement = compliance.displacement(total);
    const MatXcd deflection = compliance.deflection_of(displacement);
    const MatXcd pressure = total - weight * deflection;
    result.exciting_force.resize(0, total.cols());
    read_off(data, plate, fluid, compliance, green, displacement, pressure, result);
    check_physics(data, fluid, green, pressure, deflection, result);
    check_residuals(data, fluid, green, incident, pressure, deflection, result);
    require_finite(result);
  });
  result.report.kernel_error = green.sampled_error(200);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.report.seconds = elapsed.count();
  return result;
}

}  // namespace floe
