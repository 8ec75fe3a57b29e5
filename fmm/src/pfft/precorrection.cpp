#include "pfft/precorrection.hpp"

#include <floe/numeric/simd.hpp>

#include <cstdlib>

namespace floe::fmm::pfft {
namespace {

// to = Σ_a factor[a] · from[a], rows of `count` numbers in whole vectors
template <class Real>
FLOE_INLINE void combine_rows(const Real* const* from, const Real* factor, int terms, Index count,
                              Real* to) {
  for (Index i = 0; i < count; i += kLanes<Real>) {
    Lanes<Real> sum = {};
    for (int a = 0; a < terms; ++a) {
      Lanes<Real> row;
      load(row, from[a] + i);
      sum += factor[a] * row;
    }
    store(to + i, sum);
  }
}

FLOE_SIMD_CLONES void combine(const float* const* from, const float* factor, int terms, Index count,
                              float* to) {
  combine_rows(from, factor, terms, count, to);
}
FLOE_SIMD_CLONES void combine(const double* const* from, const double* factor, int terms,
                              Index count, double* to) {
  combine_rows(from, factor, terms, count, to);
}

// Weights along x and y
template <class Real>
void point_weights(const StencilPolynomials<Real>& polynomials, const Real* place,
                   Real (&weight)[2][kWeights]) {
  for (int axis = 0; axis < 2; ++axis) {
    AxisWeights<Real> along;
    polynomials.evaluate(place[axis], along);
    for (int v = 0; v < AxisWeights<Real>::kVectors; ++v)
      store(weight[axis] + kLanes<Real> * v, along.vector[v]);
  }
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

template <class Real>
FLOE_INLINE void all_values(const BoxView<Real>& box, const std::int32_t* sources,
                            std::size_t count, Real* value) {
  constexpr int kV = static_cast<int>(kWeights / kLanes<Real>);
  for (std::size_t k = 0; k < count; ++k) {
    const Index s = sources[k];
    AxisWeights<Real> along_x, along_y;
    box.polynomials.evaluate(box.place[2 * s], along_x);
    box.polynomials.evaluate(box.place[2 * s + 1], along_y);
    Real weight_y[kWeights];
    for (int v = 0; v < kV; ++v) store(weight_y + kLanes<Real> * v, along_y.vector[v]);
    const Real* from = box.potential + (box.origin + box.cell_x[s] + box.stride * box.cell_y[s]);
    Lanes<Real> row[kV] = {};
    for (int b = 0; b < box.polynomials.stencil(); ++b, from += box.stride)
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
  all_values(box, sources, count, value);
}
FLOE_SIMD_CLONES void box_values(const BoxView<double>& box, const std::int32_t* sources,
                                 std::size_t count, double* value) {
  all_values(box, sources, count, value);
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
Precorrection<Real>::Box::Box(const Precorrection& parent)
    : parent_(parent),
      strip_(parent.stride_ * (parent.reach_ + 1)),
      potential_(parent.stride_ * parent.width_) {}

template <class Real>
void Precorrection<Real>::Box::fill(Index target) {
  const Precorrection& p = parent_;
  const CellPoints& targets = p.geometry_.targets();
  const int w = p.geometry_.grid.stencil;
  cell_x_ = targets.cell_x[target];
  cell_y_ = targets.cell_y[target];
  Real weight[2][kWeights];
  point_weights(p.polynomials_, targets.places<Real>() + 2 * target, weight);
  const Real* from[kWeights];

  // Along x: the stencil's line at every distance dy; dx = first point of the box - stencil point
  for (int dy = 0; dy <= p.reach_; ++dy) {
    for (int a = 0; a < w; ++a)
      from[a] = p.table_.data() + p.table_stride_ * dy + p.reach_ - a - p.radius_;
    combine(from, weight[0], w, p.stride_, strip_.data() + p.stride_ * dy);
  }

  // Along y
  for (int gy = 0; gy < p.width_; ++gy) {
    for (int b = 0; b < w; ++b) from[b] = strip_.data() + p.stride_ * std::abs(b + p.radius_ - gy);
    combine(from, weight[1], w, p.stride_, potential_.data() + p.stride_ * gy);
  }
}

template <class Real>
void Precorrection<Real>::Box::values(std::span<const std::int32_t> sources, Real* value) const {
  const Precorrection& p = parent_;
  const CellPoints& points = p.geometry_.sources;
  const Index origin = p.radius_ - cell_x_ + p.stride_ * (p.radius_ - cell_y_);
  box_values({potential_.data(), p.stride_, origin, p.polynomials_, points.places<Real>(),
              points.cell_x.data(), points.cell_y.data()},
             sources.data(), sources.size(), value);
}

template class Precorrection<float>;
template class Precorrection<double>;

}  // namespace floe::fmm::pfft
