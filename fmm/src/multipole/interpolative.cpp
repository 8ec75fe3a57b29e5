#include "multipole/interpolative.hpp"

#include <floe/numeric/simd.hpp>

#include <Eigen/LU>

#include <cmath>

namespace floe::fmm::multipole {
namespace {

// Takes the direction q out of every column of a; returns the parts taken and the norms² left
FLOE_SIMD_CLONES void take_out(const double* q, double* a, Index rows, Index columns, double* part,
                               double* rest) {
  for (Index j = 0; j < columns; ++j) {
    double* column = a + j * rows;
    double lane[8] = {}, left[8] = {};
    Index i = 0;
    for (; i + 8 <= rows; i += 8)
      for (int l = 0; l < 8; ++l) lane[l] += q[i + l] * column[i + l];
    double sum = 0.0;
    for (; i < rows; ++i) sum += q[i] * column[i];
    for (int l = 0; l < 8; ++l) sum += lane[l];
    for (i = 0; i + 8 <= rows; i += 8)
      for (int l = 0; l < 8; ++l) {
        column[i + l] -= sum * q[i + l];
        left[l] += column[i + l] * column[i + l];
      }
    double norm = 0.0;
    for (; i < rows; ++i) {
      column[i] -= sum * q[i];
      norm += column[i] * column[i];
    }
    for (int l = 0; l < 8; ++l) norm += left[l];
    part[j] = sum;
    rest[j] = norm;
  }
}

}  // namespace

Interpolative interpolative_decomposition(MatXd a, double tolerance) {
  const Index most = std::min(a.rows(), a.cols());
  MatXd triangle(most, a.cols());
  MatXd directions(a.rows(), most);
  VecXd rest = a.colwise().squaredNorm();
  const double stop = tolerance * tolerance * rest.maxCoeff();
  Interpolative result;
  VecXd part(a.cols());
  while (static_cast<Index>(result.columns.size()) < most) {
    const auto rank = static_cast<Index>(result.columns.size());
    Index pivot;
    if (!(rest.maxCoeff(&pivot) > stop) && rank > 0) break;

    // Orthogonalise the pivot once more: the columns have lost what cancelled
    VecXd direction = a.col(pivot);
    const VecXd again = directions.leftCols(rank).transpose() * direction;
    direction -= directions.leftCols(rank) * again;
    const double norm = direction.norm();
    if (!(norm > 0.0)) break;
    directions.col(rank) = direction / norm;
    take_out(directions.col(rank).data(), a.data(), a.rows(), a.cols(), part.data(), rest.data());
    triangle.row(rank) = part;
    for (const Index chosen : result.columns) triangle(rank, chosen) = 0.0;
    for (const Index chosen : result.columns) rest[chosen] = 0.0;
    rest[pivot] = 0.0;
    result.columns.push_back(pivot);
  }

  // Solve for the other columns in terms of the chosen ones
  const auto rank = static_cast<Index>(result.columns.size());
  MatXd chosen(rank, rank);
  for (Index j = 0; j < rank; ++j) chosen.col(j) = triangle.col(result.columns[j]).head(rank);
  result.interpolation = chosen.triangularView<Eigen::Upper>().solve(triangle.topRows(rank));
  return result;
}

}  // namespace floe::fmm::multipole
