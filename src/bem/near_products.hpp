#pragma once

#include "bem/near_pattern.hpp"

#include <vector>

namespace floe::bem {

/// Columns that are multiplied together.
inline constexpr Index kNearColumns = 8;

/// y(target of each row of the block) += scale · C x for kNearColumns columns or one. `value` holds
/// all entries of the pattern; `gathered` is scratch. A column has the same bits alone and among
/// others.
template <class Real>
void add_near_block(const NearPattern& pattern, Index block, const Real* value,
                    const Eigen::Ref<const MatXcd>& x, double scale, std::vector<double>& gathered,
                    Eigen::Ref<MatXcd> y);

}  // namespace floe::bem
