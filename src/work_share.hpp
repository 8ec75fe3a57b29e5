#pragma once

#include <floe/estimate.hpp>

#include <cstddef>

namespace floe {

/// How much of a run's work is done, weighted by the predicted cost of its parts. What an earlier
/// run did is no work of this one.
class WorkShare {
 public:
  WorkShare(const Estimate& plan, const Case& data);

  void plate(bool known);      ///< its modes are there now, or it is ready without
  void frequency(bool known);  ///< one more
  /// Transfer functions before `place` are done, of `count`, those before `first` by another run.
  void seas(std::size_t place, std::size_t first, std::size_t count);

  double share() const;  ///< 0 … 1

 private:
  double plate_ = 0.0, frequency_ = 0.0, seas_ = 0.0;  // predicted [s]
  double done_ = 0.0, left_ = 0.0;                     // [s]
  double seas_done_ = 0.0;                             // of done_, by the seas [s]
};

}  // namespace floe
