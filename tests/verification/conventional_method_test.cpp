#include <floe/coupling/modal_equation.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/section_forces.hpp>
#include <floe/response/pseudo_excitation.hpp>
#include <floe/wave/spectrum.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <rigid_plate.hpp>

#include <cmath>
#include <numeric>
#include <vector>

// The pseudo-excitation method against the conventional one, paper (29a), which is kept here only:
// the matrix of the spectra of all nodal wave loads, and the dense transfer matrix from them to all
// displacements and section forces.
namespace floe {
namespace {

constexpr double kOmega = 0.9;

struct SmallPlate {
  mesh::Q8Mesh mesh = mesh::make_rectangle({.length = 60.0, .width = 20.0, .nx = 6, .ny = 2});
  plate::PlateProperties properties{
      .thickness = 1.0, .youngs_modulus = 1.0e10, .poisson_ratio = 0.2, .density = 300.0};
  plate::DryModes modes = plate::dry_modes(mesh, properties, {.count = 9});
  wave::Water water{.depth = 15.0};
  test::SolvedPlate plate{mesh, kOmega, water};
  hydro::Radiation radiation = hydro::solve_radiation(
      plate.pressure_operator, modes.shape(Eigen::seq(0, Eigen::last, 3), Eigen::all),
      plate.surface_mass, kOmega, water, 1e-10);
  response::DirectionGrid grid =
      response::direction_grid(wave::Spreading::cosine_power(2.0), 0.4, 36);
  double density = wave::Spectrum::bretschneider(2.0, 7.0)(kOmega);
  MatXcd loads = hydro::wave_loads(mesh, plate.wavenumber, grid.heading);  // N × headings

  MatXcd amplitudes(const MatXcd& wave_loads) const {
    return coupling::modal_amplitudes(modes, 0.0, kOmega, radiation.fluid_matrix,
                                      hydro::exciting_forces(radiation.pressure, wave_loads));
  }
  // Displacements and, below them, section forces of the modes
  MatXd shape() const {
    std::vector<Index> nodes(static_cast<std::size_t>(mesh.node_count()));
    std::iota(nodes.begin(), nodes.end(), Index{0});
    const MatXd forces = plate::section_force_operator(mesh, properties, nodes) * modes.shape;
    MatXd all(modes.shape.rows() + forces.rows(), modes.count());
    all << modes.shape, forces;
    return all;
  }
  // From the load of every node to all displacements and section forces
  MatXcd transfer() const {
    return shape().cast<Complex>() *
           amplitudes(MatXcd::Identity(mesh.node_count(), mesh.node_count()));
  }
  // Spectra of the loads of all pairs of nodes, N × N
  MatXcd load_spectra() const {
    MatXcd spectra = MatXcd::Zero(loads.rows(), loads.rows());
    for (Index b = 0; b < loads.cols(); ++b)
      spectra += density * grid.weight[static_cast<std::size_t>(b)] * loads.col(b).conjugate() *
                 loads.col(b).transpose();
    return spectra;
  }
  MatXcd pseudo() const {
    return response::pseudo_amplitudes(amplitudes(loads), density, grid.weight);
  }
};

const SmallPlate& small_plate() {
  static const SmallPlate plate;
  return plate;
}

// Largest difference of two Hermitian matrices, each entry relative to its row's and column's scale
double scaled_difference(const MatXcd& own, const MatXcd& expected) {
  const VecXd scale = expected.diagonal().real().cwiseSqrt();
  const double least = 1e-9 * scale.maxCoeff();
  double worst = 0.0;
  for (Index i = 0; i < scale.size(); ++i)
    for (Index j = 0; j < scale.size(); ++j)
      worst = std::max(worst, std::abs(own(i, j) - expected(i, j)) /
                                  (std::max(scale[i], least) * std::max(scale[j], least)));
  return worst;
}

TEST(twin_ConventionalMethod, IsMetForAllPairsOfDisplacementsAndOfSectionForces) {
  const SmallPlate& plate = small_plate();
  const MatXcd transfer = plate.transfer();
  const MatXcd expected = transfer.conjugate() * plate.load_spectra() * transfer.transpose();
  response::PseudoExcitation response(plate.shape());
  response.add(kOmega, 1.0, plate.pseudo());
  const MatXcd shape = plate.shape().cast<Complex>();
  const MatXcd own = shape * response.modal_covariance(0) * shape.transpose();
  const Index motions = 3 * plate.mesh.node_count(), forces = own.rows() - motions;
  EXPECT_LE(scaled_difference(own.topLeftCorner(motions, motions),
                              expected.topLeftCorner(motions, motions)),
            1e-10);
  // Only the moments and forces whose deviation is not zero by a free edge's conditions
  EXPECT_LE((own.bottomRightCorner(forces, forces) - expected.bottomRightCorner(forces, forces))
                .cwiseAbs()
                .maxCoeff(),
            1e-10 * expected.bottomRightCorner(forces, forces).cwiseAbs().maxCoeff());
  EXPECT_LE((response.spectra().col(0) - expected.diagonal().real()).norm(),
            1e-10 * expected.diagonal().norm());
}

TEST(identity_ConventionalMethod, OneHeadingGivesTheSquaredTransferFunctionOfMoments) {
  const SmallPlate& plate = small_plate();
  const MatXcd one = plate.amplitudes(plate.loads.leftCols(1));
  response::PseudoExcitation response(plate.shape());
  response.add(kOmega, 0.1, response::pseudo_amplitudes(one, plate.density, {1.0}));
  const VecXd squared = plate.density * (plate.shape().cast<Complex>() * one).cwiseAbs2();
  EXPECT_LE(test::relative_error(response.spectra().col(0), squared), 1e-12);
}

// Formulas for a single degree of freedom, |H|² S node by node, take the loads of any two nodes as
// independent: without their cross-spectra the deviations are far off
TEST(ConventionalMethod, NeedsTheCrossCorrelationsOfTheLoads) {
  const SmallPlate& plate = small_plate();
  const MatXcd transfer = plate.transfer(), loads = plate.load_spectra();
  const MatXcd diagonal = loads.diagonal().asDiagonal();
  const VecXd approximate =
      (transfer.conjugate() * diagonal * transfer.transpose()).diagonal().real();
  const VecXd exact = (transfer.conjugate() * loads * transfer.transpose()).diagonal().real();
  // The formula itself: ∑_j |H_ij|² S_jj
  EXPECT_LE(test::relative_error(approximate, transfer.cwiseAbs2() * loads.diagonal().real()),
            1e-12);
  const Index motions = 3 * plate.mesh.node_count();
  const auto deflections = Eigen::seq(0, motions - 1, 3);
  const VecXd ratio =
      approximate(deflections).cwiseSqrt().cwiseQuotient(exact(deflections).cwiseSqrt());
  EXPECT_LT(ratio.mean(), 0.7);
}

}  // namespace
}  // namespace floe
