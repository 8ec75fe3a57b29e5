#include <floe/fmm/sampled_error.hpp>

#include <algorithm>
#include <cmath>

namespace floe::fmm {

double sampled_error(const DirectSum& truth, const Eigen::Ref<const MatXcd>& charges,
                     const Eigen::Ref<const MatXcd>& potentials, Index samples) {
  const Index count = std::min(samples, truth.target_count());
  VecXd difference(count), reference(count);
#pragma omp parallel for schedule(dynamic, 1)
  for (Index s = 0; s < count; ++s) {
    // The golden ratio spreads the samples over the numbering, whatever its period
    const double share = std::fmod(0.5 + static_cast<double>(s) * 0.6180339887498949, 1.0);
    const Index target =
        count == truth.target_count()
            ? s
            : static_cast<Index>(share * static_cast<double>(truth.target_count()));
    const Eigen::RowVectorXcd exact = truth.potential_at(target, charges);
    difference[s] = (potentials.row(target) - exact).squaredNorm();
    reference[s] = exact.squaredNorm();
  }
  return std::sqrt(difference.sum() / reference.sum());
}

}  // namespace floe::fmm
