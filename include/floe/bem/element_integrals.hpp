#pragma once

#include <floe/green/green_table.hpp>
#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace floe::bem {

class FarRules;

struct IntegralOptions {
  /// Relative error asked of the integral over one element, 1e-12 … 1e-2. Far below the
  /// discretisation error of the elements themselves.
  double tolerance = 1e-8;
};

/// The integrals of which the operator 𝒢 consists (B.2), paper (14):
///   𝒢_m(x) = ∫_S G(|x - y|) N_m(y) dS_y   [m]
/// for the Q8 function N_m of every node m. Far elements by a tensor Gauss rule whose order follows
/// from the distance and the wavenumber; near elements by recursive subdivision until they are far;
/// elements that hold x by triangles at x with the singularities 1/R and log R transformed away
/// (B.5)–(B.7). Works for curved and stretched elements and any x: node, inside, edge, off the
/// plate.
class ElementIntegrals {
 public:
  /// Keeps a view of the mesh, which must outlive it. Frequency-independent.
  explicit ElementIntegrals(const mesh::Q8Mesh& mesh, const IntegralOptions& options = {});

  /// row[m] = 𝒢_m at node `node`; `row` has one entry a node and is overwritten.
  void node_row(Index node, const green::GreenTable& green, Eigen::Ref<VecXcd> row) const;

  /// The same at any point [m], on the plate or off it.
  void point_row(const Point2& point, const green::GreenTable& green, Eigen::Ref<VecXcd> row) const;

  /// integrals[k][m] = ∫ G N_m dS over elements[k] alone, as seen from node `node`.
  void node_elements(Index node, std::span<const Index> elements, const green::GreenTable& green,
                     std::span<std::array<Complex, 8>> integrals) const;

  /// The frequency-independent integrals ∫ N_m dS against the functions of (F.22), in place of G:
  /// integrals[k][m] = that of 1/R (real part) and log R (imaginary part), integrals[k][8 + m] =
  /// that of R and R² log R; R in metres.
  void node_singular_elements(Index node, std::span<const Index> elements,
                              std::span<std::array<Complex, 16>> integrals) const;

  const mesh::Q8Mesh& mesh() const { return mesh_; }

 private:
  std::vector<mesh::ElementPoint> holders_of(Index node) const;
  void fill_row(const Point2& target, std::span<const mesh::ElementPoint> holders,
                const green::GreenTable& green, Eigen::Ref<VecXcd> row) const;

  const mesh::Q8Mesh& mesh_;  // view
  mesh::PointLocator locator_;
  std::shared_ptr<const FarRules> far_;
  std::vector<std::vector<std::pair<Index, int>>> node_elements_;  // element, local number
};

}  // namespace floe::bem
