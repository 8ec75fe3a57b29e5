#pragma once

#include <string>

namespace floe::wave {

/// How the energy of a sea is spread over the directions around the mean heading: a density
/// D(θ - θ̄) [1/rad] with ∫ D dθ = 1 over the circle.
class Spreading {
 public:
  /// Γ(n/2+1)/(√π Γ((n+1)/2)) cosⁿ over ±90° (E.5); n = 2 is the paper's (25), (2/π) cos².
  static Spreading cosine_power(double n);
  /// Γ(s+1)/(2√π Γ(s+½)) cos²ˢ of half the angle, over the whole circle (E.6).
  static Spreading half_angle_cosine(double s);
  /// Gaussian of a standard deviation [rad], wrapped around the circle (E.7).
  static Spreading wrapped_normal(double deviation);
  /// All energy in the mean heading: long-crested.
  static Spreading none();

  /// D at an angle from the mean heading [rad]; meaningless for long crests.
  double operator()(double angle) const;
  /// D is zero beyond ± this [rad]: π/2, π, or 0 for long crests.
  double half_width() const;
  bool long_crested() const { return kind_ == Kind::kNone; }
  /// Angle that a grid must resolve [rad]: D changes little within a fifth of it.
  double width() const;

 private:
  enum class Kind { kCosinePower, kHalfAngleCosine, kWrappedNormal, kNone };
  Spreading(Kind kind, double parameter, double factor)
      : kind_(kind), parameter_(parameter), factor_(factor) {}
  Kind kind_;
  double parameter_;
  double factor_;
};

}  // namespace floe::wave
