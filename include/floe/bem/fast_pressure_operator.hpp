#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/fmm/kernel_sum.hpp>
#include <floe/green/green_table.hpp>
#include <floe/krylov/linear_operator.hpp>

#include <limits>
#include <memory>

namespace floe::bem {

/// The kernel sum behind a FastPressureOperator.
enum class SumEngine {
  kDirect,     ///< all pairs, the twin of the others
  kPfft,       ///< pre-corrected FFT: outlines that fill much of their bounding rectangle
  kMultipole,  ///< fast multipole: everything else
};

struct FastOptions {
  SumEngine engine = SumEngine::kMultipole;
  /// Relative error ‖(A - A*) p‖ / ‖𝒢p‖ for any p, 1e-7 … 1e-2 (multipole: from 1e-9), to a factor
  /// of about two; smooth p come out better.
  double tolerance = 1e-4;
  double max_wavenumber = 0.0;  ///< largest k for which the plan will be used [rad/m]
  double memory_budget = std::numeric_limits<double>::infinity();  ///< of plan and operator [byte]
};

/// What no frequency changes: source points, engine's plan, near pairs.
class FastPressurePlan {
 public:
  /// Keeps a view of the mesh. Throws InputError on a tolerance out of range, BudgetError when the
  /// near field does not fit the memory.
  FastPressurePlan(const mesh::Q8Mesh& mesh, const FastOptions& options);
  ~FastPressurePlan();

  const mesh::Q8Mesh& mesh() const;
  const FastOptions& options() const { return options_; }
  /// Largest distance at which an operator evaluates G [m]: let its table go so far.
  double reach() const;
  double memory() const;  ///< [byte]

 private:
  friend class FastPressureOperator;
  struct Parts;
  FastOptions options_;
  std::unique_ptr<const Parts> parts_;
};

/// I + κ𝒢 for any mesh, curved, graded, unstructured, in several pieces: T K S and a near matrix
/// (F.2). The pressure of far elements becomes point charges (nodes or Gauss points, whichever
/// the tolerance asks for), a kernel sum carries them to the nodes, and near elements are corrected
/// to the exact integrals.
class FastPressureOperator final : public krylov::LinearOperator {
 public:
  /// Throws InputError when the wavenumber exceeds the plan's.
  FastPressureOperator(std::shared_ptr<const FastPressurePlan> plan,
                       const green::GreenTable& green);
  ~FastPressureOperator() override;

  Index size() const override;
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;

  /// Without the plan [byte].
  double memory() const;

 private:
  struct State;
  std::shared_ptr<const FastPressurePlan> plan_;
  std::unique_ptr<const State> state_;
};

}  // namespace floe::bem
