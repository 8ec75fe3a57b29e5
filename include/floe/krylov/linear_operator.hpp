#pragma once

#include <floe/numeric/types.hpp>

namespace floe::krylov {

/// A square linear operator that is known by what it does to vectors.
class LinearOperator {
 public:
  virtual ~LinearOperator() = default;

  virtual Index size() const = 0;

  /// y = A x; each column is one right-hand side. x and y have `size()` rows and must not overlap.
  virtual void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const = 0;
};

}  // namespace floe::krylov
