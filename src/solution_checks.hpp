#pragma once

#include "analysis_stages.hpp"

namespace floe {

/// Fills in what the solution of the modes' radiation problems is worth: residuals, error of the
/// Green function, reciprocity, energy, positive damping. `pressure` is that of `radiation`, whose
/// own is not looked at, N × q; the report tells the frequency.
void judge_radiation(const Case& data, const FluidModel& fluid, const green::GreenTable& green,
                     const hydro::Radiation& radiation, const Eigen::Ref<const MatXcd>& pressure,
                     FrequencyReport& report);

/// What the highest modes change at some of the nodes, FrequencyReport::mode_change.
double change_by_modes(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                       double omega, const MatXcd& fluid_matrix, const MatXcd& exciting_force,
                       const MatXcd& amplitudes);

}  // namespace floe
