#pragma once

#include <floe/response/pseudo_excitation.hpp>
#include <floe/wave/sea_state.hpp>

#include <vector>

namespace floe::response {

/// From where the waves of a partition come, and how much energy each heading stands for.
class WaveDirections {
 public:
  /// `mean_heading` of the sea [rad]; `circle` headings of the transfer functions. A measured
  /// partition has headings of its own: those of its table, and between them as many as the
  /// response needs.
  WaveDirections(const wave::Partition& partition, double mean_heading, int circle);

  /// √(S(ω, θ) Δθ) times what the waves of one metre do (rows × circle): rows × headings (E.8).
  MatXcd pseudo(double omega, const MatXcd& circle) const;
  /// ∑ S(ω, θ) Δθ [m² s/rad].
  double energy(double omega) const;
  /// What the headings make of ∫ D dθ = 1.
  double spreading_sum() const;

 private:
  std::vector<double> energies(double omega) const;

  wave::Partition partition_;
  DirectionGrid grid_;  // weights of a measured sea: Δθ
  MatXd from_table_;    // of a measured sea: headings × directions of the table
  CircleInterpolation at_headings_;
};

}  // namespace floe::response
