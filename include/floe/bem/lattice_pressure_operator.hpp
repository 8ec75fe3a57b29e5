#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/bem/element_lattice.hpp>
#include <floe/fmm/padded_grid.hpp>
#include <floe/green/green_table.hpp>
#include <floe/krylov/linear_operator.hpp>

#include <memory>

namespace floe::bem {

class AxisTransform;
class LatticeTables;
struct NodeLattices;

/// What no frequency changes: the lattices of nodes, their padded grid, the element.
struct LatticePlan {
  /// Throws MeshError when the mesh is not on a lattice (find_element_lattice).
  explicit LatticePlan(const mesh::Q8Mesh& mesh, const IntegralOptions& options = {});

  double memory() const;  ///< [byte]

  Index node_count;
  double step_x, step_y;  ///< edges of an element [m]
  Index nx, ny;           ///< cells of the bounding rectangle
  mesh::Q8Mesh element;   ///< one cell, centred on the origin
  double tolerance;       ///< of the integrals over one element
  fmm::PaddedGrid grid;
  std::shared_ptr<const NodeLattices> nodes;
  std::shared_ptr<const AxisTransform> along_x, along_y;  ///< of lines of the outline

 private:
  LatticePlan(const mesh::Q8Mesh& mesh, const IntegralOptions& options,
              const ElementLattice& elements);
};

/// I + κ𝒢 on equal elements, exact to rounding (and to the tolerance of the element integrals),
/// near field included: the collocation matrix depends on differences of lattice positions only
/// (F.14). Sources and targets are the three lattices of nodes; where an outline, edge or hole,
/// cuts a node's basis function, sources on few lines correct it. One application is six pruned
/// FFTs, five more for outlines with many steps; about 24·16 bytes a cell.
class LatticePressureOperator final : public krylov::LinearOperator {
 public:
  LatticePressureOperator(std::shared_ptr<const LatticePlan> plan, const green::GreenTable& green);

  Index size() const override { return plan_->node_count; }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;

  /// Memory of the spectra [byte]; the plan is shared.
  double memory() const;

 private:
  std::shared_ptr<const LatticePlan> plan_;
  std::shared_ptr<const LatticeTables> tables_;
};

}  // namespace floe::bem
