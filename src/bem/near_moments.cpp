#include "bem/near_moments.hpp"

#include "bem/quadrature_points.hpp"

#include <algorithm>
#include <cmath>

namespace floe::bem {
namespace {

constexpr int kCount = SingularFunctions::kCount;
constexpr double kLeftOut = 0.2;  // of the tolerance: may be lost with R and R² log R
using PairIntegrals = std::array<Complex, 16>;
using Moments = std::array<double, kCount>;

// Computes the moments of one row after the other; the scratch of one thread
class MomentRow {
 public:
  MomentRow(const NearPattern& pattern, const ElementIntegrals& integrals, const SourceRule& rule)
      : pattern_(pattern),
        integrals_(integrals),
        rule_(rule),
        entry_of_node_(integrals.mesh().node_count()),
        point_(rule.points_per_element()) {}

  const std::vector<Moments>& values(Index block, Index row,
                                     const std::vector<PairIntegrals>& by_kind) {
    pattern_.place_entries(block, row, entry_of_node_);
    values_.assign(pattern_.entry_begin(row + 1) - pattern_.entry_begin(row), Moments{});
    const auto near = pattern_.near_elements(row);
    elements_.assign(near.begin(), near.end());
    integral_.resize(elements_.size());
    moment_.resize(elements_.size());
    if (by_kind.empty())
      integrals_.node_singular_elements(pattern_.target(row), elements_, integral_);
    else
      for (std::size_t k = 0; k < elements_.size(); ++k)
        integral_[k] = by_kind[pattern_.near_kinds(row)[k]];
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      moment_[k] = integral_[k];
      subtract_points(pattern_.target(row), elements_[k], moment_[k]);
      for (int m = 0; m < 8; ++m) {
        Moments& to = values_[entry_of_node_[integrals_.mesh().elements()(m, elements_[k])]];
        for (int plane = 0; plane < kCount / 2; ++plane) {
          to[2 * plane] += moment_[k][8 * plane + m].real();
          to[2 * plane + 1] += moment_[k][8 * plane + m].imag();
        }
      }
    }
    return values_;
  }

  /// Exact integrals of the last row, by near element.
  const std::vector<PairIntegrals>& exact() const { return integral_; }

 private:
  void subtract_points(Index target, Index element, PairIntegrals& integral) {
    const int count = rule_.points_per_element();
    const Point2 position = integrals_.mesh().nodes().col(target);
    distance_.resize(count);
    value_.resize(kCount / 2 * count);
    for (int p = 0; p < count; ++p)
      distance_[p] = (rule_.points().col(rule_.point(element, p)) - position).norm();
    // NOTE: a coincident point counts nothing: any distance will do
    const auto coincident = std::find(distance_.begin(), distance_.end(), 0.0);
    if (coincident != distance_.end()) *coincident = 1.0;
    SingularFunctions::evaluate(distance_, value_.data());
    for (int plane = 0; plane < kCount / 2; ++plane) {
      std::copy_n(value_.begin() + plane * count, count, point_.begin());
      if (coincident != distance_.end()) point_[coincident - distance_.begin()] = 0.0;
      std::array<Complex, 8> sum;
      rule_.collect(element, point_.data(), sum.data());
      for (int m = 0; m < 8; ++m) integral[8 * plane + m] -= sum[m];
    }
  }

  const NearPattern& pattern_;
  const ElementIntegrals& integrals_;
  const SourceRule& rule_;
  std::vector<std::int32_t> entry_of_node_;
  std::vector<Moments> values_;
  std::vector<Index> elements_;
  std::vector<PairIntegrals> integral_, moment_;
  std::vector<double> distance_;
  std::vector<Complex> value_, point_;
};

std::vector<PairIntegrals> integrate_kinds(const NearPattern& pattern,
                                           const ElementIntegrals& integrals) {
  const auto& kinds = pattern.kinds();
  std::vector<PairIntegrals> by_kind(kinds.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Index element = kinds[k].element;
    integrals.node_singular_elements(kinds[k].node, {&element, 1}, {&by_kind[k], 1});
  }
  return by_kind;
}

// How many of the functions are needed: two, three or all four
int functions_for(const NearPattern& pattern, MomentRow& row,
                  const std::vector<PairIntegrals>& by_kind, double tolerance,
                  double max_wavenumber) {
  constexpr Index kSampledRows = 32;
  const Moments c = SingularFunctions::coefficients(max_wavenumber);
  double third = 0.0, fourth = 0.0, integral = 0.0;
  const Index samples = std::min(kSampledRows, pattern.rows());
  for (Index s = 0; s < samples; ++s) {
    const Index i = (2 * s + 1) * pattern.rows() / (2 * samples);
    for (const Moments& m : row.values(i / NearPattern::kBlockRows, i, by_kind)) {
      third += std::pow(c[2] * m[2], 2);
      fourth += std::pow(c[3] * m[3], 2);
    }
    for (const PairIntegrals& pair : row.exact())
      for (int m = 0; m < 8; ++m) integral += std::pow(c[0] * pair[m].real(), 2);
  }
  const double allowed = std::pow(kLeftOut * tolerance, 2) * integral;
  return third + fourth <= allowed ? 2 : fourth <= allowed ? 3 : 4;
}

template <class Real>
void fill(const NearPattern& pattern, int functions, MomentRow& row,
          const std::vector<PairIntegrals>& by_kind, std::vector<Real>& moments) {
#pragma omp for schedule(dynamic, 4)
  for (Index block = 0; block < pattern.blocks(); ++block) {
    const Index first = block * NearPattern::kBlockRows;
    const Index last = std::min(pattern.rows(), first + NearPattern::kBlockRows);
    for (Index i = first; i < last; ++i) {
      Real* at = moments.data() + functions * pattern.entry_begin(i);
      for (const Moments& entry : row.values(block, i, by_kind))
        at = std::transform(entry.begin(), entry.begin() + functions, at,
                            [](double value) { return static_cast<Real>(value); });
    }
  }
}

template <class Real>
void combine_row(const Real* moment, int functions, std::size_t count, const Moments& coefficient,
                 std::vector<double>& value) {
  for (std::size_t k = 0; k < count; ++k) {
    const Real* const m = moment + functions * k;
    double sum = 0.0;
    for (int f = 0; f < functions; ++f) sum += coefficient[f] * m[f];
    value[k] = sum;
  }
}

}  // namespace

NearMoments::NearMoments(const NearPattern& pattern, const ElementIntegrals& integrals,
                         const SourceRule& rule, double tolerance, double max_wavenumber,
                         bool in_float)
    : pattern_(pattern) {
  const std::vector<PairIntegrals> by_kind = integrate_kinds(pattern, integrals);
  MomentRow sample(pattern, integrals, rule);
  functions_ = functions_for(pattern, sample, by_kind, tolerance, max_wavenumber);
  const std::size_t size = functions_ * pattern.entry_count();
  in_float ? single_.resize(size) : double_.resize(size);
#pragma omp parallel
  {
    MomentRow row(pattern, integrals, rule);
    if (in_float)
      fill(pattern, functions_, row, by_kind, single_);
    else
      fill(pattern, functions_, row, by_kind, double_);
  }
}

void NearMoments::combine(Index row, const Moments& coefficient, std::vector<double>& value) const {
  const std::size_t first = functions_ * pattern_.entry_begin(row);
  const std::size_t count = pattern_.entry_begin(row + 1) - pattern_.entry_begin(row);
  value.resize(count);
  if (double_.empty())
    combine_row(single_.data() + first, functions_, count, coefficient, value);
  else
    combine_row(double_.data() + first, functions_, count, coefficient, value);
}

double NearMoments::memory() const {
  return 8.0 * static_cast<double>(double_.size()) + 4.0 * static_cast<double>(single_.size());
}

}  // namespace floe::bem
