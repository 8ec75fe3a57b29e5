#include "io/netcdf_parts.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

constexpr const char* kMatrixUnits =
    "SI: kg, kg m, kg m^2 (times 1/s for damping, 1/s^2 for stiffness) between Heave, Roll, Pitch; "
    "kg^(1/2), kg^(1/2) m with an elastic mode; 1 between elastic modes";
constexpr const char* kForceUnits =
    "N/m, N m/m for Roll and Pitch, N/(m kg^(1/2)) for elastic modes";

using Names = std::vector<std::string>;

void add_scalar(NetcdfFile& file, const std::string& name, double value,
                const std::string& long_name, const std::string& units) {
  file.add_numbers(name, {}, std::vector<double>{value});
  describe(file, name, long_name, units);
}

// One number a frequency
void add_series(NetcdfFile& file, const BodyResults& results, const std::string& name,
                const std::function<double(const BodyFrequency&)>& value) {
  std::vector<double> values;
  for (const BodyFrequency& frequency : results.frequencies) values.push_back(value(frequency));
  file.add_numbers(name, {"omega"}, values);
}

void add_count(NetcdfFile& file, const BodyResults& results, const std::string& name,
               const std::function<int(const BodyFrequency&)>& value) {
  std::vector<int> values;
  for (const BodyFrequency& frequency : results.frequencies) values.push_back(value(frequency));
  file.add_integers(name, {"omega"}, values);
}

// The other four ways to tell a frequency lie along the first
void add_frequencies(NetcdfFile& file, const BodyResults& results) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  file.add_dimension("omega", results.frequencies.size());
  add_series(file, results, "omega", [](const BodyFrequency& f) { return f.omega; });
  describe(file, "omega", "Angular frequency", "rad/s");
  add_series(file, results, "freq", [](const BodyFrequency& f) { return f.omega / kTurn; });
  describe(file, "freq", "Frequency", "Hz");
  add_series(file, results, "period", [](const BodyFrequency& f) { return kTurn / f.omega; });
  describe(file, "period", "Period", "s");
  add_series(file, results, "wavenumber", [](const BodyFrequency& f) { return f.wavenumber; });
  describe(file, "wavenumber", "Angular wavenumber", "rad/m");
  add_series(file, results, "wavelength",
             [](const BodyFrequency& f) { return kTurn / f.wavenumber; });
  describe(file, "wavelength", "Wave length", "m");
}

void add_bodies(NetcdfFile& file, const BodyResults& results) {
  const plate::BodyDofs& dofs = results.dofs;
  add_axis(file, "body", dofs.body, "Body");
  add_axis(file, "space_coordinate", {"x", "y", "z"}, "Coordinate");
  file.add_texts("body_name", {}, {results.body_name()});
  describe(file, "body_name", "Names of all bodies");
  std::vector<double> centres;
  for (Index b = 0; b < dofs.centre.cols(); ++b)
    centres.insert(centres.end(), {dofs.centre(0, b), dofs.centre(1, b), 0.0});
  for (const auto& [name, words] : {std::pair{"rotation_center", "Centre of the unit rotations"},
                                    std::pair{"center_of_mass", "Centre of mass"}}) {
    file.add_numbers(name, {"body", "space_coordinate"}, centres);
    describe(file, name, words, "m");
  }
  file.add_numbers("disp_mass", {"body"}, std::span(dofs.mass.data(), dofs.body.size()));
  describe(file, "disp_mass", "Mass of the body, and of the water that it displaces", "kg",
           "the method gives the plate no draft; its weight is carried by the mean pressure");
}

// One real matrix a frequency
void add_matrices(NetcdfFile& file, const BodyResults& results, const std::string& name,
                  const std::string& long_name, MatXd BodyFrequency::*matrix) {
  std::vector<double> values;
  for (const BodyFrequency& frequency : results.frequencies) {
    const MatXd rows_fastest = (frequency.*matrix).transpose();
    values.insert(values.end(), rows_fastest.data(), rows_fastest.data() + rows_fastest.size());
  }
  file.add_numbers(name, {"omega", "influenced_dof", "radiating_dof"}, values);
  describe(file, name, long_name, "", kMatrixUnits);
}

void add_matrix(NetcdfFile& file, const std::string& name, const std::string& long_name,
                const MatXd& matrix, const std::string& comment) {
  const MatXd rows_fastest = matrix.transpose();
  file.add_numbers(name, {"influenced_dof", "radiating_dof"},
                   std::span(rows_fastest.data(), static_cast<std::size_t>(rows_fastest.size())));
  describe(file, name, long_name, "", comment);
}

// One complex matrix dofs × headings a frequency
void add_complex(NetcdfFile& file, const std::string& name, const std::string& long_name,
                 const std::vector<MatXcd>& matrices, const std::string& comment) {
  file.add_numbers(name, {"complex", "omega", "wave_direction", "influenced_dof"},
                   split_complex(matrices));
  describe(file, name, long_name, "", comment);
}

}  // namespace

void add_coordinates(NetcdfFile& file, const StoredRun& run, const BodyResults& results) {
  add_frequencies(file, results);
  std::vector<double> directions;
  for (const double heading : results.heading_deg) directions.push_back(kDegree * heading);
  file.add_dimension("wave_direction", directions.size());
  file.add_numbers("wave_direction", {"wave_direction"}, directions);
  describe(file, "wave_direction", "Wave direction", "rad");
  add_axis(file, "complex", {"re", "im"}, "Real and imaginary part");
  add_axis(file, "influenced_dof", results.dof_names(), "Influenced DOF");
  add_axis(file, "radiating_dof", results.dof_names(), "Radiating DOF");
  add_bodies(file, results);

  const Case& data = run.data();
  add_scalar(file, "g", data.water.gravity, "Gravity", "m/s^2");
  add_scalar(file, "rho", data.water.density, "Density of water", "kg/m^3");
  add_scalar(file, "water_depth", data.water.depth, "Water depth", "m");
  add_scalar(file, "forward_speed", 0.0, "Forward speed", "m/s");
  file.add_integers("nb_faces", {},
                    std::vector<int>{static_cast<int>(run.fluid_mesh().element_count())});
  describe(file, "nb_faces", "Number of quadratic quadrilaterals under water");
  file.add_attribute("", "coordinates",
                     "freq period wavenumber wavelength body_name g rho water_depth forward_speed "
                     "nb_faces");
}

void add_hydrodynamics(NetcdfFile& file, const BodyResults& results) {
  add_matrices(file, results, "added_mass", "Added mass", &BodyFrequency::added_mass);
  add_matrices(file, results, "radiation_damping", "Radiation damping", &BodyFrequency::damping);

  std::vector<MatXcd> diffraction, froude_krylov, excitation, response;
  for (const BodyFrequency& frequency : results.frequencies) {
    diffraction.push_back(frequency.diffraction);
    froude_krylov.push_back(frequency.froude_krylov);
    excitation.push_back(frequency.froude_krylov + frequency.diffraction);
    response.push_back(frequency.response);
  }
  add_complex(file, "diffraction_force", "Diffraction force", diffraction, kForceUnits);
  add_complex(file, "Froude_Krylov_force", "Froude Krylov force", froude_krylov, kForceUnits);
  add_complex(file, "excitation_force", "Excitation force", excitation,
              std::string("sum of the two; ") + kForceUnits);
  add_complex(file, "RAO", "Response amplitude operator", response,
              "of the elastic plate, also in Heave, Roll and Pitch: m/m, rad/m, kg^(1/2) m/m");

  add_matrix(file, "inertia_matrix", "Inertia matrix", results.dofs.inertia, kMatrixUnits);
  add_matrix(
      file, "hydrostatic_stiffness", "Hydrostatic stiffness", results.hydrostatic_stiffness,
      "rho g times the integral of w_i w_j over the plate (no draft, centre of mass at z = 0)");
  add_matrix(file, "structural_stiffness", "Structural stiffness", results.structural_stiffness,
             "squared dry natural frequencies of the elastic modes");
  add_matrix(file, "structural_damping", "Structural damping",
             results.loss_factor * results.structural_stiffness,
             "hysteretic: loss factor times structural_stiffness, in the equation of motion "
             "structural_stiffness - i structural_damping at every frequency");
}

void add_solver(NetcdfFile& file, const BodyResults& results) {
  add_count(file, results, "solver_iterations",
            [](const BodyFrequency& f) { return f.report.iterations; });
  describe(file, "solver_iterations", "Iterations of the solver, 0 for a direct one");
  add_series(file, results, "solver_residual",
             [](const BodyFrequency& f) { return f.report.true_residual; });
  describe(file, "solver_residual", "Largest relative residual of all right-hand sides", "1");
  add_series(file, results, "kernel_error",
             [](const BodyFrequency& f) { return f.report.kernel_error; });
  describe(file, "kernel_error", "Relative error of the Green function, sampled", "1");
  add_series(file, results, "reciprocity_error",
             [](const BodyFrequency& f) { return f.report.reciprocity_error; });
  describe(file, "reciprocity_error", "Asymmetry of the hydrodynamic matrix, relative", "1");
  add_series(file, results, "energy_error",
             [](const BodyFrequency& f) { return f.report.energy_error; });
  describe(file, "energy_error", "Damping against radiated energy, relative", "1");
  add_count(file, results, "status",
            [](const BodyFrequency& f) { return f.report.failure.empty() ? 0 : 1; });
  describe(file, "status", "Status", "", "0: solved, 1: not solved, its values are NaN");
}

}  // namespace floe::io
