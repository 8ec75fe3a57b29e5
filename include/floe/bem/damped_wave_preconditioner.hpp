#pragma once

#include <floe/fmm/even_spectrum.hpp>
#include <floe/green/green_function.hpp>
#include <floe/krylov/linear_operator.hpp>
#include <floe/mesh/q8_mesh.hpp>

#include <memory>
#include <optional>

namespace floe::bem {

class PlateGrid;

/// A thin plate that floats, per area and over ρg: what the symbol of (C.4) needs.
struct FloatingPlate {
  double rigidity = 0.0;    ///< D/ρg [m⁴]
  double inertia = 0.0;     ///< mω²/ρg [-]
  double wavenumber = 0.0;  ///< of the flexural-gravity wave, (H.1) [1/m]
};

struct DampedWaveOptions {
  double points_per_wavelength = 8.0;  ///< of the grid, at most two a node
  double points_per_node = 4.0;        ///< most points of the bounding box, times the nodes
  double damping = 0.35;               ///< ε kB in ν' = ν(1 + iε)
  std::optional<FloatingPlate>
      plate;  ///< for (C.4), plate and fluid in one: (S.7) instead of (S.5)
};

/// The inverse of I + κ𝒢 on the unbounded plane, damped, as preconditioner on the plate (S.5):
/// values at nodes go to a grid, are multiplied in wavenumber space by (τ - ν')/τ - 1, and what
/// comes back is added to the nodal values. Any mesh, outline and depth; two transforms of a grid
/// that is coarser than the mesh, so cheap against the operator. Same bits for any number of
/// threads.
class DampedWavePreconditioner final : public krylov::LinearOperator {
 public:
  DampedWavePreconditioner(const mesh::Q8Mesh& mesh, const green::GreenFunction& green,
                           const DampedWaveOptions& options = {});
  ~DampedWavePreconditioner() override;

  Index size() const override { return size_; }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;

  double width() const { return width_; }  ///< B, as found from the outline [m]
  Index grid_points() const;

 private:
  Index size_;
  double width_;
  std::unique_ptr<const PlateGrid> grid_;
  std::unique_ptr<const fmm::EvenSpectrum> spectrum_;
};

}  // namespace floe::bem
