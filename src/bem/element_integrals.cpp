#include "bem/far_rules.hpp"
#include "bem/near_rules.hpp"
#include "bem/quadrature_points.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/numeric/error.hpp>

#include <array>

namespace floe::bem {
namespace {

constexpr int kBatchPoints = 512;  // distances evaluated at once: 12 kB, stays in the L1 cache

// Far elements of one tier that wait for their kernel values
class Batch {
 public:
  Batch(const Point2& target, const green::GreenTable& green, const FarRules& rules, int tier)
      : target_(target), green_(green), rules_(rules), tier_(tier) {}

  void add(Index element) {
    elements_[count_++] = element;
    if ((count_ + 1) * FarRules::size(tier_) > kBatchPoints) full_ = true;
  }
  bool full() const { return full_; }

  // Evaluates and adds to the row what has been collected
  void flush(const mesh::Connectivity& connectivity, Eigen::Ref<VecXcd> row) {
    const std::size_t size = FarRules::size(tier_);
    for (int i = 0; i < count_; ++i)
      fill_distances(target_, rules_.x(tier_, elements_[i]), rules_.y(tier_, elements_[i]), size,
                     distance_.data() + i * size);
    green_.evaluate({distance_.data(), count_ * size}, {value_.data(), count_ * size});
    for (int i = 0; i < count_; ++i) {
      std::array<Complex, 8> sum;
      sum_weighted(rules_.weight(tier_, elements_[i]), value_.data() + i * size, size, sum.data());
      for (int m = 0; m < 8; ++m) row[connectivity(m, elements_[i])] += sum[m];
    }
    count_ = 0;
    full_ = false;
  }

 private:
  const Point2& target_;
  const green::GreenTable& green_;
  const FarRules& rules_;
  int tier_;
  int count_ = 0;
  bool full_ = false;
  std::array<Index, kBatchPoints> elements_;
  std::array<double, kBatchPoints> distance_;
  std::array<Complex, kBatchPoints> value_;
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

void ElementIntegrals::node_row(Index node, const green::GreenTable& green,
                                Eigen::Ref<VecXcd> row) const {
  std::vector<mesh::ElementPoint> holders;
  for (const auto& [element, local] : node_elements_[node])
    holders.push_back(
        {element, mesh::q8_parametric_nodes()(0, local), mesh::q8_parametric_nodes()(1, local)});
  fill_row(mesh_.nodes().col(node), holders, green, row);
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

void ElementIntegrals::fill_row(const Point2& target,
                                const std::vector<mesh::ElementPoint>& holders,
                                const green::GreenTable& green, Eigen::Ref<VecXcd> row) const {
  FLOE_EXPECT(row.size() == mesh_.node_count());
  const FarRules& rules = *far_;
  const double wavenumber = green.exact().wavenumber();
  const mesh::Connectivity& connectivity = mesh_.elements();
  row.setZero();
  QuadraturePoints points;
  KernelBuffer buffer;
  const auto add_points = [&](Index element) {
    std::array<Complex, 8> sum;
    sum_kernel(target, points.x.data(), points.y.data(), points.weight.data(), points.count(),
               green, buffer, sum.data());
    for (int m = 0; m < 8; ++m) row[connectivity(m, element)] += sum[m];
    points.clear();
  };

  // Integrate the elements that hold the target
  for (const mesh::ElementPoint& holder : holders) {
    add_singular_points(mesh_.element_nodes(holder.element), holder.xi, holder.eta, wavenumber,
                        green.exact().depth(), points);
    add_points(holder.element);
  }

  // Sort all others by the order that they need, near ones subdivided at once
  std::vector<Batch> batches;
  for (int tier = 0; tier < FarRules::kTiers; ++tier)
    batches.emplace_back(target, green, rules, tier);
  for (Index e = 0; e < mesh_.element_count(); ++e) {
    bool held = false;
    for (const mesh::ElementPoint& holder : holders) held = held || holder.element == e;
    if (held) continue;
    const double half_edge = rules.half_edge(e);
    double gap = (rules.centre(e) - target).norm() - rules.radius(e);
    if (gap < 4.0 * half_edge) gap = distance_to_element(target, mesh_.element_nodes(e));
    const int tier =
        std::max(rules.tier_for_gap(gap, half_edge), rules.tier_for_wave(wavenumber, half_edge));
    if (tier == FarRules::kTooNear) {
      add_near_points(target, mesh_.element_nodes(e), wavenumber, rules, points);
      add_points(e);
      continue;
    }
    batches[tier].add(e);
    if (batches[tier].full()) batches[tier].flush(connectivity, row);
  }
  for (Batch& batch : batches) batch.flush(connectivity, row);
}

}  // namespace floe::bem
