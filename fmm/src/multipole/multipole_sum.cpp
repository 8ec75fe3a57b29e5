#include "multipole/engine.hpp"

#include <floe/fmm/multipole_sum.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>

namespace floe::fmm {
namespace multipole {
namespace {

// A power of two that brings the largest number of a column near 1: single precision has no room
// for charges of any size, and the division is exact
double scale_of(const Eigen::Ref<const VecXcd>& charges) {
  const double most =
      std::max(charges.real().cwiseAbs().maxCoeff(), charges.imag().cwiseAbs().maxCoeff());
  return most > 0.0 && std::isfinite(most) ? std::ldexp(1.0, std::ilogb(most)) : 1.0;
}

}  // namespace

template <class Real>
void TypedEngine<Real>::apply(const Eigen::Ref<const MatXcd>& charges,
                              Eigen::Ref<MatXcd> potentials, bool with_near) const {
  const Quadtree& tree = geometry_.tree;
  const Index columns = charges.cols(), sources = tree.sources.cols(),
              targets = tree.targets.cols();
  if (sources == 0 || targets == 0 || columns == 0) {
    potentials.setZero();
    return;
  }

  // Bring the charges into the tree's order
  Columns<Real> q(sources, columns), u(targets, columns);
  VecXd scale(columns);
#pragma omp parallel for schedule(static)
  for (Index column = 0; column < columns; ++column) {
    scale[column] = scale_of(charges.col(column));
    const double inverse = 1.0 / scale[column];
    for (Index i = 0; i < sources; ++i) {
      const Complex charge = charges(tree.source_order[i], column);
      q.real(column)[i] = static_cast<Real>(charge.real() * inverse);
      q.imag(column)[i] = static_cast<Real>(charge.imag() * inverse);
    }
  }

  Levels moments = make_levels(columns), locals = make_levels(columns);

  // Form leaf expansions (P2M)
  form_leaf_moments(q, moments);

  // Shift to parents (M2M)
  shift_to_parents(moments);

  // Translate across lists (M2L), and Im G over all pairs at the top
  translate_across_lists(moments, locals);
  couple_at_the_top(moments, locals);
  add_wide_sources(q, locals);

  // Shift to children (L2L)
  shift_to_children(locals);

  // Evaluate at targets (L2P)
  evaluate_at_targets(moments, locals, u);

  // Add neighbour boxes directly (P2P)
  if (with_near) {
#pragma omp parallel for schedule(dynamic, 16)
    for (Index group = 0; group < near_.groups(); ++group)
      near_.add(group, q.real(0), q.stride, columns, u.real(0), u.stride);

    // Coincident points do not act on each other: take their Im G out again
    const auto c = static_cast<Real>(kernel_.wave().coefficient.imag());
    for (Index column = 0; column < columns; ++column)
      for (const auto& [target, source] : geometry_.coincident) {
        u.real(column)[target] += c * q.imag(column)[source];
        u.imag(column)[target] -= c * q.real(column)[source];
      }
  }

  // Bring the potentials into the caller's order
#pragma omp parallel for schedule(static)
  for (Index column = 0; column < columns; ++column)
    for (Index i = 0; i < targets; ++i)
      potentials(tree.target_order[i], column) =
          scale[column] * Complex(u.real(column)[i], u.imag(column)[i]);
}

template class TypedEngine<float>;
template class TypedEngine<double>;

}  // namespace multipole

MultipolePlan::MultipolePlan(const Points2& sources, const Points2& targets,
                             const MultipoleOptions& options) {
  FLOE_VALIDATE(sources.allFinite() && targets.allFinite(),
                "invalid point coordinate = nan or inf (must be finite)");
  FLOE_VALIDATE(options.leaf_size > 0,
                "invalid leaf size = " << options.leaf_size << " (must be positive)");
  geometry_ = std::make_unique<multipole::Geometry>(sources, targets, options.leaf_size);
}

MultipolePlan::~MultipolePlan() = default;

Index MultipolePlan::source_count() const { return geometry_->tree.sources.cols(); }
Index MultipolePlan::target_count() const { return geometry_->tree.targets.cols(); }
double MultipolePlan::reach() const { return std::sqrt(2.0) * geometry_->tree.root_width; }
std::vector<Index> MultipolePlan::near_sources(Index target) const {
  return geometry_->near_sources(target);
}
double MultipolePlan::memory() const { return geometry_->memory(); }

MultipoleSum::MultipoleSum(std::shared_ptr<const MultipolePlan> plan, const RadialKernel& kernel,
                           double tolerance, NearSums near)
    : plan_(std::move(plan)), kernel_(kernel) {
  FLOE_VALIDATE(tolerance >= 1e-10 && tolerance < 1.0,
                "invalid tolerance = " << tolerance << " (must be in [1e-10, 1))");
  const Complex c = kernel.wave().coefficient;
  FLOE_VALIDATE(std::abs(c.real()) <= 1e-14 * std::abs(c.imag()),
                "invalid wave coefficient = " << c << " (must be imaginary)");
  engine_ = multipole::make_engine(plan_->geometry(), kernel, tolerance, near == NearSums::kStored);
}

MultipoleSum::~MultipoleSum() = default;

Index MultipoleSum::source_count() const { return plan_->source_count(); }
Index MultipoleSum::target_count() const { return plan_->target_count(); }
double MultipoleSum::memory() const { return engine_->memory(); }
std::vector<Index> MultipoleSum::ranks() const { return engine_->ranks(); }

void MultipoleSum::apply(const Eigen::Ref<const MatXcd>& charges,
                         Eigen::Ref<MatXcd> potentials) const {
  FLOE_EXPECT(charges.rows() == source_count() && potentials.rows() == target_count());
  engine_->apply(charges, potentials, true);
}

void MultipoleSum::far_apply(const Eigen::Ref<const MatXcd>& charges,
                             Eigen::Ref<MatXcd> potentials) const {
  FLOE_EXPECT(charges.rows() == source_count() && potentials.rows() == target_count());
  engine_->apply(charges, potentials, false);
}

std::vector<Index> MultipoleSum::near_sources(Index target) const {
  return plan_->near_sources(target);
}

void MultipoleSum::far_values(Index target, std::span<const Index> sources,
                              std::span<Complex> values) const {
  const multipole::Quadtree& tree = plan_->geometry().tree;
  const Point2 point = tree.targets.col(plan_->geometry().target_position[target]);
  std::vector<double> distance(sources.size());
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const Index j = plan_->geometry().source_position[sources[k]];
    distance[k] = (tree.sources.col(j) - point).norm();
  }
  std::vector<double> asked = distance;
  std::replace(asked.begin(), asked.end(), 0.0, tree.root_width);
  kernel_.evaluate(asked, values);
  for (std::size_t k = 0; k < sources.size(); ++k)
    values[k] =
        Complex(0.0, distance[k] > 0.0 ? values[k].imag() : kernel_.wave().coefficient.imag());
}

}  // namespace floe::fmm
