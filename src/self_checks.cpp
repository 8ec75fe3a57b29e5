#include <floe/self_checks.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace floe {
namespace {

constexpr const char* kResolutionName = "nodes a wavelength";

CheckStatus judge(double value, double limit) {
  if (value <= limit) return CheckStatus::kGood;
  return value <= 10.0 * limit ? CheckStatus::kAttention : CheckStatus::kBad;  // NaN is bad
}

// The worst value of one entry of the reports
SelfCheck worst(const std::string& name, double limit, const std::string& meaning,
                const std::vector<FrequencyReport>& reports, double FrequencyReport::*entry) {
  SelfCheck check{.name = name, .limit = limit, .meaning = meaning};
  for (const FrequencyReport& report : reports) {
    const double value = report.*entry;
    if (value <= check.value) continue;
    check.value = value;
    check.omega = report.omega;
    if (std::isnan(value)) break;
  }
  check.status = judge(check.value, limit);
  return check;
}

SelfCheck of_plate(const std::string& name, double value, double limit,
                   const std::string& meaning) {
  return {.name = name,
          .value = value,
          .limit = limit,
          .status = judge(value, limit),
          .meaning = meaning};
}

SelfCheck fewest_nodes(const std::vector<Resolution>& resolution) {
  SelfCheck check{.name = kResolutionName,
                  .value = std::numeric_limits<double>::infinity(),
                  .limit = kNodesWanted,
                  .meaning =
                      "how well the mesh follows the shorter of the water's and the plate's "
                      "waves; with fewer, refine the mesh"};
  for (const Resolution& r : resolution)
    if (r.least_nodes() < check.value) {
      check.value = r.least_nodes();
      check.omega = r.omega;
    }
  check.status = check.value >= kNodesWanted     ? CheckStatus::kGood
                 : check.value >= kNodesRequired ? CheckStatus::kAttention
                                                 : CheckStatus::kBad;
  return check;
}

std::vector<FrequencyReport> all_solved(const std::vector<FrequencyReport>& waves,
                                        const std::vector<SolvedSeaFrequency>& seas) {
  std::vector<FrequencyReport> reports;
  std::copy_if(waves.begin(), waves.end(), std::back_inserter(reports),
               [](const FrequencyReport& report) { return report.failure.empty(); });
  double largest = 0.0;
  for (const SolvedSeaFrequency& one : seas) largest = std::max(largest, one.response);
  for (const SolvedSeaFrequency& one : seas) {
    const double share = largest > 0.0 ? one.response / largest : 1.0;
    reports.push_back(one.report);
    for (double FrequencyReport::*cost :
         {&FrequencyReport::reciprocity_error, &FrequencyReport::energy_error,
          &FrequencyReport::mode_change, &FrequencyReport::passivity_error})
      reports.back().*cost *= share;
  }
  return reports;
}

// The direct route has no modes
void add_modal_checks(const Case& data, const plate::DryModes& modes,
                      const std::vector<FrequencyReport>& reports, std::vector<SelfCheck>& checks) {
  checks.push_back(
      worst("positive damping", kPassivityLimit,
            "largest negative damping over the largest damping; motion must lose energy; a finer "
            "mesh lowers it",
            reports, &FrequencyReport::passivity_error));
  checks.push_back(worst("enough modes", kModeChangeLimit,
                         "change of the deflection when the highest quarter of the elastic modes "
                         "is left out; if it is large, raise modes.count or give solver.route = "
                         "\"direct\"",
                         reports, &FrequencyReport::mode_change));
  checks.push_back(of_plate("orthonormal modes", modes.orthonormality_error,
                            data.structure ? kGivenLimit : kOrthonormalityLimit,
                            "modal mass against what it should be; if it fails, ask for fewer "
                            "modes"));
  checks.push_back(of_plate("rigid modes", modes.rigid_force_error,
                            data.structure ? kGivenLimit : kRigidLimit,
                            "elastic force that a rigid motion meets; if it fails, the mesh lies "
                            "too far from the origin or is distorted"));
}

}  // namespace

const char* status_name(CheckStatus status) {
  return status == CheckStatus::kGood        ? "good"
         : status == CheckStatus::kAttention ? "attention"
                                             : "bad";
}

std::vector<std::string> warnings_of(const std::vector<SelfCheck>& checks) {
  std::vector<std::string> warnings;
  for (const SelfCheck& check : checks) {
    if (check.status == CheckStatus::kGood || check.name == kResolutionName) continue;
    const std::string where =
        check.omega > 0.0 ? fmt::format(" at omega = {:.4g} rad/s", check.omega) : "";
    warnings.push_back(fmt::format("self-check, {} = {:.2g}{} (good up to {:g}): {}", check.name,
                                   check.value, where, check.limit, check.meaning));
  }
  return warnings;
}

double exact_residual_limit(double tolerance) {
  constexpr double kLeastSumTolerance = 1e-7, kIntegralTolerance = 1e-8;
  return 1.001 * tolerance + 2.0 * (std::max(tolerance, kLeastSumTolerance) + kIntegralTolerance);
}

std::vector<SelfCheck> self_checks(const Case& data, const std::vector<Resolution>& resolution,
                                   const plate::DryModes& modes,
                                   const std::vector<FrequencyReport>& waves,
                                   const std::vector<SolvedSeaFrequency>& seas) {
  const std::vector<FrequencyReport> reports = all_solved(waves, seas);
  if (reports.empty()) return {};
  using Report = FrequencyReport;
  const bool modal = data.route == SolverRoute::kModal;
  std::vector<SelfCheck> checks = {
      worst("residual", 1.001 * data.tolerance,
            "how well the fluid's equation is solved, recomputed after the solution; if it "
            "fails, give solver.method = \"dense\"",
            reports, &Report::true_residual),
      worst("exact residual", exact_residual_limit(data.tolerance),
            "the same by the exact operator on 50 rows; if it fails, lower solver.tolerance or "
            "give solver.method = \"dense\"",
            reports, &Report::exact_residual),
      worst("Green function", kKernelLimit,
            "error of the table against the exact function, sampled; if it fails, do not trust "
            "the results and report the case",
            reports, &Report::kernel_error)};
  if (modal || data.heading_deg.size() > 1)  // one wave alone has nothing to be compared with
    checks.push_back(
        worst("reciprocity", kIdentityLimit,
              modal ? "asymmetry of the fluid matrix, zero for the exact solution; a finer mesh "
                      "lowers it"
                    : "what one heading's pressure does on another's wave, against the reverse; a "
                      "finer mesh lowers it",
              reports, &Report::reciprocity_error));
  checks.push_back(
      worst("energy", kIdentityLimit,
            modal ? "damping against the energy that the waves carry away; a finer mesh lowers it"
                  : "power that the waves bring, against what they take away and the plate loses; "
                    "a finer mesh lowers it",
            reports, &Report::energy_error));
  if (modal) add_modal_checks(data, modes, reports, checks);
  checks.push_back(fewest_nodes(resolution));
  return checks;
}

}  // namespace floe
