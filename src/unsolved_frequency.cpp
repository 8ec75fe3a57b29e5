#include <floe/unsolved_frequency.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <limits>

namespace floe {

FrequencyResult unsolved_frequency(const Case& data, Index mode_count, double omega,
                                   std::string failure) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto headings = static_cast<Index>(data.heading_deg.size());
  const auto points = static_cast<Index>(data.points.size());
  const auto unknown = [&](Index rows) {
    return MatXcd::Constant(rows, headings, Complex(kNone, kNone));
  };
  Index stations = 0;
  for (const NamedLine& line : data.lines) stations += line.count;

  FrequencyResult result;
  result.omega = omega;
  result.wavenumber = wave::wavenumber(omega, data.water);
  result.added_mass = MatXd::Constant(mode_count, mode_count, kNone);
  result.damping = result.added_mass;
  result.exciting_force = unknown(mode_count);
  result.froude_krylov_force = unknown(mode_count);
  result.amplitudes = unknown(mode_count);
  result.line_deflection = unknown(stations);
  result.point_deflection = unknown(points);
  result.point_quantities.assign(data.quantities.size(), unknown(points));
  result.wave_elevation = unknown(static_cast<Index>(data.wave_points.size()));

  FrequencyReport& report = result.report;
  report.omega = omega;
  report.failure = std::move(failure);
  for (double FrequencyReport::*measure :
       {&FrequencyReport::true_residual, &FrequencyReport::kernel_error,
        &FrequencyReport::reciprocity_error, &FrequencyReport::energy_error,
        &FrequencyReport::exact_residual, &FrequencyReport::residual_between_nodes,
        &FrequencyReport::mode_change, &FrequencyReport::passivity_error})
    report.*measure = kNone;
  return result;
}

std::string describe_unsolved(const std::vector<FrequencyReport>& reports) {
  constexpr int kTold = 10;
  std::string first, others;
  int count = 0;
  for (const FrequencyReport& report : reports) {
    if (report.failure.empty()) continue;
    if (++count == 1)
      first = report.failure;
    else if (count <= kTold)
      others += fmt::format("{}{}", count == 2 ? "; no result either at " : ", ", report.omega);
  }
  if (count == 0) return "";
  if (count > kTold) others += ", …";
  if (count > 1) others += " rad/s";
  return fmt::format("{} of {} {} no result: {}{}", count, reports.size(),
                     count == 1 ? "frequencies has" : "frequencies have", first, others);
}

}  // namespace floe
