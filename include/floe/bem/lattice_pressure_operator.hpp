#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/bem/element_lattice.hpp>
#include <floe/fmm/padded_grid.hpp>
#include <floe/green/green_table.hpp>
#include <floe/krylov/linear_operator.hpp>

#include <memory>

namespace floe::bem {

class LatticeTables;

/// What no frequency changes: the lattice, its padded grid, the integration rules of its element.
struct LatticePlan {
  /// Throws MeshError when the mesh is not on a lattice (find_element_lattice).
  explicit LatticePlan(const mesh::Q8Mesh& mesh, const IntegralOptions& options = {});

  ElementLattice lattice;
  Index node_count;
  mesh::Q8Mesh element;  ///< one cell, centred on the origin
  double tolerance;      ///< of the integrals over one element
  fmm::PaddedGrid grid;
};

/// I + κ𝒢 on equal elements, exact to rounding (and to the tolerance of the element integrals),
/// near field included: the collocation matrix depends on differences of lattice positions only
/// (F.5). The eight local nodes of the elements are eight lattices of sources, the corners and the
/// two kinds of mid-sides three lattices of targets; sums and differences over mirrored local nodes
/// make every kernel even or odd, so that a quarter of each spectrum is stored. Since sources
/// belong to elements, edges, holes and gaps need nothing special. One application is eleven pruned
/// FFTs; about 24·16 bytes a cell.
class LatticePressureOperator final : public krylov::LinearOperator {
 public:
  LatticePressureOperator(std::shared_ptr<const LatticePlan> plan, const green::GreenTable& green);

  Index size() const override { return plan_->node_count; }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;

  /// Memory of the spectra [byte]; the plan is shared.
  double memory() const;

 private:
  void apply_column(const Complex* x, Complex* y) const;

  std::shared_ptr<const LatticePlan> plan_;
  std::shared_ptr<const LatticeTables> tables_;
  double kappa_;
};

}  // namespace floe::bem
