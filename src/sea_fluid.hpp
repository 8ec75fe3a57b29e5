#pragma once

#include "analysis_stages.hpp"
#include "fluid_march.hpp"

#include <algorithm>

namespace floe {

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
  /// Holds the pressures at the points against a diffraction problem of one heading.
  FluidSample solve(double omega);

  /// States of the waves from equidistant headings on the full circle, state × headings: of waves
  /// of one metre, or of an amplitude that is given at the fluid's nodes.
  MatXcd states(const FluidSample& sample, int headings, const VecXd& amplitude = {}) const;

  /// Largest difference of a pressure at a point, by reciprocity, from that of the diffraction
  /// problem, relative to the largest at the points; 0 where none is asked for.
  double pressure_error() const { return pressure_error_; }
  /// Counts in what an earlier run found.
  void remember_pressure_error(double error) { pressure_error_ = std::max(pressure_error_, error); }

 private:
  void add_point_pressures(const bem::PressureOperator& pressure_operator,
                           const green::GreenTable& green, FluidSample& sample) const;

  const Case& data_;  // view, as the next two
  const PlateModel& plate_;
  const FluidModel& fluid_;
  plate::StaticCorrection::Influence influence_;
  Points2 points_;  // where pressures are wanted
  Index modes_, section_forces_, pressures_;
  double pressure_error_ = 0.0;
};

}  // namespace floe
