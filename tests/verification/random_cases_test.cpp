#include "tiny_meshes.hpp"

#include <floe/analysis.hpp>
#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/element_integrals.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/refine.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/wave/dispersion.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <sstream>

// Laws that every valid case obeys: random shapes, depths, wavelengths and numbers of modes.
namespace floe {
namespace {

double between(std::mt19937& random, double from, double to) {
  return from + (to - from) * std::generate_canonical<double, 53>(random);
}

double between_logarithms(std::mt19937& random, double from, double to) {
  return std::exp(between(random, std::log(from), std::log(to)));
}

// A rectangle, a sheared or tapered one, a ring, or two plates
mesh::Q8Mesh random_mesh(std::mt19937& random) {
  const double length = between(random, 20.0, 100.0), width = between(random, 10.0, 60.0);
  const test::MeshArrays plain = test::rectangle_arrays(8, 5, length, width);
  switch (random() % 4) {
    case 0:
      return plain.build();
    case 1: {
      const double shear = between(random, -0.5, 0.5), taper = between(random, -0.3, 0.3);
      return test::mapped(plain,
                          [&](const Point2& p) {
                            return Point2(p.x() + shear * p.y(),
                                          p.y() * (1.0 + taper * p.x() / length));
                          })
          .build();
    }
    case 2:
      return test::ring_arrays(0.3 * length, 0.6 * length, 16, 3).build();
    default:
      return test::joined(plain, test::shifted(plain, between(random, 1.2, 3.0) * length,
                                               between(random, -1.0, 1.0) * width))
          .build();
  }
}

struct RandomCase {
  explicit RandomCase(unsigned seed) : random(seed), mesh(random_mesh(random)) {
    const double element = std::sqrt(mesh.area() / static_cast<double>(mesh.element_count()));
    // Six elements a wavelength or more, down to waves ten times as long as the structure
    wavelength = between_logarithms(random, 6.0 * element, 10.0 * mesh.size());
    water.depth = random() % 5 == 0 ? std::numeric_limits<double>::infinity()
                                    : between_logarithms(random, 0.03, 3.0) * wavelength;
    omega = wave::angular_frequency(2.0 * std::numbers::pi / wavelength, water);
    modes = 3 * mesh.piece_count() + static_cast<int>(random() % 6);
  }

  std::string told() const {
    std::ostringstream text;
    text << mesh.element_count() << " elements, " << mesh.piece_count() << " pieces, size "
         << mesh.size() << " m, wavelength " << wavelength << " m, depth " << water.depth << " m, "
         << modes << " modes";
    return text.str();
  }

  std::mt19937 random;
  mesh::Q8Mesh mesh;
  wave::Water water;
  double wavelength = 0.0, omega = 0.0;
  int modes = 0;
};

// Radiation of some deflections on one mesh, with what its laws need
struct Solved {
  Solved(const RandomCase& given, const mesh::Q8Mesh& on, const MatXd& deflection)
      : integrals(on),
        green(green::GreenFunction(wave::deep_wavenumber(given.omega, given.water),
                                   given.water.depth),
              1.01 * std::sqrt(2.0) * on.size()),
        kappa(green.exact().nu() / (4.0 * std::numbers::pi)),
        radiation(hydro::solve_radiation(bem::DensePressureOperator(integrals, green), deflection,
                                         hydro::surface_mass(on), given.omega, given.water, 1e-10)),
        radiated(hydro::radiated_damping(radiation.pressure, on, given.omega, given.water)) {}

  // ω²a + iωb
  MatXcd hydrodynamic(double omega) const {
    return omega * omega * radiation.added_mass.cast<Complex>() +
           Complex(0.0, omega) * radiation.damping.cast<Complex>();
  }

  bem::ElementIntegrals integrals;
  green::GreenTable green;
  double kappa;
  hydro::Radiation radiation;
  MatXd radiated;
};

// Nodal values of the coarse mesh at the nodes of its refinement, whose elements 4e … 4e + 3 are
// the parts of e
template <typename Matrix>
Matrix at_finer_nodes(const mesh::Q8Mesh& coarse, const mesh::Q8Mesh& fine, const Matrix& values) {
  const mesh::PointLocator locator(coarse);
  Matrix finer(fine.node_count(), values.cols());
  for (Index n = 0; n < fine.node_count(); ++n) {
    const auto place = locator.locate(fine.nodes().col(n));
    const mesh::Shape8 shape = mesh::q8_shape(place->xi, place->eta);
    finer.row(n).setZero();
    for (int a = 0; a < 8; ++a)
      finer.row(n) += shape[a] * values.row(coarse.elements()(a, place->element));
  }
  return finer;
}

// At element centres, where nothing was asked of the pressure: the largest residual of
// (I + κ𝒢)p = -ρg w, and its bound by the error of p
struct Centres {
  double residual = 0.0;
  double row_sum = 0.0;  // largest κ∑|𝒢_m| of the finer mesh
};

Centres look_at_centres(const RandomCase& given, const Solved& coarse, const Solved& fine,
                        const MatXd& deflection) {
  const double weight = given.water.density * given.water.gravity;
  const mesh::Shape8 shape = mesh::q8_shape(0.0, 0.0);
  VecXcd row(given.mesh.node_count()), finer(fine.integrals.mesh().node_count());
  Centres found;
  for (Index e = 0; e < given.mesh.element_count(); e += 5) {
    const Point2 centre = given.mesh.element_nodes(e) * shape;
    coarse.integrals.point_row(centre, coarse.green, row);
    fine.integrals.point_row(centre, fine.green, finer);
    Eigen::RowVectorXcd residual = coarse.kappa * (row.transpose() * coarse.radiation.pressure);
    for (int a = 0; a < 8; ++a) {
      const Index node = given.mesh.elements()(a, e);
      residual += shape[a] * (coarse.radiation.pressure.row(node) +
                              weight * deflection.row(node).cast<Complex>());
    }
    found.residual = std::max(found.residual, residual.cwiseAbs().maxCoeff());
    found.row_sum = std::max(found.row_sum, coarse.kappa * finer.cwiseAbs().sum());
  }
  return found;
}

// What the laws may miss follows from one statement about the elements, held against the same case
// with every element divided into four: halving the elements takes away half or more of the error
// of integrals ∫ w p dS, and 1 - 1/√2 or more of that of p itself, which goes like the square root
// of the distance from the outline. So errors of integrals are at most 2 times the difference of
// the two solutions, those of p at most 3.42 times. The quadrature's tolerance 1e-8 stands besides.
constexpr double kOfIntegrals = 2.0;
constexpr double kOfPressures = 3.42;
constexpr double kFloor = 1e-7;

// Measured over allowed, the largest of each law
struct Worst {
  double reciprocity = 0.0, energy = 0.0, passivity = 0.0, residual = 0.0;
  double difference = 0.0;  // of the two meshes' matrices, relative
};

void hold(double measured, double allowed, const char* law, double& worst) {
  EXPECT_LE(measured, allowed) << law;
  worst = std::max(worst, measured / allowed);
}

void expect_laws(unsigned seed, Worst& worst) {
  const RandomCase given(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + given.told());
  const plate::DryModes modes = plate::dry_modes(
      given.mesh,
      plate::PlateProperties{
          .thickness = 2.0, .youngs_modulus = 1e10, .poisson_ratio = 0.2, .density = 300.0},
      {.count = given.modes});
  EXPECT_LT(modes.orthonormality_error, 1e-8);
  EXPECT_LT(modes.rigid_force_error, 1e-12);

  // Solve on the mesh and on the finer one
  const MatXd deflection = modes.shape(Eigen::seq(0, Eigen::last, 3), Eigen::all);
  const mesh::Q8Mesh finer = mesh::refine(given.mesh);
  const Solved coarse(given, given.mesh, deflection);
  const Solved fine(given, finer, at_finer_nodes(given.mesh, finer, deflection));
  const MatXcd matrix = coarse.hydrodynamic(given.omega);
  const MatXcd change = matrix - fine.hydrodynamic(given.omega);
  worst.difference = std::max(worst.difference, change.norm() / matrix.norm());

  // ‖Q - Qᵀ‖ is at most twice the error of Q
  const double error = kOfIntegrals * change.norm() / matrix.norm() + kFloor;
  hold(hydro::reciprocity_error(coarse.radiation, given.omega), 2.0 * error, "reciprocity",
       worst.reciprocity);

  // Each b_ij and b̂_ij has an error of its own
  const MatXd damping = coarse.radiation.damping;
  const VecXd scale = damping.diagonal()
                          .cwiseMax(given.omega * coarse.radiation.added_mass.diagonal().cwiseAbs())
                          .cwiseSqrt();
  const MatXd missed =
      (damping - fine.radiation.damping).cwiseAbs() + (coarse.radiated - fine.radiated).cwiseAbs();
  const double allowed =
      kOfIntegrals * missed.cwiseQuotient(scale * scale.transpose()).maxCoeff() + kFloor;
  hold(hydro::energy_error(coarse.radiation, coarse.radiated, given.omega), allowed, "energy",
       worst.energy);

  // An eigenvalue moves by no more than the norm of what is added to the matrix
  hold(hydro::passivity_error(coarse.radiation),
       kOfIntegrals * (damping - fine.radiation.damping).norm() / damping.norm() *
               std::sqrt(static_cast<double>(damping.rows())) +
           kFloor,
       "positive damping", worst.passivity);

  // The residual is (I + κ𝒢) of the error of p
  const double change_of_pressure =
      (at_finer_nodes(given.mesh, finer, coarse.radiation.pressure) - fine.radiation.pressure)
          .cwiseAbs()
          .maxCoeff();
  const Centres centres = look_at_centres(given, coarse, fine, deflection);
  const double weight = given.water.density * given.water.gravity;
  hold(centres.residual,
       (1.0 + centres.row_sum) * kOfPressures * change_of_pressure +
           kFloor * weight * deflection.cwiseAbs().maxCoeff(),
       "residual at centres", worst.residual);
}

void expect_laws_of(unsigned first, unsigned last) {
  Worst worst;
  for (unsigned seed = first; seed <= last; ++seed) expect_laws(seed, worst);
  testing::Test::RecordProperty("reciprocity_over_allowed", std::to_string(worst.reciprocity));
  testing::Test::RecordProperty("energy_over_allowed", std::to_string(worst.energy));
  testing::Test::RecordProperty("passivity_over_allowed", std::to_string(worst.passivity));
  testing::Test::RecordProperty("residual_over_allowed", std::to_string(worst.residual));
  testing::Test::RecordProperty("largest_difference", std::to_string(worst.difference));
}

TEST(identity_RandomCases, ObeyTheLaws) { expect_laws_of(1, 6); }

TEST(identity_RandomCasesLong, ObeyTheLaws) { expect_laws_of(7, 200); }

}  // namespace
}  // namespace floe
