#pragma once

#include "pfft/grid.hpp"

#include <floe/fmm/radial_kernel.hpp>

#include <memory>
#include <span>

namespace floe::fmm::pfft {

/// What a sum computes with; single or double precision inside. Keeps a view of the geometry.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Near pairs are added if the engine was made with a near part and `with_near` is asked.
  virtual void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials,
                     bool with_near) const = 0;
  virtual bool has_near() const = 0;
  virtual void far_values(Index target, std::span<const Index> sources,
                          std::span<Complex> values) const = 0;
  virtual double memory() const = 0;
};

std::unique_ptr<const Engine> make_engine(const Geometry& geometry, const RadialKernel& kernel,
                                          bool with_near);

}  // namespace floe::fmm::pfft
