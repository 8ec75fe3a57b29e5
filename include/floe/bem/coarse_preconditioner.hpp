#pragma once

#include <floe/green/green_table.hpp>
#include <floe/krylov/linear_operator.hpp>
#include <floe/mesh/q8_mesh.hpp>

#include <memory>

namespace floe::bem {

struct CoarseOptions {
  double points_per_wavelength = 10.0;  ///< of the grid, at most two a node
  Index max_unknowns = 2000;            ///< the grid is coarsened to about that
};

/// Two-grid preconditioner (S.6): the equation is solved by dense factors on a square grid that is
/// good enough for the wavelength, and the waves that this solution makes are taken off the nodal
/// values. Better than DampedWavePreconditioner from about six points a wavelength on, worse below
/// four. 8/3 n³ flops and 16 n² bytes once for n unknowns, 8 n² flops a column. Any mesh, outline
/// and depth. Same bits for any number of threads.
class CoarsePreconditioner final : public krylov::LinearOperator {
 public:
  CoarsePreconditioner(const mesh::Q8Mesh& mesh, const green::GreenTable& green,
                       const CoarseOptions& options = {});
  ~CoarsePreconditioner() override;

  Index size() const override { return size_; }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;

  Index unknowns() const;
  double points_per_wavelength() const { return points_per_wavelength_; }  ///< of the grid

 private:
  struct Level;
  Index size_;
  double points_per_wavelength_;
  std::unique_ptr<const Level> level_;
};

}  // namespace floe::bem
