#include "bem/near_matrix.hpp"
#include "bem/singular_functions.hpp"
#include "bem/source_choice.hpp"
#include "bem/source_rule.hpp"

#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/multipole_sum.hpp>
#include <floe/fmm/pfft_sum.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

namespace floe::bem {
namespace {

constexpr Index kColumns = 8;              // that go through the sum together
constexpr double kFloatTolerance = 3e-7;   // from here on near values are stored in float
constexpr Index kLeafPoints[] = {18, 36};  // of a multipole leaf, sources at nodes or not

const FastOptions& validated(const FastOptions& options) {
  const double least = options.engine == SumEngine::kMultipole ? 1e-9 : 1e-7;
  FLOE_VALIDATE(
      options.tolerance >= least && options.tolerance <= 1e-2,
      "invalid operator tolerance = " << options.tolerance << " (must be " << least << " to 1e-2)");
  return options;
}

}  // namespace

struct FastPressurePlan::Parts {
  Parts(const mesh::Q8Mesh& mesh_in, const FastOptions& options);

  const mesh::Q8Mesh& mesh;  // view
  SourceChoice choice;
  SourceRule rule;
  ElementIntegrals integrals;
  std::shared_ptr<const fmm::PfftPlan> pfft;
  std::shared_ptr<const fmm::MultipolePlan> multipole;
  std::optional<NearPattern> pattern;
  std::optional<NearMoments> moments;
};

FastPressurePlan::Parts::Parts(const mesh::Q8Mesh& mesh_in, const FastOptions& options)
    : mesh(mesh_in),
      choice(choose_sources(mesh_in, options.tolerance, options.max_wavenumber)),
      rule(mesh_in, choice.points),
      integrals(mesh_in, {.tolerance = std::clamp(0.1 * options.tolerance, 1e-12, 1e-5)}) {
  if (options.engine == SumEngine::kPfft)
    pfft = std::make_shared<const fmm::PfftPlan>(
        rule.points(), mesh.nodes(),
        fmm::PfftOptions{.tolerance = options.tolerance,
                         .max_wavenumber = options.max_wavenumber,
                         .memory_budget = options.memory_budget});
  if (options.engine == SumEngine::kMultipole)
    multipole = std::make_shared<const fmm::MultipolePlan>(
        rule.points(), mesh.nodes(),
        fmm::MultipoleOptions{.leaf_size = kLeafPoints[rule.at_nodes() ? 0 : 1]});
  pattern.emplace(mesh, choice.near_radius);
  moments.emplace(*pattern, integrals, rule, options.tolerance, options.max_wavenumber,
                  options.tolerance >= kFloatTolerance);
}

FastPressurePlan::FastPressurePlan(const mesh::Q8Mesh& mesh, const FastOptions& options)
    : options_(validated(options)), parts_(std::make_unique<const Parts>(mesh, options)) {}

FastPressurePlan::~FastPressurePlan() = default;

const mesh::Q8Mesh& FastPressurePlan::mesh() const { return parts_->mesh; }

double FastPressurePlan::reach() const {
  const double size = (parts_->mesh.upper() - parts_->mesh.lower()).norm();
  if (parts_->pfft) return std::max(size, parts_->pfft->max_distance());
  if (parts_->multipole) return std::max(size, parts_->multipole->reach());
  return size;
}

double FastPressurePlan::memory() const {
  double bytes = parts_->rule.memory() + parts_->pattern->memory() + parts_->moments->memory() +
                 1200.0 * static_cast<double>(parts_->mesh.element_count());
  if (parts_->pfft) bytes += parts_->pfft->memory();
  if (parts_->multipole) bytes += parts_->multipole->memory();
  return bytes;
}

struct FastPressureOperator::State {
  double kappa;
  Complex coincident;  // G that stands for a source point at the target
  std::unique_ptr<const fmm::KernelSum> sum;
  std::variant<std::monostate, NearMatrix<float>, NearMatrix<double>> near;
};

FastPressureOperator::FastPressureOperator(std::shared_ptr<const FastPressurePlan> plan,
                                           const green::GreenTable& green)
    : plan_(std::move(plan)) {
  const FastPressurePlan::Parts& parts = *plan_->parts_;
  const FastOptions& options = plan_->options();
  const double k = green.exact().wavenumber();
  FLOE_VALIDATE(k <= 1.000001 * options.max_wavenumber,
                "invalid wavenumber = " << k << " (must be at most " << options.max_wavenumber
                                        << " rad/m, for which the operator was planned)");
  auto state = std::make_unique<State>();
  state->kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  state->coincident = SingularFunctions::rest_at_zero(green.exact());
  if (parts.pfft)
    state->sum = std::make_unique<fmm::PfftSum>(parts.pfft, green);
  else if (parts.multipole)
    state->sum = std::make_unique<fmm::MultipoleSum>(parts.multipole, green, options.tolerance);
  else
    state->sum = std::make_unique<fmm::DirectSum>(parts.rule.points(), parts.mesh.nodes(), green);
  const NearSetup setup{*parts.pattern, *parts.moments, parts.integrals, parts.rule, green};
  if (options.tolerance >= kFloatTolerance)
    state->near.emplace<NearMatrix<float>>(setup, options.tolerance);
  else
    state->near.emplace<NearMatrix<double>>(setup, options.tolerance);
  state_ = std::move(state);
}

FastPressureOperator::~FastPressureOperator() = default;

Index FastPressureOperator::size() const { return plan_->mesh().node_count(); }

void FastPressureOperator::apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const {
  FLOE_EXPECT(x.rows() == size() && y.rows() == size() && x.cols() == y.cols());
  const FastPressurePlan::Parts& parts = *plan_->parts_;
  MatXcd charges(parts.rule.points().cols(), std::min(kColumns, x.cols()));
  for (Index first = 0; first < x.cols(); first += kColumns) {
    const Index count = std::min(kColumns, x.cols() - first);
    const auto part = x.middleCols(first, count);
    auto result = y.middleCols(first, count);
    parts.rule.spread(part, charges.leftCols(count));
    state_->sum->apply(charges.leftCols(count), result);
    if (parts.rule.at_nodes()) result += state_->coincident * charges.leftCols(count);
    result = part + state_->kappa * result;
    if (const auto* near = std::get_if<NearMatrix<float>>(&state_->near))
      near->multiply_add(*parts.pattern, part, state_->kappa, result);
    if (const auto* near = std::get_if<NearMatrix<double>>(&state_->near))
      near->multiply_add(*parts.pattern, part, state_->kappa, result);
  }
}

double FastPressureOperator::memory() const {
  double bytes = state_->sum->memory();
  if (const auto* near = std::get_if<NearMatrix<float>>(&state_->near)) bytes += near->memory();
  if (const auto* near = std::get_if<NearMatrix<double>>(&state_->near)) bytes += near->memory();
  return bytes;
}

}  // namespace floe::bem
