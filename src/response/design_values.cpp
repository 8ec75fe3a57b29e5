#include <floe/numeric/error.hpp>
#include <floe/response/design_values.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floe::response {

DesignValues design_values(double m0, double m2, double duration) {
  FLOE_VALIDATE(std::isfinite(m0) && m0 >= 0.0 && std::isfinite(m2) && m2 >= 0.0,
                "invalid moments m0 = " << m0 << ", m2 = " << m2 << " (must be at least 0)");
  FLOE_VALIDATE(std::isfinite(duration) && duration > 0.0,
                "invalid duration = " << duration << " s (must be positive)");
  DesignValues values;
  values.standard_deviation = std::sqrt(m0);
  values.zero_crossing_period = m2 > 0.0 ? 2.0 * std::numbers::pi * std::sqrt(m0 / m2)
                                         : std::numeric_limits<double>::infinity();
  values.significant = 2.0 * values.standard_deviation;
  const double crossings = std::max(1.0, duration / values.zero_crossing_period);
  values.most_probable_maximum = std::sqrt(2.0 * m0 * std::log(crossings));
  return values;
}

double exceedance(double level, double m0) {
  if (level <= 0.0) return 1.0;
  return m0 > 0.0 ? std::exp(-0.5 * level * level / m0) : 0.0;
}

}  // namespace floe::response
