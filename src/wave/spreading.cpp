#include <floe/numeric/error.hpp>
#include <floe/wave/spreading.hpp>

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <numbers>

namespace floe::wave {
namespace {

constexpr double kPi = std::numbers::pi;

void require(bool good, const char* what, double value, const char* required) {
  FLOE_VALIDATE(good, "invalid " << what << " = " << value << " (" << required << ")");
}

}  // namespace

Spreading Spreading::cosine_power(double n) {
  require(n >= 1.0 && n <= 1000.0, "n", n, "must be 1 to 1000");
  const double ratio = boost::math::tgamma_ratio(0.5 * n + 1.0, 0.5 * (n + 1.0));
  return {Kind::kCosinePower, n, ratio / std::sqrt(kPi)};
}

Spreading Spreading::half_angle_cosine(double s) {
  require(s >= 0.5 && s <= 1000.0, "s", s, "must be 0.5 to 1000");
  const double ratio = boost::math::tgamma_ratio(s + 1.0, s + 0.5);
  return {Kind::kHalfAngleCosine, s, 0.5 * ratio / std::sqrt(kPi)};
}

Spreading Spreading::wrapped_normal(double deviation) {
  require(deviation > 0.0 && deviation <= 2.0 * kPi, "deviation", deviation,
          "must be greater than 0 and at most 2π rad");
  return {Kind::kWrappedNormal, deviation, 1.0 / (deviation * std::sqrt(2.0 * kPi))};
}

Spreading Spreading::none() { return {Kind::kNone, 0.0, 0.0}; }

double Spreading::operator()(double angle) const {
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  switch (kind_) {
    case Kind::kCosinePower:
      return std::abs(wrapped) < 0.5 * kPi ? factor_ * std::pow(std::cos(wrapped), parameter_)
                                           : 0.0;
    case Kind::kHalfAngleCosine:
      return factor_ * std::pow(std::abs(std::cos(0.5 * wrapped)), 2.0 * parameter_);
    case Kind::kWrappedNormal: {
      double sum = 0.0;
      const int turns = 1 + static_cast<int>(std::ceil(1.5 * parameter_));
      for (int turn = -turns; turn <= turns; ++turn)
        sum += std::exp(-0.5 * std::pow((wrapped + 2.0 * kPi * turn) / parameter_, 2));
      return factor_ * sum;
    }
    case Kind::kNone:
      break;
  }
  return 0.0;
}

double Spreading::half_width() const {
  if (kind_ == Kind::kNone) return 0.0;
  return kind_ == Kind::kCosinePower ? 0.5 * kPi : kPi;
}

double Spreading::width() const {
  switch (kind_) {
    case Kind::kCosinePower:
      return 1.0 / std::sqrt(parameter_);
    case Kind::kHalfAngleCosine:
      return std::sqrt(2.0 / parameter_);
    case Kind::kWrappedNormal:
      return parameter_;
    case Kind::kNone:
      break;
  }
  return 2.0 * kPi;
}

}  // namespace floe::wave
