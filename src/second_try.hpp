#pragma once

#include "analysis_stages.hpp"

#include <optional>
#include <utility>

namespace floe {

/// Means for a frequency that the planned ones did not solve: a dense factorisation where it fits
/// into what methods are planned for and what is free, on the direct route and for more nodes the
/// accurate operator at every step, a basis in double precision without a restart, and more steps.
/// Nothing where there is no other means, or where it does not fit.
std::optional<FluidOperators> second_operators(const Case& data, const FluidModel& fluid);

/// Throws the error again with the frequency before it; where the mesh has few nodes a wavelength
/// of the water's wave, which is why iterations fail, also with this.
[[noreturn]] void throw_at_frequency(const ConvergenceError& error, double omega, const Case& data,
                                     const mesh::Q8Mesh& mesh);

/// Tells that a frequency is tried once more.
void tell_second_try(const ConvergenceError& first, double omega, SolverRoute route,
                     SolverMethod method, Log& log);

/// Exchanges the operators for as long as it lives.
class ExchangedOperators {
 public:
  ExchangedOperators(FluidModel& fluid, FluidOperators other)
      : fluid_(fluid), kept_(std::exchange(fluid.operators, std::move(other))) {}
  ~ExchangedOperators() { fluid_.operators = std::move(kept_); }
  ExchangedOperators(const ExchangedOperators&) = delete;
  ExchangedOperators& operator=(const ExchangedOperators&) = delete;

 private:
  FluidModel& fluid_;  // borrowed
  FluidOperators kept_;
};

/// What `solve` returns; where it does not converge, what it returns by other means. A
/// ConvergenceError of both gets the frequency [rad/s] it happened at.
template <typename Solve>
auto solve_or_retry(const Case& data, FluidModel& fluid, double omega, Log& log,
                    const Solve& solve) {
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  try {
    return solve();
  } catch (const ConvergenceError& first) {
    std::optional<FluidOperators> other = second_operators(data, fluid);
    if (!other) throw_at_frequency(first, omega, data, mesh);
    tell_second_try(first, omega, data.route, other->method, log);
    const ExchangedOperators exchanged(fluid, std::move(*other));
    try {
      return solve();
    } catch (const ConvergenceError& error) {
      throw_at_frequency(error, omega, data, mesh);
    }
  }
}

}  // namespace floe
