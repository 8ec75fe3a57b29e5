#include "multipole/translations.hpp"

namespace floe::fmm::multipole {
namespace {

MatXcd between_skeletons(const RadialKernel& kernel, const LevelBasis& basis,
                         const Point2& offset) {
  return kernel_matrix(kernel, basis.skeleton, basis.skeleton.colwise() + offset);
}

}  // namespace

MatXd child_to_parent(const Bases& bases, std::size_t level, int child) {
  const LevelBasis& parent = bases[level];
  const LevelBasis& part = bases[level + 1];
  const Points2 points = part.skeleton.colwise() + child_centre(child, parent.width);
  const MatXd weights =
      parent.nodes > 0
          ? skeleton_weights(bases, level, points)
          : MatXd(parent.from_candidates.middleCols(child * points.cols(), points.cols()));
  return parent.restrict * weights * part.expand;
}

MatXd box_to_box_real(const RadialKernel& kernel, const LevelBasis& basis, const Point2& offset) {
  const MatXd field = between_skeletons(kernel, basis, offset).real();
  return basis.expand.transpose() * field * basis.expand;
}

MatXd box_to_box_imag(const RadialKernel& kernel, const LevelBasis& basis, const Point2& offset) {
  const MatXd field = between_skeletons(kernel, basis, offset).imag();
  return basis.expand.transpose() * field * basis.expand;
}

}  // namespace floe::fmm::multipole
