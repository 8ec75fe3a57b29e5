#include "io/body_results.hpp"

#include <floe/hydro/surface_integrals.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>

namespace floe::io {
namespace {

// C of all modes: what the water gives back where the plate sinks
MatXd modal_hydrostatics(const StoredRun& run, const plate::DryModes& modes) {
  const mesh::Q8Mesh fluid = run.fluid_mesh();
  const bool own_mesh = modes.shape.rows() != plate::kUnknownsPerNode * fluid.node_count();
  const MatXd shape =
      own_mesh ? plate::interpolate_modes(modes, run.mode_mesh(), fluid).shape : modes.shape;
  const MatXd deflection = shape(Eigen::seq(0, Eigen::last, plate::kUnknownsPerNode), Eigen::all);
  const double weight = run.data().water.density * run.data().water.gravity;
  return weight * (deflection.transpose() * (hydro::surface_mass(fluid) * deflection));
}

BodyFrequency in_dofs(const plate::BodyDofs& dofs, const FrequencyResult& result) {
  const auto congruent = [&](const MatXd& matrix) -> MatXd {
    return dofs.motion.transpose() * matrix * dofs.motion;
  };
  const MatXcd motion = dofs.motion.cast<Complex>(), amplitude = dofs.amplitude.cast<Complex>();
  return {.omega = result.omega,
          .wavenumber = result.wavenumber,
          .added_mass = congruent(result.added_mass),
          .damping = congruent(result.damping),
          .froude_krylov = motion.transpose() * result.froude_krylov_force,
          .diffraction = motion.transpose() * (result.exciting_force - result.froude_krylov_force),
          .response = amplitude * result.amplitudes,
          .report = result.report};
}

}  // namespace

std::vector<std::string> BodyResults::dof_names() const {
  std::vector<std::string> names;
  for (const plate::BodyDof& dof : dofs.dof) {
    const bool alone = dofs.body.size() == 1 || dof.body < 0;
    names.push_back((alone ? "" : dofs.body[static_cast<std::size_t>(dof.body)] + "__") + dof.name);
  }
  return names;
}

std::string BodyResults::body_name() const {
  std::string joined;
  for (const std::string& name : dofs.body) joined += (joined.empty() ? "" : "+") + name;
  return joined;
}

BodyResults body_results(const StoredRun& run, plate::DofSet set, Unsolved unsolved) {
  const plate::DryModes modes = run.modes();
  BodyResults results;
  results.dofs = plate::body_dofs(run.mode_mesh(), modes, set);
  results.heading_deg = run.data().heading_deg;
  results.loss_factor = run.data().plate.loss_factor;
  results.structural_stiffness = results.dofs.stiffness.asDiagonal();
  results.hydrostatic_stiffness =
      results.dofs.motion.transpose() * modal_hydrostatics(run, modes) * results.dofs.motion;
  for (std::size_t i = 0; i < run.data().omega.size(); ++i)
    if (unsolved == Unsolved::kAsNan || run.has_frequency(i))
      if (const auto tried = run.tried_frequency(i, modes.count()))
        results.frequencies.push_back(in_dofs(results.dofs, *tried));
  FLOE_VALIDATE_AS(StoreError, !results.frequencies.empty(),
                   run.directory().string() << " holds no finished frequency");
  return results;
}

}  // namespace floe::io
