#include "pfft/precorrection.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>
#include <cstdlib>

namespace floe::fmm::pfft {
namespace {

// to += factor · from
FLOE_SIMD_CLONES
void add_scaled(const double* from, double factor, int count, double* to) {
  for (int i = 0; i < count; ++i) to[i] += factor * from[i];
}

}  // namespace

Precorrection::Precorrection(const Geometry& geometry,
                             const std::function<Complex(Index, Index)>& table)
    : geometry_(geometry),
      stencil_(geometry.grid.stencil),
      radius_(geometry.near.radius),
      reach_(radius_ + stencil_ - 1),
      width_(2 * radius_ + stencil_) {
  for (int dy = 0; dy <= reach_; ++dy)
    for (int dx = -reach_; dx <= reach_; ++dx) {
      const bool inside = std::abs(dx) < geometry.grid.nx && dy < geometry.grid.ny;
      const Complex value = inside ? table(std::abs(dx), dy) : Complex(0.0, 0.0);
      table_.push_back(value.real());
      table_.push_back(value.imag());
    }
}

Precorrection::Box::Box(const Precorrection& parent)
    : parent_(parent),
      strip_(static_cast<std::size_t>(2 * parent.width_ * (parent.reach_ + 1))),
      potential_(static_cast<std::size_t>(2 * parent.width_ * parent.width_)) {}

void Precorrection::Box::fill(Index target) {
  const Precorrection& p = parent_;
  const CellPoints& targets = p.geometry_.targets;
  cell_x_ = targets.cell_x[target];
  cell_y_ = targets.cell_y[target];
  const int row = 2 * p.width_;

  // Along x: the stencil's line at every distance dy
  const double* const wx = targets.weights_x(target, p.stencil_);
  std::fill(strip_.begin(), strip_.end(), 0.0);
  for (int dy = 0; dy <= p.reach_; ++dy)
    for (int a = 0; a < p.stencil_; ++a) {
      const int first = p.reach_ - a - p.radius_;  // dx = first point of the box - stencil point
      add_scaled(p.table_.data() + 2 * ((2 * p.reach_ + 1) * dy + first), wx[a], row,
                 strip_.data() + row * dy);
    }

  // Along y
  const double* const wy = targets.weights_y(target, p.stencil_);
  std::fill(potential_.begin(), potential_.end(), 0.0);
  for (int gy = 0; gy < p.width_; ++gy)
    for (int b = 0; b < p.stencil_; ++b)
      add_scaled(strip_.data() + row * std::abs(b + p.radius_ - gy), wy[b], row,
                 potential_.data() + row * gy);
}

Complex Precorrection::Box::value(Index source) const {
  const Precorrection& p = parent_;
  const CellPoints& sources = p.geometry_.sources;
  const int w = p.stencil_;
  const double* const wx = sources.weights_x(source, w);
  const double* const wy = sources.weights_y(source, w);
  const Index dx = sources.cell_x[source] - cell_x_ + p.radius_;
  const Index dy = sources.cell_y[source] - cell_y_ + p.radius_;
  const double* corner = potential_.data() + 2 * (dx + p.width_ * dy);
  double re = 0.0, im = 0.0;
  for (int b = 0; b < w; ++b, corner += 2 * p.width_) {
    double row_re = 0.0, row_im = 0.0;
    for (int a = 0; a < w; ++a) {
      row_re += wx[a] * corner[2 * a];
      row_im += wx[a] * corner[2 * a + 1];
    }
    re += wy[b] * row_re;
    im += wy[b] * row_im;
  }
  return {re, im};
}

}  // namespace floe::fmm::pfft
