#pragma once

#include <floe/bem/element_integrals.hpp>

namespace floe::bem {

/// The residual b - (I + κ𝒢)x of (B.1) at the middles of elements, where no Q8 node lies and
/// nothing was asked of x: what the elements' size leaves, where the residual at the nodes is the
/// solver's. x and b, one column a problem, are taken between the nodes by the Q8 functions. The
/// sum is the one that gives the free surface's elevation (H.8), by the exact integrals. Root mean
/// square over at most `elements` of them, evenly through the mesh's list, relative to that of b
/// over all nodes; the largest of the columns.
double residual_between_nodes(const ElementIntegrals& integrals, const green::GreenTable& green,
                              const Eigen::Ref<const MatXcd>& x, const Eigen::Ref<const MatXcd>& b,
                              Index elements = 50);

}  // namespace floe::bem
