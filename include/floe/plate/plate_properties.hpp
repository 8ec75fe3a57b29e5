#pragma once

namespace floe::plate {

/// Isotropic Mindlin plate of uniform thickness. SI units.
struct PlateProperties {
  double thickness = 0.0;               ///< [m]
  double youngs_modulus = 0.0;          ///< E [N/m²]
  double poisson_ratio = 0.0;           ///< [-]
  double density = 0.0;                 ///< [kg/m³]
  double shear_correction = 5.0 / 6.0;  ///< [-]
  double loss_factor = 0.0;             ///< η of E(1 - iη) [-]

  /// D = E t³ / 12(1 - ν²) [N m].
  double bending_rigidity() const {
    return youngs_modulus * thickness * thickness * thickness /
           (12.0 * (1.0 - poisson_ratio * poisson_ratio));
  }
  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson_ratio)); }
  /// Mass per area [kg/m²].
  double surface_mass() const { return density * thickness; }
};

}  // namespace floe::plate
