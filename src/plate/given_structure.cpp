#include "plate/piece_modes.hpp"

#include <floe/numeric/blas_threads.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/given_structure.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace floe::plate {
namespace {

using Triplets = std::vector<Eigen::Triplet<double, std::int64_t>>;

constexpr double kSymmetry = 1e-9;
constexpr double kRigid = 1e-6;
constexpr double kOrthonormal = 1e-6;
constexpr double kRigidFrequency = 1e-3;     // relative to the first elastic one
constexpr double kSmallestStiffness = 1e-8;  // relative to bending to a constant curvature
constexpr const char* kMotions[] = {"heave", "roll", "pitch"};

double largest_entry(const SparseMatrix& matrix) {
  double largest = 0.0;
  for (Index e = 0; e < matrix.nonZeros(); ++e)
    largest = std::max(largest, std::abs(matrix.valuePtr()[e]));
  return largest;
}

void check_matrix(const mesh::Q8Mesh& mesh, const SparseMatrix& matrix, const char* name) {
  const Index unknowns = kUnknownsPerNode * mesh.node_count();
  FLOE_VALIDATE_AS(MeshError, matrix.rows() == unknowns && matrix.cols() == unknowns,
                   "invalid " << name << " of " << matrix.rows() << " × " << matrix.cols()
                              << " entries (must be " << unknowns << " × " << unknowns
                              << ", three for each of the mesh's " << mesh.node_count()
                              << " nodes)");
  const SparseMatrix transposed = matrix.transpose();
  const double skew = largest_entry(SparseMatrix(matrix - transposed));
  FLOE_VALIDATE_AS(MeshError, skew <= kSymmetry * largest_entry(matrix),
                   "invalid " << name << ": not symmetric, entries differ by up to " << skew
                              << " (must be at most 1e-9 of the largest)");
  const auto& piece = mesh.node_piece();
  for (Index column = 0; column < matrix.cols(); ++column)
    for (SparseMatrix::InnerIterator it(matrix, column); it; ++it)
      FLOE_VALIDATE_AS(
          MeshError, it.value() == 0.0 || piece[it.row() / 3] == piece[column / 3],
          "invalid " << name << ": node " << it.row() / 3 + 1 << " is coupled to node "
                     << column / 3 + 1
                     << " of another piece of the mesh (must be none: each piece floats free)");
}

// The three rigid motions of each piece about its centroid, not normalised, at all nodes
MatXd rigid_motions(const mesh::Q8Mesh& mesh, const std::vector<Piece>& pieces) {
  MatXd motions = MatXd::Zero(kUnknownsPerNode * mesh.node_count(), 3 * std::ssize(pieces));
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Point2 centre = area_moments(pieces[p]).centroid;
    for (const Index n : pieces[p].node) {
      const Point2 at = mesh.nodes().col(n) - centre;
      motions.block<3, 3>(3 * n, 3 * static_cast<Index>(p)) << 1.0, at.y(), -at.x(),  //
          0.0, 1.0, 0.0,                                                              //
          0.0, 0.0, 1.0;
    }
  }
  return motions;
}

// The part of K or M that belongs to a piece, with all 3 × 3 blocks of the nodes that either
// couples
SparseMatrix part_of(const SparseMatrix& matrix, const SparseMatrix& other, const Piece& piece,
                     const std::vector<Index>& local) {
  Triplets entries;
  for (const Index node : piece.node)
    for (Index column = 3 * node; column < 3 * node + 3; ++column) {
      const Index to = 3 * local[node] + column % 3;
      for (SparseMatrix::InnerIterator it(matrix, column); it; ++it)
        entries.emplace_back(3 * local[it.row() / 3] + it.row() % 3, to, it.value());
      for (const SparseMatrix* pattern : {&matrix, &other})
        for (SparseMatrix::InnerIterator it(*pattern, column); it; ++it)
          for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
              entries.emplace_back(3 * local[it.row() / 3] + r, 3 * local[node] + c, 0.0);
    }
  const Index size = 3 * static_cast<Index>(piece.node.size());
  SparseMatrix part(size, size);
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

SparseMatrix symmetric_part(const SparseMatrix& matrix) {
  const SparseMatrix transposed = matrix.transpose();
  return 0.5 * (matrix + transposed);
}

PieceModes modes_of(const Piece& piece, const PlateMatrices& plate, const DryModeOptions& options) {
  PieceModes modes;
  try {
    modes = piece_modes(piece, plate, std::nullopt, options);
  } catch (const ConvergenceError& error) {
    throw MeshError(std::string("invalid plate.structure: ") + error.what() +
                    " (stiffness and mass must be positive but for the rigid motions)");
  }
  const double least = modes.eigenvalue.size() > 0 ? modes.eigenvalue.minCoeff() : 1.0;
  FLOE_VALIDATE_AS(
      MeshError, modes.eigenvalue.size() == 0 || least > kSmallestStiffness * modes.bent_eigenvalue,
      "invalid plate.structure.stiffness: a motion besides the rigid ones has omega² = "
          << least << " rad²/s² (must be positive: exactly three rigid modes a piece)");
  return modes;
}

// By rising frequency
GivenModes sorted(const GivenModes& given) {
  std::vector<Index> order(given.omega.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return given.omega[a] < given.omega[b]; });
  return {given.omega(order), given.shape(Eigen::all, order), given.mass};
}

void require_rigid_frequencies(const VecXd& omega, Index rigid_count) {
  if (omega.size() == rigid_count) return;
  FLOE_VALIDATE_AS(MeshError, omega[rigid_count - 1] <= kRigidFrequency * omega[rigid_count],
                   "invalid plate.structure.omega: the first "
                       << rigid_count << " rise to " << omega[rigid_count - 1]
                       << " rad/s, the next is " << omega[rigid_count]
                       << " (must be three rigid modes a piece, near 0, then elastic ones)");
}

// The mass of heave, roll and pitch: by M, or by the rigid modes. These are R A, and AᵀM A = I
MatXd mass_of_motions(const GivenModes& modes, const MatXd& motions) {
  const MatXd rigid = modes.shape.leftCols(motions.cols());
  const MatXd gram = motions.transpose() * motions;
  const MatXd factor = gram.ldlt().solve(motions.transpose() * rigid);
  const double rest = (rigid - motions * factor).cwiseAbs().maxCoeff();
  const Eigen::FullPivLU<MatXd> lu(factor);
  FLOE_VALIDATE_AS(MeshError, rest <= kRigid * rigid.cwiseAbs().maxCoeff() && lu.isInvertible(),
                   "invalid plate.structure.modes: the first "
                       << motions.cols() << " differ from rigid motions by " << rest
                       << " (must be three rigid modes a piece, w, θx, θy node by node in the "
                          "order of the mesh's nodes)");
  if (modes.mass.size() > 0) return motions.transpose() * (modes.mass * motions);
  const MatXd inverse = lu.inverse();
  return inverse.transpose() * inverse;
}

}  // namespace

void check_matrices(const mesh::Q8Mesh& mesh, const PlateMatrices& given) {
  check_matrix(mesh, given.stiffness, "plate.structure.stiffness");
  check_matrix(mesh, given.mass, "plate.structure.mass");
  for (Index n = 0; n < mesh.node_count(); ++n)
    FLOE_VALIDATE_AS(MeshError, given.mass.coeff(3 * n, 3 * n) > 0.0,
                     "invalid plate.structure.mass: that of the deflection of node "
                         << n + 1 << " is " << given.mass.coeff(3 * n, 3 * n)
                         << " kg (must be positive)");
  const MatXd motions = rigid_motions(mesh, split_pieces(mesh));
  const MatXd force = given.stiffness * motions;
  const MatXd scale = SparseMatrix(given.stiffness.cwiseAbs()) * motions.cwiseAbs();
  for (Index c = 0; c < motions.cols(); ++c) {
    const double whole = scale.col(c).maxCoeff();
    const double share = whole > 0.0 ? force.col(c).cwiseAbs().maxCoeff() / whole : 0.0;
    FLOE_VALIDATE_AS(MeshError, share <= kRigid,
                     "invalid plate.structure.stiffness: it resists the "
                         << kMotions[c % 3] << " of piece " << c / 3 + 1 << " with " << share
                         << " of its entries (must be below 1e-6: a free plate, unknowns w, θx, θy "
                            "node by node in the order of the mesh's nodes)");
  }
}

DryModes dry_modes(const mesh::Q8Mesh& mesh, const PlateMatrices& given,
                   const DryModeOptions& options) {
  check_mode_count(mesh, options.count);
  check_matrices(mesh, given);
  numeric::use_one_blas_thread();
  const SparseMatrix stiffness = symmetric_part(given.stiffness), mass = symmetric_part(given.mass);
  const Index elastic_count = options.count - 3 * mesh.piece_count();
  const std::vector<Piece> pieces = split_pieces(mesh);
  DryModeOptions elastic = options;
  elastic.count = static_cast<int>(elastic_count);
  std::vector<PieceModes> modes;
  std::vector<Index> local(mesh.node_count());
  for (const Piece& piece : pieces) {
    for (std::size_t n = 0; n < piece.node.size(); ++n)
      local[piece.node[n]] = static_cast<Index>(n);
    modes.push_back(modes_of(
        piece, {part_of(stiffness, mass, piece, local), part_of(mass, stiffness, piece, local)},
        elastic));
  }
  return join_modes(mesh, pieces, modes, elastic_count);
}

void check_modes(const mesh::Q8Mesh& mesh, const GivenModes& given) {
  const Index unknowns = kUnknownsPerNode * mesh.node_count(), least = 3 * mesh.piece_count();
  FLOE_VALIDATE_AS(MeshError, given.shape.rows() == unknowns,
                   "invalid plate.structure.modes of "
                       << given.shape.rows() << " rows (must be " << unknowns
                       << ", three for each of the mesh's " << mesh.node_count() << " nodes)");
  FLOE_VALIDATE_AS(MeshError, given.shape.cols() == given.omega.size(),
                   "invalid plate.structure.omega of "
                       << given.omega.size() << " frequencies (must be " << given.shape.cols()
                       << ", one a mode)");
  FLOE_VALIDATE_AS(MeshError, given.shape.cols() >= least,
                   "invalid plate.structure.modes of " << given.shape.cols()
                                                       << " columns (must be at least " << least
                                                       << ", three rigid modes a piece)");
  FLOE_VALIDATE_AS(
      MeshError, given.omega.minCoeff() >= 0.0,
      "invalid plate.structure.omega = " << given.omega.minCoeff() << " rad/s (must be 0 or more)");
  if (given.mass.size() == 0) return;
  check_matrix(mesh, given.mass, "plate.structure.mass");
  const MatXd gram = given.shape.transpose() * (given.mass * given.shape);
  Index i = 0, j = 0;
  const double error =
      (gram - MatXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(&i, &j);
  FLOE_VALIDATE_AS(MeshError, error <= kOrthonormal,
                   "invalid plate.structure.modes: the mass of modes "
                       << i + 1 << " and " << j + 1 << " is " << gram(i, j) << " (must be "
                       << (i == j ? 1 : 0) << " to 1e-6: mass-normalised and orthogonal)");
}

DryModes dry_modes(const mesh::Q8Mesh& mesh, const GivenModes& given, int count) {
  check_modes(mesh, given);
  const Index rigid_count = 3 * mesh.piece_count();
  FLOE_VALIDATE(count >= rigid_count && count <= given.omega.size(),
                "invalid modes.count = " << count << " (must be from " << rigid_count
                                         << ", three a plate, to the " << given.omega.size()
                                         << " of plate.structure.modes)");
  const GivenModes modes = sorted(given);
  require_rigid_frequencies(modes.omega, rigid_count);

  // Put heave, roll and pitch in the place of the rigid ones
  const std::vector<Piece> pieces = split_pieces(mesh);
  const MatXd motions = rigid_motions(mesh, pieces);
  const MatXd mass = mass_of_motions(modes, motions);
  const VecXd norm = mass.diagonal().cwiseSqrt();
  DryModes result;
  result.rigid_count = static_cast<int>(rigid_count);
  result.omega = modes.omega.head(count);
  result.omega.head(rigid_count).setZero();
  result.shape = modes.shape.leftCols(count);
  result.shape.leftCols(rigid_count) = motions * norm.cwiseInverse().asDiagonal();
  result.modal_mass = MatXd::Identity(count, count);
  result.rotary_inertia = VecXd::Zero(std::ssize(pieces));
  if (given.mass.size() > 0)
    for (std::size_t p = 0; p < pieces.size(); ++p)
      result.rotary_inertia[static_cast<Index>(p)] = rotary_inertia(given.mass, pieces[p].node);
  for (Index p = 0; p < rigid_count; p += 3)
    result.modal_mass.block<3, 3>(p, p) =
        mass.block<3, 3>(p, p).cwiseQuotient(norm.segment<3>(p) * norm.segment<3>(p).transpose());
  for (Index c = rigid_count; c < count; ++c) result.shape.col(c) *= shape_sign(modes.shape.col(c));
  if (given.mass.size() > 0)
    result.orthonormality_error =
        (result.shape.transpose() * (given.mass * result.shape) - result.modal_mass)
            .cwiseAbs()
            .maxCoeff();
  return result;
}

}  // namespace floe::plate
