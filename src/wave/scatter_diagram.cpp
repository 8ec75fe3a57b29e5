#include <floe/numeric/error.hpp>
#include <floe/wave/scatter_diagram.hpp>

#include <cmath>
#include <numbers>

namespace floe::wave {
namespace {

void require_ascending(const std::vector<double>& values, const char* what, const char* unit) {
  FLOE_VALIDATE(!values.empty(), "invalid scatter diagram: no " << what);
  for (std::size_t i = 0; i < values.size(); ++i)
    FLOE_VALIDATE(std::isfinite(values[i]) && values[i] > (i > 0 ? values[i - 1] : 0.0),
                  "invalid scatter diagram: " << what << " = " << values[i] << " " << unit
                                              << " (must be positive and ascend)");
}

}  // namespace

ScatterDiagram scatter_diagram(std::vector<double> height, std::vector<double> period,
                               PeriodType type, const MatXd& counts) {
  require_ascending(height, "height", "m");
  require_ascending(period, "period", "s");
  FLOE_VALIDATE(counts.rows() == static_cast<Index>(height.size()) &&
                    counts.cols() == static_cast<Index>(period.size()),
                "invalid scatter diagram: " << counts.rows() << " × " << counts.cols()
                                            << " counts (must be heights × periods, "
                                            << height.size() << " × " << period.size() << ")");
  FLOE_VALIDATE(counts.allFinite() && counts.minCoeff() >= 0.0,
                "invalid scatter diagram: a count is negative or not finite");
  const double sum = counts.sum();
  FLOE_VALIDATE(sum > 0.0 && std::isfinite(sum),
                "invalid scatter diagram: the counts add up to " << sum << " (must be positive)");
  return {std::move(height), std::move(period), type, counts / sum};
}

double peak_period(PeriodType type, double period, double gamma) {
  if (type == PeriodType::kPeak) return period;
  const double turn = 2.0 * std::numbers::pi;
  const Spectrum unit = Spectrum::jonswap(4.0, turn, gamma);  // ωp = 1 rad/s
  const double ratio = type == PeriodType::kZeroCrossing
                           ? std::sqrt(unit.m0() / unit.moment(2))
                           : unit.moment(-1) / unit.m0();  // T/Tp, since Tp = 2π
  return period / ratio;
}

double WaveClimate::peak_period(std::size_t period) const {
  return wave::peak_period(scatter.period_type, scatter.period[period], gamma);
}

Spectrum WaveClimate::spectrum(std::size_t period) const {
  return Spectrum::jonswap(1.0, peak_period(period), gamma);
}

double WaveClimate::energy(std::size_t period) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < scatter.height.size(); ++i)
    sum += scatter.probability(static_cast<Index>(i), static_cast<Index>(period)) *
           std::pow(scatter.height[i], 2) / 16.0;
  return sum;
}

}  // namespace floe::wave
