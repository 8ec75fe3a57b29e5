#pragma once

#include "multipole/geometry.hpp"
#include "multipole/near_rows.hpp"
#include "multipole/translations.hpp"

#include <memory>

namespace floe::fmm::multipole {

/// What a sum computes with; single or double precision inside.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials,
                     bool with_near) const = 0;
  virtual double memory() const = 0;
  virtual std::vector<Index> ranks() const = 0;
};

/// Chooses the precision.
std::unique_ptr<const Engine> make_engine(const Geometry& geometry, const RadialKernel& kernel,
                                          double tolerance, bool store_near);

/// Charges or potentials: real and imaginary part of each column, points in the tree's order.
template <class Real>
struct Columns {
  Columns(Index points, Index columns)
      : stride(padded<Real>(points) + padded<Real>(1)), values(2 * stride * columns) {}
  Real* real(Index column) { return values.data() + 2 * column * stride; }
  Real* imag(Index column) { return real(column) + stride; }
  const Real* real(Index column) const { return values.data() + 2 * column * stride; }
  const Real* imag(Index column) const { return real(column) + stride; }
  Index stride;
  AlignedArray<Real> values;
};

/// Moments or local expansions of the boxes of one level: box, column, real and imaginary part.
template <class Real>
struct Expansions {
  Expansions() = default;
  Expansions(Index boxes, Index column_count, Index level_rank, Index rank_stride)
      : columns(column_count),
        rank(level_rank),
        stride(rank_stride),
        values(boxes * columns * 2 * stride) {}
  Real* at(Index box, Index column) {
    return values.data() + (box * columns + column) * 2 * stride;
  }
  const Real* at(Index box, Index column) const {
    return values.data() + (box * columns + column) * 2 * stride;
  }
  Index columns = 0, rank = 0, stride = 0;
  AlignedArray<Real> values;
};

template <class Real>
class TypedEngine final : public Engine {
 public:
  TypedEngine(const Geometry& geometry, const RadialKernel& kernel, double tolerance,
              bool store_near);
  void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials,
             bool with_near) const override;
  double memory() const override;
  std::vector<Index> ranks() const override;

 private:
  using Levels = std::vector<Expansions<Real>>;  // by level of the tree, empty above level 2

  void build_matrices(const Bases& bases);
  void build_weights(const Bases& bases);
  void build_mixed(const Bases& bases);

  Levels make_levels(Index columns) const;
  void form_leaf_moments(const Columns<Real>& charges, Levels& moments) const;
  void shift_to_parents(Levels& moments) const;
  void translate_across_lists(const Levels& moments, Levels& locals) const;
  void couple_at_the_top(const Levels& moments, Levels& locals) const;
  void add_wide_sources(const Columns<Real>& charges, Levels& locals) const;
  void shift_to_children(Levels& locals) const;
  void evaluate_at_targets(const Levels& moments, const Levels& locals,
                           Columns<Real>& potentials) const;

  const Geometry& geometry_;                            // view
  const RadialKernel& kernel_;                          // view
  std::vector<LevelMatrices<Real>> matrices_;           // by level of the tree
  std::array<AlignedArray<Real>, kOffsets> top_;        // Im G between boxes of level 2
  AlignedArray<Real> source_weights_, target_weights_;  // r numbers a point; one array if the same
  std::vector<Index> source_start_, target_start_;      // by box, of its points' weights
  AlignedArray<Real> wide_, narrow_;                    // rows of Re G · expand
  std::vector<Index> wide_start_, narrow_start_;        // by pair
  std::vector<std::pair<Index, Index>> wide_groups_, narrow_groups_;
  NearRows<Real> near_;
};

}  // namespace floe::fmm::multipole
