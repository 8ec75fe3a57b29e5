#include "bem/worst_column.hpp"

#include <floe/bem/sampled_residual.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

namespace floe::bem {
namespace {

// Different nodes, the same ones every time
std::vector<Index> choose_rows(Index nodes, Index count) {
  std::vector<Index> all(static_cast<std::size_t>(nodes));
  std::iota(all.begin(), all.end(), Index{0});
  std::mt19937_64 random(1);
  const Index chosen = std::min(count, nodes);
  for (Index i = 0; i < chosen && chosen < nodes; ++i)
    std::swap(all[static_cast<std::size_t>(i)],
              all[static_cast<std::size_t>(i) + random() % static_cast<std::uint64_t>(nodes - i)]);
  all.resize(static_cast<std::size_t>(chosen));
  return all;
}

}  // namespace

double sampled_residual(const ElementIntegrals& integrals, const green::GreenTable& green,
                        const Eigen::Ref<const MatXcd>& x, const Eigen::Ref<const MatXcd>& b,
                        Index rows) {
  return sampled_residual(integrals, green, x, b, b, rows);
}

double sampled_residual(const ElementIntegrals& integrals, const green::GreenTable& green,
                        const Eigen::Ref<const MatXcd>& x, const Eigen::Ref<const MatXcd>& b,
                        const Eigen::Ref<const MatXcd>& relative_to, Index rows) {
  const Index nodes = integrals.mesh().node_count();
  FLOE_EXPECT(x.rows() == nodes && b.rows() == nodes && x.cols() == b.cols() &&
              x.cols() == relative_to.cols());
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  const std::vector<Index> chosen = choose_rows(nodes, rows);
  MatXcd residual(static_cast<Index>(chosen.size()), x.cols());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    VecXcd row(nodes);
    integrals.node_row(chosen[i], green, row);
    residual.row(static_cast<Index>(i)) =
        b.row(chosen[i]) - x.row(chosen[i]) - kappa * (row.transpose() * x);
  }
  return worst_column(residual, relative_to);
}

}  // namespace floe::bem
