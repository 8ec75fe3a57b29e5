#pragma once

#include "bem/near_pattern.hpp"
#include "bem/singular_functions.hpp"
#include "bem/source_rule.hpp"

#include <floe/bem/element_integrals.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// What the near matrix needs of the singular part of G, once for all frequencies (F.23): for each
/// entry of the pattern and each of the four functions, exact integrals over the near elements
/// minus what their source points give for it. Coincident points are left out.
class NearMoments {
 public:
  /// In parallel, same bits for any number of threads; equal pairs are integrated once. Values are
  /// kept in float or double. R² log R, or R too, is left out where in sampled rows it matters by
  /// less than a fifth of `tolerance` at ν = `max_wavenumber`.
  NearMoments(const NearPattern& pattern, const ElementIntegrals& integrals, const SourceRule& rule,
              double tolerance, double max_wavenumber, bool in_float);

  /// value[k] = Σ_f coefficient[f] · moment f of entry k of a row.
  void combine(Index row, const std::array<double, SingularFunctions::kCount>& coefficient,
               std::vector<double>& value) const;

  double memory() const;  ///< [byte]

 private:
  const NearPattern& pattern_;  // view
  int functions_;               // kept, 2 to 4
  std::vector<float> single_;   // functions_ an entry; one of the two is empty
  std::vector<double> double_;
};

}  // namespace floe::bem
