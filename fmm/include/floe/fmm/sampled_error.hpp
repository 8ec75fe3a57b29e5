#pragma once

#include <floe/fmm/direct_sum.hpp>

namespace floe::fmm {

/// Relative error ‖u - u*‖₂ / ‖u*‖₂ of potentials, estimated at `samples` targets spread over all
/// (every one, if there are no more): the truth u* is summed directly there.
double sampled_error(const DirectSum& truth, const Eigen::Ref<const MatXcd>& charges,
                     const Eigen::Ref<const MatXcd>& potentials, Index samples = 200);

}  // namespace floe::fmm
