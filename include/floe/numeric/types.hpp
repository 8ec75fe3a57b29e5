#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>

/// Scalar, vector and matrix types that every module shares. SI units and radians inside.
namespace floe {

using Index = Eigen::Index;
using Complex = std::complex<double>;
using VecXd = Eigen::VectorXd;
using VecXcd = Eigen::VectorXcd;
using MatXd = Eigen::MatrixXd;
using MatXcd = Eigen::MatrixXcd;
using Point2 = Eigen::Vector2d;
/// One point a column: 2 × count, rows x and y [m].
using Points2 = Eigen::Matrix2Xd;
/// Compressed columns with 64-bit indices: a plate of a million nodes overflows 32-bit factors.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

}  // namespace floe
