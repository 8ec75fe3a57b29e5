#include "plate/frequency_error.hpp"
#include "plate/piece_modes.hpp"

#include <floe/numeric/blas_threads.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/dry_modes.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace floe::plate {
namespace {

struct ElasticMode {
  double eigenvalue;
  int piece;
  Index column;
};

// The lowest `count` elastic modes over all pieces
std::vector<ElasticMode> choose_elastic(const std::vector<PieceModes>& pieces, Index count) {
  std::vector<ElasticMode> all;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (Index c = 0; c < pieces[p].eigenvalue.size(); ++c)
      all.push_back({pieces[p].eigenvalue[c], static_cast<int>(p), c});
  std::stable_sort(all.begin(), all.end(), [](const ElasticMode& a, const ElasticMode& b) {
    return a.eigenvalue < b.eigenvalue;
  });
  all.resize(std::min<std::size_t>(all.size(), count));
  return all;
}

void place(const Piece& piece, const Eigen::Ref<const VecXd>& local, Eigen::Ref<VecXd> global) {
  for (std::size_t n = 0; n < piece.node.size(); ++n)
    global.segment<3>(3 * piece.node[n]) = local.segment<3>(3 * static_cast<Index>(n));
}

void add(const DryModeReport& part, DryModeReport& whole) {
  whole.assembly_seconds += part.assembly_seconds;
  whole.factor_seconds += part.factor_seconds;
  whole.iteration_seconds += part.iteration_seconds;
  whole.factor_entries = std::max(whole.factor_entries, part.factor_entries);
  whole.solve_count += part.solve_count;
  whole.largest_residual = std::max(whole.largest_residual, part.largest_residual);
}

}  // namespace

double shape_sign(const Eigen::Ref<const VecXd>& shape) {
  double largest = 0.0;
  for (Index i = 0; i < shape.size(); i += 3) largest = std::max(largest, std::abs(shape[i]));
  for (Index i = 0; i < shape.size(); i += 3)
    if (std::abs(shape[i]) >= (1.0 - 1e-6) * largest) return shape[i] < 0.0 ? -1.0 : 1.0;
  return 1.0;
}

void check_mode_count(const mesh::Q8Mesh& mesh, int count) {
  const int rigid_count = 3 * mesh.piece_count();
  const Index unknowns = kUnknownsPerNode * mesh.node_count();
  FLOE_VALIDATE(count >= rigid_count && 2 * count <= unknowns,
                "invalid mode count = " << count << " (must be from " << rigid_count
                                        << ", three a plate, to half the " << unknowns
                                        << " unknowns)");
}

DryModes join_modes(const mesh::Q8Mesh& mesh, const std::vector<Piece>& pieces,
                    const std::vector<PieceModes>& modes, Index elastic_count) {
  const std::vector<ElasticMode> chosen = choose_elastic(modes, elastic_count);
  const Index unknowns = kUnknownsPerNode * mesh.node_count();
  DryModes result;
  result.rigid_count = 3 * mesh.piece_count();
  const Index count = result.rigid_count + elastic_count;
  result.omega = VecXd::Zero(count);
  result.shape = MatXd::Zero(unknowns, count);
  result.modal_mass = MatXd::Identity(count, count);
  result.rotary_inertia = VecXd::Zero(std::ssize(pieces));
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (int c = 0; c < 3; ++c)
      place(pieces[p], modes[p].rigid.col(c), result.shape.col(3 * p + c));
    result.modal_mass.block<3, 3>(3 * p, 3 * p) = modes[p].modal_mass;
    result.rotary_inertia[static_cast<Index>(p)] = modes[p].rotary_inertia;
    add(modes[p].report, result.report);
    result.orthonormality_error =
        std::max(result.orthonormality_error, modes[p].orthonormality_error);
    result.rigid_force_error = std::max(result.rigid_force_error, modes[p].rigid_force_error);
  }
  for (Index i = 0; i < elastic_count; ++i) {
    const ElasticMode& mode = chosen[i];
    const Index column = result.rigid_count + i;
    result.omega[column] = std::sqrt(mode.eigenvalue);
    place(pieces[mode.piece], modes[mode.piece].elastic.col(mode.column), result.shape.col(column));
    result.shape.col(column) *= shape_sign(result.shape.col(column));
  }
  FLOE_VALIDATE_AS(ConvergenceError, result.omega.allFinite() && result.shape.allFinite(),
                   "invalid dry modes: not finite (are thickness, stiffness and density of the "
                   "plate in SI units?)");
  return result;
}

DryModes dry_modes(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                   const DryModeOptions& options) {
  check_mode_count(mesh, options.count);
  numeric::use_one_blas_thread();
  const Index elastic_count = options.count - 3 * mesh.piece_count();
  const std::vector<Piece> pieces = split_pieces(mesh);
  DryModeOptions elastic = options;
  elastic.count = static_cast<int>(elastic_count);
  std::vector<PieceModes> modes;
  for (const Piece& piece : pieces)
    modes.push_back(piece_modes(piece, regions.at(piece.element), elastic));
  DryModes result = join_modes(mesh, pieces, modes, elastic_count);
  result.estimated_frequency_error =
      estimate_frequency_errors(mesh, regions, result.omega, result.shape).maxCoeff();
  return result;
}

}  // namespace floe::plate
