#pragma once

#include <floe/numeric/types.hpp>

namespace floe::numeric {

/// cosine[i] + i sine[i] = e^{i angle[i]}, many at once by vector instructions: the library's
/// functions take one at a time. |angle| ≤ 1e6 rad, absolute error below 5e-16. Arrays may not
/// overlap.
void unit_phases(const double* angle, Index count, double* cosine, double* sine);

}  // namespace floe::numeric
