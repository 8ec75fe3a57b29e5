#include "pfft/precorrection.hpp"

#include <floe/numeric/simd.hpp>

#include <cstdlib>

namespace floe::fmm::pfft {
namespace {

// A target's box and what it is made from. Rows have whole vectors.
template <class Real>
struct BoxTask {
  const StencilPolynomials<Real>& polynomials;
  const Real* place;  // of the target
  const Real* table;  // at dx = -radius, dy = 0: the box begins there, seen from the stencil
  Index table_stride;
  int radius, reach;
  Index width, stride;
  Real *strip, *potential;
};

// to = Σ_a factor[a] · from[a]
template <class Real, int kTerms>
FLOE_INLINE void combine(const Real* const* from, const Real* factor, Index count, Real* to) {
  for (Index i = 0; i < count; i += kLanes<Real>) {
    Lanes<Real> sum = {};
    for (int a = 0; a < kTerms; ++a) {
      Lanes<Real> row;
      load(row, from[a] + i);
      sum += factor[a] * row;
    }
    store(to + i, sum);
  }
}

template <class Real, int kStencil>
FLOE_INLINE void fill_all(const BoxTask<Real>& box) {
  Real weight[2][kWeights];
  for (int axis = 0; axis < 2; ++axis) {
    AxisWeights<Real> along;
    box.polynomials.evaluate_of(kStencil, box.place[axis], along);
    for (int v = 0; v < AxisWeights<Real>::kVectors; ++v)
      store(weight[axis] + kLanes<Real> * v, along.vector[v]);
  }
  const Real* from[kStencil];

  // Along x: the stencil's line at every distance dy
  for (int dy = 0; dy <= box.reach; ++dy) {
    for (int a = 0; a < kStencil; ++a) from[a] = box.table + box.table_stride * dy - a;
    combine<Real, kStencil>(from, weight[0], box.stride, box.strip + box.stride * dy);
  }

  // Along y
  for (int gy = 0; gy < box.width; ++gy) {
    for (int b = 0; b < kStencil; ++b)
      from[b] = box.strip + box.stride * std::abs(b + box.radius - gy);
    combine<Real, kStencil>(from, weight[1], box.stride, box.potential + box.stride * gy);
  }
}

FLOE_SIMD_CLONES void fill_box(const BoxTask<float>& box) {
  for_stencil(
      box.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        fill_all<float, stencil()>(box);
      });
}
FLOE_SIMD_CLONES void fill_box(const BoxTask<double>& box) {
  for_stencil(
      box.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        fill_all<double, stencil()>(box);
      });
}

// The box, and where sources' stencils lie in it
template <class Real>
struct BoxView {
  const Real* potential;
  Index stride, origin;  // origin: cell (0, 0) of the whole grid would begin there
  const StencilPolynomials<Real>& polynomials;
  const Real* place;
  const std::int32_t *cell_x, *cell_y;
};

template <class Real, int kStencil>
FLOE_INLINE void all_values(const BoxView<Real>& box, const std::int32_t* sources,
                            std::size_t count, Real* value) {
  constexpr int kV = static_cast<int>(kWeights / kLanes<Real>);
  for (std::size_t k = 0; k < count; ++k) {
    const Index s = sources[k];
    AxisWeights<Real> along_x, along_y;
    box.polynomials.evaluate_of(kStencil, box.place[2 * s], along_x);
    box.polynomials.evaluate_of(kStencil, box.place[2 * s + 1], along_y);
    Real weight_y[kWeights];
    for (int v = 0; v < kV; ++v) store(weight_y + kLanes<Real> * v, along_y.vector[v]);
    const Real* from = box.potential + (box.origin + box.cell_x[s] + box.stride * box.cell_y[s]);
    Lanes<Real> row[kV] = {};
    for (int b = 0; b < kStencil; ++b, from += box.stride)
      for (int v = 0; v < kV; ++v) {
        Lanes<Real> part;
        load(part, from + kLanes<Real> * v);
        row[v] += weight_y[b] * part;
      }
    Lanes<Real> sum = {};
    for (int v = 0; v < kV; ++v) sum += along_x.vector[v] * row[v];
    value[k] = sum_of_lanes(sum);
  }
}

FLOE_SIMD_CLONES void box_values(const BoxView<float>& box, const std::int32_t* sources,
                                 std::size_t count, float* value) {
  for_stencil(
      box.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        all_values<float, stencil()>(box, sources, count, value);
      });
}
FLOE_SIMD_CLONES void box_values(const BoxView<double>& box, const std::int32_t* sources,
                                 std::size_t count, double* value) {
  for_stencil(
      box.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        all_values<double, stencil()>(box, sources, count, value);
      });
}

}  // namespace

template <class Real>
Precorrection<Real>::Precorrection(const Geometry& geometry,
                                   const std::function<double(Index, Index)>& table)
    : geometry_(geometry),
      polynomials_(geometry.grid.stencil),
      radius_(geometry.near.radius),
      reach_(radius_ + geometry.grid.stencil - 1),
      width_(2 * radius_ + geometry.grid.stencil),
      stride_(whole_lanes<Real>(2 * radius_ + kWeights)),
      table_stride_(2 * reach_ + 1 + stride_),
      table_(LaneBuffer<Real>::zeros(table_stride_ * (reach_ + 1))) {
  for (int dy = 0; dy <= reach_; ++dy)
    for (int dx = -reach_; dx <= reach_; ++dx)
      if (std::abs(dx) < geometry.grid.nx && dy < geometry.grid.ny)
        table_.data()[table_stride_ * dy + dx + reach_] =
            static_cast<Real>(table(std::abs(dx), dy));
}

template <class Real>
void Precorrection<Real>::Box::fill(Index target) {
  const Precorrection& p = parent_;
  const CellPoints& targets = p.geometry_.targets();
  cell_x_ = targets.cell_x[target];
  cell_y_ = targets.cell_y[target];
  fill_box({p.polynomials_, targets.places<Real>() + 2 * target,
            p.table_.data() + p.reach_ - p.radius_, p.table_stride_, p.radius_, p.reach_, p.width_,
            p.stride_, strip_, potential_});
}

template <class Real>
void Precorrection<Real>::Box::values(std::span<const std::int32_t> sources, Real* value) const {
  const Precorrection& p = parent_;
  const CellPoints& points = p.geometry_.sources;
  const Index origin = p.radius_ - cell_x_ + p.stride_ * (p.radius_ - cell_y_);
  box_values({potential_, p.stride_, origin, p.polynomials_, points.places<Real>(),
              points.cell_x.data(), points.cell_y.data()},
             sources.data(), sources.size(), value);
}

template class Precorrection<float>;
template class Precorrection<double>;

}  // namespace floe::fmm::pfft
