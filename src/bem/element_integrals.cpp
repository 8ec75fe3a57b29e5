#include "bem/far_rules.hpp"
#include "bem/near_rules.hpp"
#include "bem/quadrature_points.hpp"
#include "bem/singular_functions.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/numeric/error.hpp>

#include <array>

namespace floe::bem {
namespace {

constexpr int kBatchPoints = 512;  // distances evaluated at once: 12 kB, stays in the L1 cache

// What is integrated against the shape functions: kValues complex numbers a distance
struct GreenKernel {
  static constexpr int kValues = 1;
  const green::GreenTable& green;

  void evaluate(std::span<const double> distance, Complex* value) const {
    green.evaluate(distance, {value, distance.size()});
  }
  double wavenumber() const { return green.exact().wavenumber(); }
  double smallest_scale() const { return std::min(green.exact().depth(), 1.0 / wavenumber()); }
};

struct SingularKernel {
  static constexpr int kValues = SingularFunctions::kCount / 2;

  void evaluate(std::span<const double> distance, Complex* value) const {
    SingularFunctions::evaluate(distance, value);
  }
  double wavenumber() const { return 0.0; }
  double smallest_scale() const { return std::numeric_limits<double>::infinity(); }
};

template <class Kernel>
using Sums = std::array<Complex, 8 * Kernel::kValues>;

// Far elements of one tier that wait for their kernel values
template <class Kernel>
class Batch {
 public:
  Batch(const Point2& target, const Kernel& kernel, const FarRules& rules, int tier)
      : target_(target), kernel_(kernel), rules_(rules), tier_(tier) {}

  // `slot` is what `sink` is told with the sum
  void add(Index slot, Index element) {
    const int at = count_ * FarRules::size(tier_);
    rules_.fill_points(tier_, element, x_.data() + at, y_.data() + at, area_.data() + at);
    slots_[count_++] = slot;
  }
  bool full() const { return (count_ + 1) * FarRules::size(tier_) > kBatchPoints; }

  // Calls sink(slot, sum) for each element collected
  template <class Sink>
  void flush(const Sink& sink) {
    const std::size_t size = FarRules::size(tier_), points = count_ * size;
    fill_distances(target_, x_.data(), y_.data(), points, distance_.data());
    auto* const value = reinterpret_cast<Complex*>(numbers_.data());
    kernel_.evaluate({distance_.data(), points}, value);
    for (int plane = 0; plane < Kernel::kValues; ++plane)
      scale_values(area_.data(), points, value + plane * points);
    for (int i = 0; i < count_; ++i) {
      Sums<Kernel> sum;
      for (int plane = 0; plane < Kernel::kValues; ++plane)
        sum_weighted(rules_.shape(tier_), value + plane * points + i * size, size,
                     sum.data() + 8 * plane);
      sink(slots_[i], sum);
    }
    count_ = 0;
  }

 private:
  const Point2& target_;
  const Kernel& kernel_;
  const FarRules& rules_;
  int tier_;
  int count_ = 0;
  std::array<Index, kBatchPoints> slots_;
  std::array<double, kBatchPoints> x_, y_, area_, distance_;
  std::array<double, 2 * Kernel::kValues * kBatchPoints> numbers_;  // re, im of values; not cleared
};

// What a target needs: the rules, and scratch
template <class Kernel>
class TargetIntegrals {
 public:
  TargetIntegrals(const mesh::Q8Mesh& mesh, const FarRules& rules, const Point2& target,
                  std::span<const mesh::ElementPoint> holders, const Kernel& kernel)
      : mesh_(mesh), rules_(rules), target_(target), holders_(holders), kernel_(kernel) {
    batches_.reserve(FarRules::kTiers);
    for (int tier = 0; tier < FarRules::kTiers; ++tier)
      batches_.emplace_back(target_, kernel_, rules_, tier);
  }

  // Integrates element(k) for k = 0 … count - 1 and calls sink(k, its eight integrals), in an order
  // that depends on the elements alone
  template <class ElementOf, class Sink>
  void integrate(Index count, const ElementOf& element_of, const Sink& sink) {
    for (Index k = 0; k < count; ++k) {
      const Index element = element_of(k);
      if (add_singular(element)) {
        sink(k, sum_points(element));
        continue;
      }
      const int tier = tier_for(element);
      if (tier == FarRules::kTooNear) {
        add_near_points(target_, mesh_.element_nodes(element), wavenumber_, rules_, points_);
        sink(k, sum_points(element));
        continue;
      }
      batches_[tier].add(k, element);
      if (batches_[tier].full()) batches_[tier].flush(sink);
    }
    for (Batch<Kernel>& batch : batches_) batch.flush(sink);
  }

 private:
  // Points of an element that holds the target
  bool add_singular(Index element) {
    for (const mesh::ElementPoint& holder : holders_)
      if (holder.element == element) {
        add_singular_points(mesh_.element_nodes(element), holder.xi, holder.eta,
                            kernel_.smallest_scale(), rules_.singular_order(), points_);
        return true;
      }
    return false;
  }

  int tier_for(Index element) const {
    const double half_edge = rules_.half_edge(element);
    double gap = (rules_.centre(element) - target_).norm() - rules_.radius(element);
    if (gap < 4.0 * half_edge) gap = distance_to_element(target_, mesh_.element_nodes(element));
    return std::max(rules_.tier_for_gap(gap, half_edge),
                    rules_.tier_for_wave(wavenumber_, half_edge));
  }

  Sums<Kernel> sum_points(Index element) {
    points_.map(mesh_.element_nodes(element));
    const std::size_t count = points_.count();
    distance_.resize(count);
    value_.resize(Kernel::kValues * count);
    fill_distances(target_, points_.x.data(), points_.y.data(), count, distance_.data());
    kernel_.evaluate(distance_, value_.data());
    Sums<Kernel> sum;
    for (int plane = 0; plane < Kernel::kValues; ++plane)
      points_.sum(value_.data() + plane * count, sum.data() + 8 * plane);
    points_.clear();
    return sum;
  }

  const mesh::Q8Mesh& mesh_;
  const FarRules& rules_;
  Point2 target_;
  std::span<const mesh::ElementPoint> holders_;
  const Kernel& kernel_;
  double wavenumber_ = kernel_.wavenumber();
  QuadraturePoints points_;
  std::vector<double> distance_;
  std::vector<Complex> value_;
  std::vector<Batch<Kernel>> batches_;
};

}  // namespace

ElementIntegrals::ElementIntegrals(const mesh::Q8Mesh& mesh, const IntegralOptions& options)
    : mesh_(mesh), locator_(mesh), node_elements_(mesh.node_count()) {
  FLOE_VALIDATE(options.tolerance >= 1e-12 && options.tolerance <= 1e-2,
                "invalid integral tolerance = " << options.tolerance << " (must be 1e-12 to 1e-2)");
  far_ = std::make_shared<const FarRules>(mesh, options.tolerance);
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (int a = 0; a < 8; ++a) node_elements_[mesh.elements()(a, e)].emplace_back(e, a);
}

std::vector<mesh::ElementPoint> ElementIntegrals::holders_of(Index node) const {
  std::vector<mesh::ElementPoint> holders;
  for (const auto& [element, local] : node_elements_[node])
    holders.push_back(
        {element, mesh::q8_parametric_nodes()(0, local), mesh::q8_parametric_nodes()(1, local)});
  return holders;
}

void ElementIntegrals::node_row(Index node, const green::GreenTable& green,
                                Eigen::Ref<VecXcd> row) const {
  fill_row(mesh_.nodes().col(node), holders_of(node), green, row);
}

void ElementIntegrals::node_elements(Index node, std::span<const Index> elements,
                                     const green::GreenTable& green,
                                     std::span<std::array<Complex, 8>> integrals) const {
  FLOE_EXPECT(elements.size() == integrals.size());
  const std::vector<mesh::ElementPoint> holders = holders_of(node);
  const GreenKernel kernel{green};
  TargetIntegrals target(mesh_, *far_, mesh_.nodes().col(node), holders, kernel);
  target.integrate(
      static_cast<Index>(elements.size()), [&](Index k) { return elements[k]; },
      [&](Index k, const std::array<Complex, 8>& sum) { integrals[k] = sum; });
}

void ElementIntegrals::node_singular_elements(Index node, std::span<const Index> elements,
                                              std::span<std::array<Complex, 16>> integrals) const {
  FLOE_EXPECT(elements.size() == integrals.size());
  const std::vector<mesh::ElementPoint> holders = holders_of(node);
  const SingularKernel kernel;
  TargetIntegrals target(mesh_, *far_, mesh_.nodes().col(node), holders, kernel);
  target.integrate(
      static_cast<Index>(elements.size()), [&](Index k) { return elements[k]; },
      [&](Index k, const std::array<Complex, 16>& sum) { integrals[k] = sum; });
}

void ElementIntegrals::point_row(const Point2& point, const green::GreenTable& green,
                                 Eigen::Ref<VecXcd> row) const {
  // NOTE: a point within the locator's tolerance outside an edge is moved onto it, or the elements
  // on either side of it would each see a nearly singular integral
  const std::vector<mesh::ElementPoint> holders = locator_.locate_all(point);
  Point2 target = point;
  if (!holders.empty())
    target =
        mesh_.element_nodes(holders[0].element) * mesh::q8_shape(holders[0].xi, holders[0].eta);
  fill_row(target, holders, green, row);
}

void ElementIntegrals::fill_row(const Point2& target, std::span<const mesh::ElementPoint> holders,
                                const green::GreenTable& green, Eigen::Ref<VecXcd> row) const {
  FLOE_EXPECT(row.size() == mesh_.node_count());
  row.setZero();
  const GreenKernel kernel{green};
  TargetIntegrals(mesh_, *far_, target, holders, kernel)
      .integrate(
          mesh_.element_count(), [](Index k) { return k; },
          [&](Index element, const std::array<Complex, 8>& sum) {
            for (int m = 0; m < 8; ++m) row[mesh_.elements()(m, element)] += sum[m];
          });
}

}  // namespace floe::bem
