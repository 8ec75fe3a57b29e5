#include "tiny_meshes.hpp"

#include <floe/analysis.hpp>
#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/element_integrals.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
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

// Largest residual of (I + κ𝒢)p = -ρg w at element centres, where nothing was asked of p, relative
// to the largest -ρg w
double residual_between_nodes(const RandomCase& given, const bem::ElementIntegrals& integrals,
                              const green::GreenTable& green, const MatXd& deflection,
                              const MatXcd& pressure) {
  const double weight = given.water.density * given.water.gravity;
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  const mesh::Shape8 shape = mesh::q8_shape(0.0, 0.0);
  VecXcd row(given.mesh.node_count());
  double worst = 0.0;
  for (Index e = 0; e < given.mesh.element_count(); e += 5) {
    integrals.point_row(given.mesh.element_nodes(e) * shape, green, row);
    Eigen::RowVectorXcd residual = kappa * (row.transpose() * pressure);
    for (int a = 0; a < 8; ++a) {
      const Index node = given.mesh.elements()(a, e);
      residual += shape[a] * (pressure.row(node) + weight * deflection.row(node).cast<Complex>());
    }
    worst = std::max(worst, residual.cwiseAbs().maxCoeff());
  }
  return worst / (weight * deflection.cwiseAbs().maxCoeff());
}

// Reciprocity and energy are quadratic in the error of the pressure, which on six elements a
// wavelength and with its root-like behaviour along outlines is about a tenth: 0.02 of a matrix.
// The residual between the nodes is linear in it.
void expect_laws(unsigned seed) {
  const RandomCase given(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + given.told());
  const plate::DryModes modes = plate::dry_modes(
      given.mesh,
      {.thickness = 2.0, .youngs_modulus = 1e10, .poisson_ratio = 0.2, .density = 300.0},
      {.count = given.modes});
  const MatXd deflection = modes.shape(Eigen::seq(0, Eigen::last, 3), Eigen::all);
  const bem::ElementIntegrals integrals(given.mesh);
  const double nu = wave::deep_wavenumber(given.omega, given.water);
  const green::GreenTable green(green::GreenFunction(nu, given.water.depth),
                                1.01 * std::sqrt(2.0) * given.mesh.size());
  const bem::DensePressureOperator dense(integrals, green);
  const hydro::Radiation radiation = hydro::solve_radiation(
      dense, deflection, hydro::surface_mass(given.mesh), given.omega, given.water, 1e-10);
  EXPECT_LT(modes.orthonormality_error, 1e-8);
  EXPECT_LT(modes.rigid_force_error, 1e-12);
  EXPECT_LT(hydro::reciprocity_error(radiation, given.omega), 0.02);
  EXPECT_LT(hydro::energy_error(
                radiation,
                hydro::radiated_damping(radiation.pressure, given.mesh, given.omega, given.water),
                given.omega),
            0.02);
  EXPECT_LT(hydro::passivity_error(radiation), 0.02);
  EXPECT_LT(residual_between_nodes(given, integrals, green, deflection, radiation.pressure), 0.1);
}

TEST(identity_RandomCases, ObeyTheLaws) {
  for (unsigned seed = 1; seed <= 10; ++seed) expect_laws(seed);
}

TEST(identity_RandomCasesLong, ObeyTheLaws) {
  for (unsigned seed = 11; seed <= 200; ++seed) expect_laws(seed);
}

}  // namespace
}  // namespace floe
