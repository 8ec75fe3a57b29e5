#include "work_share.hpp"

#include <algorithm>

namespace floe {

WorkShare::WorkShare(const Estimate& plan, const Case& data) {
  for (const StageEstimate& stage : plan.stages) {
    if (stage.stage == "dry modes")
      plate_ += stage.seconds;
    else if (stage.stage == "seas")
      seas_ += data.shard.holds_seas() ? stage.seconds : 0.0;
    else
      frequency_ += stage.seconds / static_cast<double>(data.omega.size());
  }
  left_ = plate_ + seas_;
  for (std::size_t i = 0; i < data.omega.size(); ++i)
    if (data.shard.holds(i)) left_ += frequency_;
}

void WorkShare::plate(bool known) {
  left_ -= plate_;
  if (!known) done_ += plate_;
}

void WorkShare::frequency(bool known) {
  left_ -= frequency_;
  if (!known) done_ += frequency_;
}

void WorkShare::seas(std::size_t place, std::size_t first, std::size_t count) {
  // NOTE: called anew for every place; the seas come last, so that only they are left
  const double total = seas_ * static_cast<double>(count - first) / static_cast<double>(count);
  const double passed = place > first ? static_cast<double>(place - first) : 0.0;
  const double now = count > first ? total * passed / static_cast<double>(count - first) : 0.0;
  done_ += now - seas_done_;
  seas_done_ = now;
  left_ = total - now;
}

double WorkShare::share() const {
  const double whole = done_ + std::max(left_, 0.0);
  return whole > 0.0 ? std::clamp(done_ / whole, 0.0, 1.0) : 0.0;
}

}  // namespace floe
