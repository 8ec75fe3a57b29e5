#include "plate/element.hpp"
#include "plate/piece_modes.hpp"

#include <floe/numeric/gauss_legendre.hpp>

#include <cmath>

namespace floe::plate {

std::vector<Piece> split_pieces(const mesh::Q8Mesh& mesh) {
  std::vector<Piece> pieces(mesh.piece_count());
  std::vector<Index> local(mesh.node_count()), element_count(pieces.size(), 0);
  for (Index n = 0; n < mesh.node_count(); ++n) {
    std::vector<Index>& node = pieces[mesh.node_piece()[n]].node;
    local[n] = static_cast<Index>(node.size());
    node.push_back(n);
  }
  for (const int p : mesh.element_piece()) ++element_count[p];
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    Piece& piece = pieces[p];
    piece.nodes.resize(2, static_cast<Index>(piece.node.size()));
    for (Index n = 0; n < piece.nodes.cols(); ++n)
      piece.nodes.col(n) = mesh.nodes().col(piece.node[n]);
    piece.elements.resize(8, element_count[p]);
    element_count[p] = 0;
  }
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const int p = mesh.element_piece()[e];
    const Index column = element_count[p]++;
    pieces[p].element.push_back(e);
    for (int a = 0; a < 8; ++a) pieces[p].elements(a, column) = local[mesh.elements()(a, e)];
  }
  return pieces;
}

AreaMoments area_moments(const Piece& piece) {
  // NOTE: with the Gauss points of the mass matrix, so that heave and roll are orthogonal to the
  // last bits on curved elements too; coordinates from the first node, against cancellation far
  // from the origin.
  AreaMoments moments;
  const Point2 origin = piece.nodes.col(0);
  Point2 first = Point2::Zero();
  const numeric::QuadratureRule& rule = numeric::gauss_legendre(3);
  for (Index e = 0; e < piece.elements.cols(); ++e) {
    ElementNodes nodes;
    for (int a = 0; a < 8; ++a) nodes.col(a) = piece.nodes.col(piece.elements(a, e)) - origin;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const ElementPointValues point = evaluate_element(nodes, rule.node[i], rule.node[j]);
        const double weight = rule.weight[i] * rule.weight[j] * point.jacobian;
        moments.area += weight;
        first += weight * (nodes * point.shape);
      }
  }
  moments.centroid = origin + first / moments.area;
  return moments;
}

std::vector<double> region_areas(const Points2& nodes, const mesh::Connectivity& elements,
                                 const PlateRegions& regions) {
  std::vector<double> area(regions.count(), 0.0);
  const numeric::QuadratureRule& rule = numeric::gauss_legendre(3);
  for (Index e = 0; e < elements.cols(); ++e) {
    const ElementNodes corners = nodes(Eigen::all, elements.col(e));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        area[regions.region(e)] += rule.weight[i] * rule.weight[j] *
                                   evaluate_element(corners, rule.node[i], rule.node[j]).jacobian;
  }
  return area;
}

double rotary_inertia(const SparseMatrix& mass, const std::vector<Index>& nodes) {
  double twice = 0.0;
  for (const Index node : nodes)
    for (int unknown = 1; unknown < kUnknownsPerNode; ++unknown)
      for (SparseMatrix::InnerIterator it(mass, kUnknownsPerNode * node + unknown); it; ++it)
        if (it.row() % kUnknownsPerNode == unknown) twice += it.value();
  return 0.5 * twice;
}

MatXd rigid_modes(const Points2& nodes, const Point2& centre, const NodeMass& mass) {
  MatXd modes(mass.size(), 3);
  for (Index n = 0; n < nodes.cols(); ++n) {
    const Point2 p = nodes.col(n) - centre;
    modes.middleRows<3>(3 * n) << 1.0, p.y(), -p.x(),  //
        0.0, 1.0, 0.0,                                 //
        0.0, 0.0, 1.0;
  }
  const MatXd modal_mass = inner_products(modes, mass * modes);
  for (int c = 0; c < 3; ++c) modes.col(c) /= std::sqrt(modal_mass(c, c));
  return modes;
}

}  // namespace floe::plate
