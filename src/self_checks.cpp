#include <floe/preflight.hpp>
#include <floe/self_checks.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace floe {
namespace {

CheckStatus judge(double value, double limit) {
  if (value <= limit) return CheckStatus::kGood;
  return value <= 10.0 * limit ? CheckStatus::kAttention : CheckStatus::kBad;  // NaN is bad
}

double negative_damping(const FrequencyResult& result) {
  if (!result.damping.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const MatXd symmetric = 0.5 * (result.damping + result.damping.transpose());
  const VecXd values =
      Eigen::SelfAdjointEigenSolver<MatXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  const double largest = values.cwiseAbs().maxCoeff();
  return largest > 0.0 ? std::max(0.0, -values.minCoeff()) / largest : 0.0;
}

// The worst value of `measure` over the frequencies
template <typename Measure>
SelfCheck worst(const std::string& name, double limit, const std::string& meaning,
                const std::vector<FrequencyResult>& results, const Measure& measure) {
  SelfCheck check{.name = name, .limit = limit, .meaning = meaning};
  for (const FrequencyResult& result : results) {
    const double value = measure(result);
    if (value <= check.value) continue;
    check.value = value;
    check.omega = result.omega;
    if (std::isnan(value)) break;
  }
  check.status = judge(check.value, limit);
  return check;
}

SelfCheck resolution(const Case& data, const mesh::Q8Mesh& mesh) {
  SelfCheck check{.name = "nodes a wavelength",
                  .value = std::numeric_limits<double>::infinity(),
                  .limit = kNodesWanted,
                  .meaning =
                      "how well the mesh follows the shorter of the water's and the plate's "
                      "waves; with fewer, refine the mesh"};
  for (const Resolution& r : preflight(data, mesh).resolution)
    if (r.least_nodes() < check.value) {
      check.value = r.least_nodes();
      check.omega = r.omega;
    }
  check.status = check.value >= kNodesWanted     ? CheckStatus::kGood
                 : check.value >= kNodesRequired ? CheckStatus::kAttention
                                                 : CheckStatus::kBad;
  return check;
}

}  // namespace

std::vector<SelfCheck> self_checks(const Case& data, const mesh::Q8Mesh& mesh,
                                   const std::vector<FrequencyResult>& results) {
  if (results.empty()) return {};
  const bool modal = data.route == SolverRoute::kModal;
  std::vector<SelfCheck> checks = {
      worst("residual", 1.001 * data.tolerance,
            "how well the fluid's equation is solved, recomputed after the solution", results,
            [](const FrequencyResult& r) { return r.report.true_residual; }),
      worst("Green function", kKernelLimit,
            "error of the table against the exact function, sampled", results,
            [](const FrequencyResult& r) { return r.report.kernel_error; })};
  if (modal || data.heading_deg.size() > 1)  // one wave alone has nothing to be compared with
    checks.push_back(
        worst("reciprocity", kIdentityLimit,
              modal ? "asymmetry of the fluid matrix, zero for the exact solution; a finer mesh "
                      "lowers it"
                    : "what one heading's pressure does on another's wave, against the reverse; a "
                      "finer mesh lowers it",
              results, [](const FrequencyResult& r) { return r.report.reciprocity_error; }));
  checks.push_back(
      worst("energy", kIdentityLimit,
            modal ? "damping against the energy that the waves carry away; a finer mesh lowers it"
                  : "power that the waves bring, against what they take away and the plate loses; "
                    "a finer mesh lowers it",
            results, [](const FrequencyResult& r) { return r.report.energy_error; }));
  if (modal)
    checks.push_back(
        worst("positive damping", kPassivityLimit,
              "largest negative damping over the largest damping; motion must lose energy", results,
              negative_damping));
  checks.push_back(resolution(data, mesh));
  return checks;
}

}  // namespace floe
