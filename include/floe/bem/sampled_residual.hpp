#pragma once

#include <floe/bem/element_integrals.hpp>

namespace floe::bem {

/// The residual b - (I + κ𝒢)x of (B.1) by the exact integrals, on some rows only: what a fast
/// operator's own residual cannot tell. Root mean square over the rows, relative to that of b over
/// all rows; the largest of the columns. The rows are random with a fixed seed; all of them where
/// there are fewer. A row costs as much as one of the dense matrix.
double sampled_residual(const ElementIntegrals& integrals, const green::GreenTable& green,
                        const Eigen::Ref<const MatXcd>& x, const Eigen::Ref<const MatXcd>& b,
                        Index rows = 50);

/// The same relative to other right-hand sides, of the equation that was really solved.
double sampled_residual(const ElementIntegrals& integrals, const green::GreenTable& green,
                        const Eigen::Ref<const MatXcd>& x, const Eigen::Ref<const MatXcd>& b,
                        const Eigen::Ref<const MatXcd>& relative_to, Index rows = 50);

}  // namespace floe::bem
