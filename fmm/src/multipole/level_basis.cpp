#include "multipole/level_basis.hpp"

#include "multipole/interpolative.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>
#include <numbers>

namespace floe::fmm::multipole {
namespace {

constexpr int kMostNodes = 28;  // Chebyshev nodes a side; above, the children are used
constexpr double kMeanFloor =
    1e-3;  // under the mean square of the skeleton's charges, a share of it
constexpr double kSkeletonShare = 0.05;  // of the loss, for the choice of the skeleton

// Chebyshev nodes a side that interpolate G(|x - y|) in y: analytic up to one width outside the
// box, ellipse ρ = 3 + √8, and waves of wavenumber k
int node_count(double tolerance, double waves) {
  return 4 + static_cast<int>(std::ceil(-std::log(tolerance) / std::log(5.83) + 0.55 * waves));
}

VecXd chebyshev_nodes(int count, double width) {
  VecXd node(count);
  for (int i = 0; i < count; ++i)
    node[i] = 0.5 * width * std::cos(std::numbers::pi * (i + 0.5) / count);
  return node;
}

// Lagrange polynomials of the Chebyshev nodes at x, barycentric
VecXd lagrange(int count, double width, double x) {
  const VecXd node = chebyshev_nodes(count, width);
  VecXd value(count);
  for (int i = 0; i < count; ++i) {
    if (x == node[i]) return VecXd::Unit(count, i);
    value[i] =
        (i % 2 == 0 ? 1.0 : -1.0) * std::sin(std::numbers::pi * (i + 0.5) / count) / (x - node[i]);
  }
  return value / value.sum();
}

Points2 tensor_points(const VecXd& node) {
  Points2 points(2, node.size() * node.size());
  for (Index j = 0; j < node.size(); ++j)
    for (Index i = 0; i < node.size(); ++i)
      points.col(j * node.size() + i) = Point2(node[i], node[j]);
  return points;
}

Points2 even_points(Index count, double width) {
  VecXd node(count);
  for (Index i = 0; i < count; ++i)
    node[i] = width * ((static_cast<double>(i) + 0.5) / static_cast<double>(count) - 0.5);
  return tensor_points(node);
}

// Points on the edge of a square, turned on by a share of their spacing
Points2 ring(double half, Index count, double shift) {
  Points2 points(2, count);
  for (Index i = 0; i < count; ++i) {
    const double along = 4.0 * (static_cast<double>(i) + shift) / static_cast<double>(count);
    const double s = 2.0 * (along - std::floor(along)) - 1.0;
    const int side = static_cast<int>(along) % 4;
    const Point2 p = side % 2 == 0 ? Point2(s, -1.0) : Point2(1.0, s);
    points.col(i) = half * (side < 2 ? p : Point2(-p));
  }
  return points;
}

// Fields on rings around the box, from just outside its neighbours to `reach`, of charges at the
// candidates: Re G and Im G as rows, each ring scaled to a mean square of 1
MatXd far_fields(const RadialKernel& kernel, const Points2& candidates, double width, double reach,
                 double tolerance) {
  const double waves = kernel.wave().wavenumber * width;
  const auto count = static_cast<Index>(24.0 - 4.0 * std::log10(tolerance) + 2.2 * waves);
  std::vector<double> half;
  for (double h = 1.5, step = 1.12; half.size() < 4 || h * width < reach; h *= step, step *= 1.2)
    half.push_back(h * width);
  MatXd fields(2 * count * static_cast<Index>(half.size()), candidates.cols());
  for (std::size_t r = 0; r < half.size(); ++r) {
    const double shift = std::fmod(static_cast<double>(r) * 0.618033988749895, 1.0);
    const MatXcd field = kernel_matrix(kernel, ring(half[r], count, shift), candidates);
    const double scale = std::sqrt(static_cast<double>(field.cols())) / field.norm() /
                         std::sqrt(static_cast<double>(half.size()));
    const Index row = 2 * count * static_cast<Index>(r);
    fields.middleRows(row, count) = scale * field.real();
    fields.middleRows(row + count, count) = scale * field.imag();
  }
  return fields;
}

Points2 children_skeletons(const LevelBasis& child) {
  Points2 points(2, 4 * child.skeleton.cols());
  for (int c = 0; c < 4; ++c)
    points.middleCols(c * child.skeleton.cols(), child.skeleton.cols()) =
        child.skeleton.colwise() + child_centre(c, 2.0 * child.width);
  return points;
}

// Directions of the skeleton's charges that the far field loses least by, for one charge anywhere
// in the box: with the mean C Cᵀ of t tᵀ, the leading right singular vectors of A C   (F.12)
void compress(LevelBasis& basis, const MatXd& weights, const MatXd& fields, double tolerance) {
  MatXd mean = weights * weights.transpose() / static_cast<double>(weights.cols());
  // NOTE: moments that come up from the children have lost what their far field does not see, so
  // they stray from the mean a little; a floor under it keeps what they stray by from growing
  mean.diagonal().array() += kMeanFloor * mean.trace() / static_cast<double>(mean.rows());
  const Eigen::LLT<MatXd> cholesky(mean);
  const MatXd c = cholesky.matrixL();
  const Eigen::HouseholderQR<MatXd> qr(fields * c);
  const MatXd triangle =
      qr.matrixQR().topRows(c.cols()).triangularView<Eigen::Upper>().toDenseMatrix();
  const Eigen::BDCSVD<MatXd> svd(triangle, Eigen::ComputeThinV);
  const VecXd& sigma = svd.singularValues();
  Index rank = sigma.size();
  double tail = 0.0;
  while (rank > 1) {
    tail += sigma[rank - 1] * sigma[rank - 1];
    if (tail > tolerance * tolerance * sigma.squaredNorm()) break;
    --rank;
  }
  const MatXd v = svd.matrixV().leftCols(rank);
  basis.expand = c * v;
  basis.restrict = c.triangularView<Eigen::Lower>().transpose().solve(v).transpose();
}

}  // namespace

Point2 child_centre(int child, double width) {
  return 0.25 * width * Point2(child % 2 == 0 ? -1.0 : 1.0, child / 2 == 0 ? -1.0 : 1.0);
}

MatXcd kernel_matrix(const RadialKernel& kernel, const Points2& x, const Points2& y) {
  MatXcd result(x.cols(), y.cols());
  MatXd distance(x.cols(), y.cols());
  for (Index j = 0; j < y.cols(); ++j)
    distance.col(j) = (x.colwise() - y.col(j)).colwise().norm().transpose();
  const double some = std::max(distance.maxCoeff(), 1e-300);
  const auto coincident = (distance.array() == 0.0).eval();
  distance = coincident.select(some, distance);
  const auto size = static_cast<std::size_t>(distance.size());
  kernel.evaluate({distance.data(), size}, {result.data(), size});
  return coincident.select(kernel.wave().coefficient, result.array()).matrix();
}

Bases make_bases(const RadialKernel& kernel, double width, int levels, double reach,
                 double tolerance) {
  const double k = kernel.wave().wavenumber;
  while (node_count(tolerance, k * std::ldexp(width, 1 - levels)) > kMostNodes) ++levels;
  Bases bases(levels);
  for (int level = levels - 1; level >= 0; --level) {
    LevelBasis& basis = bases[level];
    basis.width = std::ldexp(width, -level);
    const int nodes = node_count(tolerance, k * basis.width);
    basis.nodes = nodes <= kMostNodes ? nodes : 0;

    // Choose the skeleton among nodes or the children's skeletons
    const Points2 candidates = basis.nodes > 0 ? tensor_points(chebyshev_nodes(nodes, basis.width))
                                               : children_skeletons(bases[level + 1]);
    const MatXd fields = far_fields(kernel, candidates, basis.width, reach, tolerance);
    Interpolative chosen = interpolative_decomposition(fields, kSkeletonShare * tolerance);
    const auto rank = static_cast<Index>(chosen.columns.size());
    basis.skeleton.resize(2, rank);
    MatXd skeleton_fields(fields.rows(), rank);
    for (Index s = 0; s < rank; ++s) {
      basis.skeleton.col(s) = candidates.col(chosen.columns[s]);
      skeleton_fields.col(s) = fields.col(chosen.columns[s]);
    }
    basis.from_candidates = std::move(chosen.interpolation);

    // Keep the directions that the far field sees
    const auto side = static_cast<Index>(std::ceil(2.0 * std::sqrt(static_cast<double>(rank)))) + 2;
    compress(basis, skeleton_weights(bases, level, even_points(side, basis.width)), skeleton_fields,
             tolerance);
  }
  return bases;
}

MatXd skeleton_weights(const Bases& bases, std::size_t level, const Points2& points) {
  const LevelBasis& basis = bases[level];
  const Index nodes = basis.nodes;
  if (nodes > 0) {
    MatXd polynomials(nodes * nodes, points.cols());
    for (Index i = 0; i < points.cols(); ++i) {
      const VecXd along_x = lagrange(basis.nodes, basis.width, points(0, i));
      const VecXd along_y = lagrange(basis.nodes, basis.width, points(1, i));
      for (Index j = 0; j < nodes; ++j)
        polynomials.col(i).segment(j * nodes, nodes) = along_y[j] * along_x;
    }
    return basis.from_candidates * polynomials;
  }

  // Hand each point to the child that it lies in
  MatXd result(basis.skeleton.cols(), points.cols());
  const Index block = basis.from_candidates.cols() / 4;
  for (int child = 0; child < 4; ++child) {
    std::vector<Index> inside;
    for (Index i = 0; i < points.cols(); ++i)
      if ((points(0, i) >= 0.0 ? 1 : 0) + (points(1, i) >= 0.0 ? 2 : 0) == child)
        inside.push_back(i);
    if (inside.empty()) continue;
    Points2 there(2, inside.size());
    for (std::size_t i = 0; i < inside.size(); ++i)
      there.col(i) = points.col(inside[i]) - child_centre(child, basis.width);
    const MatXd weights = basis.from_candidates.middleCols(child * block, block) *
                          skeleton_weights(bases, level + 1, there);
    for (std::size_t i = 0; i < inside.size(); ++i) result.col(inside[i]) = weights.col(i);
  }
  return result;
}

}  // namespace floe::fmm::multipole
