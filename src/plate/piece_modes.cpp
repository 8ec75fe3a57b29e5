#include "plate/piece_modes.hpp"

#include "plate/assembly.hpp"
#include "plate/elastic_modes.hpp"

#include <floe/numeric/error.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace floe::plate {
namespace {

class Stopwatch final {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

MatXd orthonormal_basis(const MatXd& columns, const MatXd& modal_mass) {
  MatXd inverse = MatXd::Identity(columns.cols(), columns.cols());
  modal_mass.llt().matrixU().solveInPlace(inverse);
  return columns * inverse;
}

// Twice the strain energy of the constant curvatures a, b, c of w = (a x² + 2b xy + c y²)/2,
// without shear, in closed form: a distorted mesh would make it too large
Eigen::Matrix3d constant_curvature_energy(const Piece& piece, const PlateRegions& regions) {
  Eigen::Matrix3d energy = Eigen::Matrix3d::Zero();
  const std::vector<double> area = region_areas(piece.nodes, piece.elements, regions);
  for (int region = 0; region < regions.count(); ++region) {
    const double nu = regions[region].poisson_ratio;
    Eigen::Matrix3d strain;
    strain << 1.0, 0.0, nu, 0.0, 2.0 * (1.0 - nu), 0.0, nu, 0.0, 1.0;
    energy += regions[region].bending_rigidity() * area[region] * strain;
  }
  return energy;
}

// A Rayleigh quotient near the first elastic eigenvalue: the smallest over the deflections of
// constant curvature with rotations that leave no shear, the kinetic energy from M with the rigid
// part taken out
double estimate_first_eigenvalue(const Piece& piece, const AreaMoments& area,
                                 const PlateMatrices& plate,
                                 const std::optional<Eigen::Matrix3d>& energy, const NodeMass& mass,
                                 const MatXd& rigid_basis) {
  MatXd bent(mass.size(), 3);
  for (Index n = 0; n < piece.nodes.cols(); ++n) {
    const double x = piece.nodes(0, n) - area.centroid.x();
    const double y = piece.nodes(1, n) - area.centroid.y();
    bent.middleRows<3>(3 * n) << 0.5 * x * x, x * y, 0.5 * y * y,  //
        0.0, x, y,                                                 //
        -x, -y, 0.0;
  }
  subtract_combination(rigid_basis, inner_products(rigid_basis, mass * bent), bent);
  const MatXd kinetic = inner_products(bent, mass * bent);
  const MatXd strain =
      energy ? MatXd(*energy) : inner_products(bent, multiply_symmetric(plate.stiffness, bent));
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatXd> ritz(strain, kinetic,
                                                             Eigen::EigenvaluesOnly);
  return ritz.eigenvalues()[0];
}

// The residual to expect of a converged mode, which bounds the relative error of its eigenvalue: a
// millionth, as results are good to (the iteration is asked for less, but modes of later searches
// have the errors of the earlier ones in them), or what rounding in K leaves
double expected_residual(const ElasticProblem& problem, double eigenvalue, double tolerance) {
  double largest = 0.0;  // of K over M, deflections
  for (Index n = 0; n < problem.mass.size(); n += kUnknownsPerNode)
    largest =
        std::max(largest, problem.plate.stiffness.coeff(n, n) / problem.plate.mass.coeff(n, n));
  return 1e4 * tolerance +
         1e2 * std::numeric_limits<double>::epsilon() * largest / (eigenvalue + problem.shift);
}

// Largest |CᵀMC - what it should be| over rigid and elastic modes
double orthonormality_error(const NodeMass& mass, const PieceModes& modes) {
  MatXd all(modes.rigid.rows(), modes.rigid.cols() + modes.elastic.cols());
  all << modes.rigid, modes.elastic;
  MatXd expected = MatXd::Identity(all.cols(), all.cols());
  expected.topLeftCorner<3, 3>() = modes.modal_mass;
  return (inner_products(all, mass * all) - expected).cwiseAbs().maxCoeff();
}

// Largest |Kc| over the largest |K||c|: what a rigid motion meets, zero but for rounding
double rigid_force_error(const SparseMatrix& stiffness, const MatXd& rigid) {
  Eigen::Array3d force = Eigen::Array3d::Zero(), scale = Eigen::Array3d::Zero();
  for (Index column = 0; column < stiffness.outerSize(); ++column) {
    Eigen::Array3d sum = Eigen::Array3d::Zero(), size = Eigen::Array3d::Zero();
    for (SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry) {
      const Eigen::Array3d term = entry.value() * rigid.row(entry.row()).transpose().array();
      sum += term;
      size += term.abs();
    }
    force = force.max(sum.abs());
    scale = scale.max(size);
  }
  return (force / scale).maxCoeff();
}

bool is_small(Index unknowns, Index elastic_count) {
  return unknowns <= 600 || (unknowns <= 3000 && 10 * elastic_count > unknowns);
}

}  // namespace

PieceModes piece_modes(const Piece& piece, const PlateRegions& regions,
                       const DryModeOptions& options) {
  Stopwatch watch;
  const PlateMatrices plate = assemble(piece.nodes, piece.elements, regions);
  const double seconds = watch.lap();
  PieceModes modes = piece_modes(piece, plate, constant_curvature_energy(piece, regions), options);
  modes.report.assembly_seconds += seconds;
  return modes;
}

PieceModes piece_modes(const Piece& piece, const PlateMatrices& plate,
                       const std::optional<Eigen::Matrix3d>& curvature_energy,
                       const DryModeOptions& options) {
  PieceModes modes;
  Stopwatch watch;
  const NodeMass mass(plate.mass);
  modes.report.assembly_seconds = watch.lap();

  // Make the rigid modes
  const AreaMoments area = area_moments(piece);
  modes.rigid = rigid_modes(piece.nodes, area.centroid, mass);
  modes.modal_mass = inner_products(modes.rigid, mass * modes.rigid);
  std::vector<Index> nodes(piece.node.size());
  std::iota(nodes.begin(), nodes.end(), Index{0});
  modes.rotary_inertia = rotary_inertia(plate.mass, nodes);
  const MatXd rigid_basis = orthonormal_basis(modes.rigid, modes.modal_mass);
  const Index elastic_count = std::min<Index>(options.count, mass.size() - rigid_basis.cols());
  if (elastic_count == 0) {
    modes.elastic.resize(mass.size(), 0);
    modes.rigid_force_error = rigid_force_error(plate.stiffness, modes.rigid);
    return modes;
  }
  const double shift =
      estimate_first_eigenvalue(piece, area, plate, curvature_energy, mass, rigid_basis);
  modes.bent_eigenvalue = shift;

  // Find the elastic ones
  Eigenpairs pairs;
  if (is_small(mass.size(), elastic_count)) {
    pairs = dense_elastic_modes(plate, shift, rigid_basis, elastic_count);
    modes.report.iteration_seconds = watch.lap();
  } else {
    const ShiftedFactor factor(plate, shift);
    modes.report.factor_entries = factor.entry_count();
    modes.report.factor_seconds = watch.lap();
    const ElasticProblem problem{plate, mass, factor, shift, rigid_basis};
    pairs = elastic_modes(problem, {.count = static_cast<int>(elastic_count),
                                    .tolerance = options.tolerance,
                                    .max_restarts = options.max_restarts});

    // Verify each
    const VecXd residual = inverse_residuals(problem, pairs);
    modes.report.solve_count = pairs.solve_count + residual.size();
    modes.report.largest_residual = residual.maxCoeff();
    for (Index i = 0; i < residual.size(); ++i)
      FLOE_VALIDATE_AS(ConvergenceError,
                       residual[i] <= expected_residual(problem, pairs.value[i], options.tolerance),
                       "dry modes converged = " << i << " of " << elastic_count
                                                << " elastic modes (the next has residual "
                                                << residual[i] << ")");
    modes.report.iteration_seconds = watch.lap();
  }
  modes.eigenvalue = std::move(pairs.value);
  modes.elastic = std::move(pairs.vector);
  modes.orthonormality_error = orthonormality_error(mass, modes);
  modes.rigid_force_error = rigid_force_error(plate.stiffness, modes.rigid);
  return modes;
}

}  // namespace floe::plate
