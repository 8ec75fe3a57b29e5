#pragma once

#include <floe/io/stored_run.hpp>
#include <floe/plate/body_dofs.hpp>

#include <string>
#include <vector>

namespace floe::io {

/// One frequency of a run in the degrees of freedom of other programs, per metre of wave, e^{-iωt}.
struct BodyFrequency {
  double omega = 0.0;       ///< [rad/s]
  double wavenumber = 0.0;  ///< [rad/m]
  MatXd added_mass;         ///< d × d
  MatXd damping;            ///< d × d
  MatXcd froude_krylov;     ///< d × headings
  MatXcd diffraction;       ///< d × headings; both together are the exciting force
  MatXcd response;          ///< d × headings
  FrequencyReport report;
};

/// A run told as motions of bodies: (-ω²(M + A) - iωB + C + K(1 - iη)) X = F.
struct BodyResults {
  plate::BodyDofs dofs;
  std::vector<double> heading_deg;  ///< towards which the waves travel
  std::vector<BodyFrequency> frequencies;
  MatXd hydrostatic_stiffness;  ///< C = ρg ∫ w_i w_j dS, d × d
  MatXd structural_stiffness;   ///< K, d × d
  double loss_factor = 0.0;     ///< η

  /// "Heave", or "plate_1__Heave" where there are several bodies.
  std::vector<std::string> dof_names() const;
  /// "plate", or "plate_1+plate_2+…".
  std::string body_name() const;
};

/// What becomes of frequencies that could not be solved.
enum class Unsolved {
  kLeftOut,  ///< for formats that know no NaN
  kAsNan     ///< report.failure tells why
};

BodyResults body_results(const StoredRun& run, plate::DofSet set,
                         Unsolved unsolved = Unsolved::kLeftOut);

}  // namespace floe::io
