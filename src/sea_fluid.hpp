#pragma once

#include "analysis_stages.hpp"
#include "fluid_march.hpp"

namespace floe {

/// Headings around the circle from which a response is looked at to compare two of them.
inline constexpr int kProbeHeadings = 24;

/// The waves of a sea's stage: what the fluid has to be solved for at a frequency, and what follows
/// from it for the waves of all directions. The state of a wave is, in this order, the amplitudes ξ
/// of the modes, what they leave out of every section force at every point (E.12), and the pressure
/// at every point (R.4) where one is asked for.
class SeaFluid {
 public:
  /// Keeps views of all three.
  SeaFluid(const Case& data, const PlateModel& plate, const FluidModel& fluid);

  Index state_size() const { return modes_ + section_forces_ + pressures_; }
  Index first_section_force() const { return modes_; }
  Index first_pressure() const { return modes_ + section_forces_; }

  /// Radiation of the modes and of the fields of (E.12), (R.4), which stand beside their pressures.
  /// Holds the modes' radiation against what it must satisfy, and the pressures at the points
  /// against a diffraction problem of one heading.
  FluidSample solve(double omega) const;

  /// States of the waves from equidistant headings on the full circle, state × headings: of waves
  /// of one metre, or of an amplitude that is given at the fluid's nodes.
  MatXcd states(const FluidSample& sample, int headings, const VecXd& amplitude = {}) const;

 private:
  void add_point_pressures(const bem::PressureOperator& pressure_operator,
                           const green::GreenTable& green, FluidSample& sample) const;
  void judge(const green::GreenTable& green, const hydro::Radiation& radiation,
             FluidSample& sample) const;

  const Case& data_;  // view, as the next two
  const PlateModel& plate_;
  const FluidModel& fluid_;
  plate::StaticCorrection::Influence influence_;
  Points2 points_;  // where pressures are wanted
  Index modes_, section_forces_, pressures_;
};

}  // namespace floe
