#include "multipole/engine.hpp"

#include <cmath>

namespace floe::fmm::multipole {
namespace {

constexpr double kSingleFrom = 8e-7;  // tolerances that single precision reaches
constexpr double kLossShare = 0.12;   // of the tolerance, loss of a basis

// Rows of `length` numbers from the columns of a matrix
template <class Real>
void copy_rows(const MatXd& columns, Index length, Real* rows) {
  for (Index j = 0; j < columns.cols(); ++j)
    for (Index i = 0; i < columns.rows(); ++i)
      rows[j * length + i] = static_cast<Real>(columns(i, j));
}

}  // namespace

std::unique_ptr<const Engine> make_engine(const Geometry& geometry, const RadialKernel& kernel,
                                          double tolerance, bool store_near) {
  if (tolerance >= kSingleFrom)
    return std::make_unique<TypedEngine<float>>(geometry, kernel, tolerance, store_near);
  return std::make_unique<TypedEngine<double>>(geometry, kernel, tolerance, store_near);
}

template <class Real>
TypedEngine<Real>::TypedEngine(const Geometry& geometry, const RadialKernel& kernel,
                               double tolerance, bool store_near)
    : geometry_(geometry), kernel_(kernel), near_(geometry, kernel, store_near) {
  const Quadtree& tree = geometry.tree;
  if (tree.levels() <= kTopLevel) return;  // no points
  const Bases bases = make_bases(kernel, tree.width(kTopLevel), tree.levels() - kTopLevel,
                                 tree.root_width, kLossShare * tolerance);
  build_matrices(bases);
  build_weights(bases);
  build_mixed(bases);
}

template <class Real>
void TypedEngine<Real>::build_matrices(const Bases& bases) {
  const Quadtree& tree = geometry_.tree;
  matrices_.resize(tree.levels());
#pragma omp parallel for schedule(dynamic, 1)
  for (int level = kTopLevel; level < tree.levels(); ++level) {
    const LevelBasis& basis = bases[level - kTopLevel];
    LevelMatrices<Real>& matrices = matrices_[level];
    matrices.rank = basis.rank();
    matrices.stride = padded<Real>(basis.rank());
    for (int child = 0; child < 4 && level + 1 < tree.levels(); ++child) {
      const MatXd up = child_to_parent(bases, level - kTopLevel, child);
      matrices.up[child] = padded_columns<Real>(up);
      matrices.down[child] = padded_columns<Real>(up.transpose());
    }
    const LevelTranslations& lists = geometry_.lists.translations[level];
    for (int offset = 0; offset < kOffsets; ++offset) {
      bool asked = false;
      for (Index chunk = 0; chunk < lists.chunks() && !asked; ++chunk)
        asked = lists.begin[chunk * kOffsets + offset] < lists.begin[chunk * kOffsets + offset + 1];
      const Point2 shift = basis.width * Point2(offset % 7 - 3, offset / 7 - 3);
      if (asked)
        matrices.across[offset] = padded_columns<Real>(box_to_box_real(kernel_, basis, shift));
    }
  }
  for (int offset = 0; offset < kOffsets; ++offset) {
    const LevelBasis& basis = bases[0];
    const Point2 shift = basis.width * Point2(offset % 7 - 3, offset / 7 - 3);
    top_[offset] = padded_columns<Real>(box_to_box_imag(kernel_, basis, shift));
  }
}

template <class Real>
void TypedEngine<Real>::build_weights(const Bases& bases) {
  const Quadtree& tree = geometry_.tree;
  const auto build = [&](bool of_sources, std::vector<Index>& start, AlignedArray<Real>& weights) {
    const auto begin = [&](const Box& b) { return of_sources ? b.source_begin : b.target_begin; };
    const auto count = [&](const Box& b) { return of_sources ? b.sources() : b.targets(); };
    const auto boxes = static_cast<Index>(tree.boxes.size());
    start.assign(boxes, 0);
    Index size = 0;
    for (Index b = 0; b < boxes; ++b)
      if (tree.boxes[b].leaf()) {
        start[b] = size;
        size += count(tree.boxes[b]) * matrices_[tree.boxes[b].level].stride;
      }
    weights = AlignedArray<Real>(size);
#pragma omp parallel for schedule(dynamic, 16)
    for (Index b = 0; b < boxes; ++b) {
      const Box& box = tree.boxes[b];
      if (!box.leaf() || count(box) == 0) continue;
      const Points2 points =
          (of_sources ? tree.sources : tree.targets).middleCols(begin(box), count(box)).colwise() -
          tree.centre(box);
      const std::size_t level = box.level - kTopLevel;
      copy_rows<Real>(bases[level].restrict * skeleton_weights(bases, level, points),
                      matrices_[box.level].stride, weights.data() + start[b]);
    }
  };
  build(true, source_start_, source_weights_);
  if (!tree.same_points) build(false, target_start_, target_weights_);
}

template <class Real>
void TypedEngine<Real>::build_mixed(const Bases& bases) {
  const Quadtree& tree = geometry_.tree;
  const auto build = [&](const std::vector<BoxPair>& pairs, bool wide, std::vector<Index>& start,
                         AlignedArray<Real>& values) {
    // The wide box gives points, the narrow one its skeleton
    const auto points_of = [&](const BoxPair& pair) -> Points2 {
      const Box& box = tree.boxes[wide ? pair.target : pair.source];
      return wide ? tree.targets.middleCols(box.target_begin, box.targets())
                  : tree.sources.middleCols(box.source_begin, box.sources());
    };
    const auto count = static_cast<Index>(pairs.size());
    Index size = 0;
    for (const BoxPair& pair : pairs) {
      const Box& narrow = tree.boxes[wide ? pair.source : pair.target];
      start.push_back(size);
      size += points_of(pair).cols() * matrices_[narrow.level].stride;
    }
    values = AlignedArray<Real>(size);
#pragma omp parallel for schedule(dynamic, 16)
    for (Index p = 0; p < count; ++p) {
      const Box& narrow = tree.boxes[wide ? pairs[p].source : pairs[p].target];
      const LevelBasis& basis = bases[narrow.level - kTopLevel];
      const MatXd field = kernel_matrix(kernel_, basis.skeleton.colwise() + tree.centre(narrow),
                                        points_of(pairs[p]))
                              .real();
      copy_rows<Real>(basis.expand.transpose() * field, matrices_[narrow.level].stride,
                      values.data() + start[p]);
    }
  };
  build(geometry_.lists.wide, true, wide_start_, wide_);
  build(geometry_.lists.narrow, false, narrow_start_, narrow_);
  wide_groups_ = target_groups(geometry_.lists.wide);
  narrow_groups_ = target_groups(geometry_.lists.narrow);
}

template <class Real>
double TypedEngine<Real>::memory() const {
  Index numbers = source_weights_.size() + target_weights_.size() + wide_.size() + narrow_.size();
  for (const LevelMatrices<Real>& level : matrices_) {
    for (int child = 0; child < 4; ++child)
      numbers += level.up[child].size() + level.down[child].size();
    for (const AlignedArray<Real>& matrix : level.across) numbers += matrix.size();
  }
  for (const AlignedArray<Real>& matrix : top_) numbers += matrix.size();
  const std::size_t indices =
      source_start_.size() + target_start_.size() + wide_start_.size() + narrow_start_.size();
  return static_cast<double>(sizeof(Real)) * static_cast<double>(numbers) +
         static_cast<double>(sizeof(Index) * indices) + near_.memory();
}

template <class Real>
std::vector<Index> TypedEngine<Real>::ranks() const {
  std::vector<Index> result;
  for (std::size_t level = kTopLevel; level < matrices_.size(); ++level)
    result.push_back(matrices_[level].rank);
  return result;
}

template class TypedEngine<float>;
template class TypedEngine<double>;

}  // namespace floe::fmm::multipole
