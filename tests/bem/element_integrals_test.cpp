#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/element_integrals.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>

#include <Eigen/LU>
#include <expect.hpp>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace floe::bem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One element whose nodes are moved by a smooth map, so that edges are curved
mesh::Q8Mesh curved_patch(int nx, int ny) {
  const mesh::Q8Mesh flat = mesh::make_rectangle({.length = 4.0, .width = 3.0, .nx = nx, .ny = ny});
  Points2 nodes = flat.nodes();
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double x = nodes(0, i), y = nodes(1, i);
    nodes.col(i) << x + 0.12 * std::sin(y) * x, y + 0.15 * std::cos(0.7 * x);
  }
  return {nodes, flat.elements()};
}

// ∫ G N_m dS over all elements by brute force: the plain composite rule in polar coordinates around
// x is replaced by `levels` halvings towards x of each element, 24 × 24 Gauss points a cell. Slow,
// simple, shares no code with the engine but the shape functions.
void add_by_halving(const mesh::Q8Mesh& mesh, Index element, const Point2& x,
                    const green::GreenFunction& green, const Point2& centre, const Point2& half,
                    int level, VecXcd& row) {
  const auto nodes = mesh.element_nodes(element);
  const Point2 middle = nodes * mesh::q8_shape(centre.x(), centre.y());
  double radius = 0.0;
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0})
      radius = std::max(
          radius,
          (nodes * mesh::q8_shape(centre.x() + sx * half.x(), centre.y() + sy * half.y()) - middle)
              .norm());
  const double scale = std::min(green.depth(), 1.0 / green.wavenumber());
  if (((middle - x).norm() < 2.5 * radius || radius > 2.0 * scale) && level > 0) {
    for (const double sx : {-0.5, 0.5})
      for (const double sy : {-0.5, 0.5})
        add_by_halving(mesh, element, x, green, centre + half.cwiseProduct(Point2(sx, sy)),
                       0.5 * half, level - 1, row);
    return;
  }
  const auto& gauss = numeric::gauss_legendre(10);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      const double xi = centre.x() + half.x() * gauss.node[i];
      const double eta = centre.y() + half.y() * gauss.node[j];
      const mesh::Shape8 shape = mesh::q8_shape(xi, eta);
      const double area = (mesh::q8_shape_gradient(xi, eta) * nodes.transpose()).determinant() *
                          half.x() * half.y() * gauss.weight[i] * gauss.weight[j];
      const Complex value = area * green((Point2(nodes * shape) - x).norm());
      for (int m = 0; m < 8; ++m) row[mesh.elements()(m, element)] += shape[m] * value;
    }
}

VecXcd row_by_halving(const mesh::Q8Mesh& mesh, const Point2& x,
                      const green::GreenFunction& green) {
  VecXcd row = VecXcd::Zero(mesh.node_count());
  // 24 halvings leave a cell of 2^-24 of the element, whose 1/R integral is as small
  for (Index e = 0; e < mesh.element_count(); ++e)
    add_by_halving(mesh, e, x, green, Point2(0, 0), Point2(1, 1), 24, row);
  return row;
}

struct Water {
  const char* name;
  double nu, depth;
};
const Water kWaters[] = {{"deep", 0.3, kInfinity}, {"finite", 0.3, 2.0}, {"shallow", 0.05, 0.1}};

TEST(twin_ElementIntegrals, OfNodesEqualRepeatedHalving) {
  const mesh::Q8Mesh mesh = curved_patch(2, 2);
  const ElementIntegrals integrals(mesh);
  for (const Water& water : kWaters) {
    const green::GreenTable green(green::GreenFunction(water.nu, water.depth), 10.0);
    for (const Index node : {Index{0}, Index{1}, mesh.node_count() / 2, mesh.node_count() - 2}) {
      VecXcd row(mesh.node_count());
      integrals.node_row(node, green, row);
      const VecXcd twin = row_by_halving(mesh, mesh.nodes().col(node), green.exact());
      // The tolerance asked of each element, 1e-8
      test::expect_all_close(row, twin, 1e-8, 0.0, water.name);
    }
  }
}

TEST(twin_ElementIntegrals, OfPointsInsideOnAndOffThePlateEqualRepeatedHalving) {
  const mesh::Q8Mesh mesh = curved_patch(2, 2);
  const ElementIntegrals integrals(mesh);
  const auto on = [&](Index e, double xi, double eta) {
    return Point2(mesh.element_nodes(e) * mesh::q8_shape(xi, eta));
  };
  const Point2 points[] = {on(0, 0.0, 0.0),
                           on(1, 0.31, -0.94),
                           on(0, 1.0, 0.2),
                           on(3, 0.4, 1.0),
                           Point2(5.0, 7.0),
                           Point2(2.7, 0.3),
                           on(3, 0.4, 1.0) + Point2(0, 0.01)};
  for (const Water& water : kWaters) {
    const green::GreenTable green(green::GreenFunction(water.nu, water.depth), 20.0);
    for (const Point2& point : points) {
      VecXcd row(mesh.node_count());
      integrals.point_row(point, green, row);
      test::expect_all_close(row, row_by_halving(mesh, point, green.exact()), 1e-8, 0.0,
                             water.name);
    }
  }
}

TEST(twin_ElementIntegrals, HoldTheirToleranceOnStretchedElements) {
  const mesh::Q8Mesh mesh = mesh::make_rectangle({.length = 40.0, .width = 2.0, .nx = 2, .ny = 2});
  const ElementIntegrals integrals(mesh);
  const green::GreenTable green(green::GreenFunction(0.05, 10.0), 60.0);
  for (Index node = 0; node < mesh.node_count(); node += 5) {
    VecXcd row(mesh.node_count());
    integrals.node_row(node, green, row);
    test::expect_all_close(row, row_by_halving(mesh, mesh.nodes().col(node), green.exact()), 1e-8);
  }
}

TEST(order_ElementIntegrals, ErrorFollowsTheToleranceAskedFor) {
  const mesh::Q8Mesh mesh = curved_patch(6, 5);
  const green::GreenTable green(green::GreenFunction(0.4, 3.0), 10.0);
  const MatXcd truth = assemble_green_matrix(ElementIntegrals(mesh, {.tolerance = 1e-12}), green);
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const MatXcd matrix =
        assemble_green_matrix(ElementIntegrals(mesh, {.tolerance = tolerance}), green);
    EXPECT_LE(test::relative_error(matrix, truth), tolerance) << tolerance;
  }
}

TEST(ElementIntegrals, HaveTheClosedFormOfOneOverRAtTheMiddleOfASquare) {
  // ν → 0 in deep water: G → 2/R, and ∫ 1/R over the square of side a from its centre is
  // 4 a ln(1 + √2); the next term of G is of the order ν ln ν
  const mesh::Q8Mesh mesh = mesh::make_rectangle({.length = 2.0, .width = 2.0, .nx = 1, .ny = 1});
  const green::GreenTable green(green::GreenFunction(1e-9, kInfinity), 4.0);
  VecXcd row(mesh.node_count());
  ElementIntegrals(mesh).point_row(Point2(0.0, 0.0), green, row);
  EXPECT_NEAR(row.sum().real(), 2.0 * 8.0 * std::log(1.0 + std::numbers::sqrt2), 1e-6);
}

TEST(ElementIntegrals, RejectATooSmallTolerance) {
  EXPECT_THROW(ElementIntegrals(curved_patch(1, 1), {.tolerance = 1e-14}), InputError);
}

TEST(identity_DensePressureOperator, SolveInvertsApply) {
  const mesh::Q8Mesh mesh = curved_patch(5, 4);
  const green::GreenTable green(green::GreenFunction(2.0, 3.0), 10.0);
  const DensePressureOperator pressure_operator(ElementIntegrals(mesh), green);
  const MatXcd x = MatXcd::Random(mesh.node_count(), 3);
  MatXcd y(x.rows(), x.cols());
  pressure_operator.apply(x, y);
  pressure_operator.solve(y);
  EXPECT_LE(test::relative_error(y, x), 1e-12);
}

TEST(DensePressureOperator, HasTheSameBitsForAnyNumberOfThreads) {
  const mesh::Q8Mesh mesh = mesh::make_rectangle({.length = 4.0, .width = 3.0, .nx = 9, .ny = 8});
  const ElementIntegrals integrals(mesh);
  const int before = omp_get_max_threads();
  MatXcd first;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    const green::GreenTable green(green::GreenFunction(2.0, 3.0), 10.0);
    MatXcd x = MatXcd::Ones(mesh.node_count(), 9);
    DensePressureOperator(integrals, green).solve(x);
    if (threads == 1) first = x;
    EXPECT_EQ(first, x) << threads << " threads";
  }
  omp_set_num_threads(before);
}

TEST(reference_ElementIntegrals, SingularFunctionsOverASquareHaveTheirClosedForms) {
  // Over the unit square as seen from a corner: ∫ 1/R = 2 asinh 1, ∫ log R = (log 2 - 3 + π/2)/2,
  // ∫ R = (√2 + asinh 1)/3, ∫ R² log R by mpmath; ∫ x/R by mpmath
  const mesh::Q8Mesh square = mesh::make_rectangle({.length = 1.0, .width = 1.0, .nx = 1, .ny = 1});
  const ElementIntegrals integrals(square, {.tolerance = 1e-10});
  Index corner = -1;
  for (Index i = 0; i < square.node_count(); ++i)
    if ((square.nodes().col(i) - square.lower()).norm() < 1e-12) corner = i;
  ASSERT_GE(corner, 0);
  std::array<Complex, 16> integral;
  const Index element = 0;
  integrals.node_singular_elements(corner, {&element, 1}, {&integral, 1});
  Complex sum(0.0, 0.0), other(0.0, 0.0);
  double x_over_r = 0.0;
  for (int m = 0; m < 8; ++m) {
    sum += integral[m];
    other += integral[8 + m];
    x_over_r +=
        integral[m].real() * (square.nodes()(0, square.elements()(m, 0)) - square.lower().x());
  }
  const double asinh1 = std::asinh(1.0);
  EXPECT_NEAR(sum.real(), 2.0 * asinh1, 1e-10);
  EXPECT_NEAR(sum.imag(), 0.5 * (std::log(2.0) - 3.0 + 0.5 * std::numbers::pi), 1e-9);
  EXPECT_NEAR(other.real(), (std::sqrt(2.0) + asinh1) / 3.0, 1e-10);
  EXPECT_NEAR(other.imag(), -0.0627071075697506, 1e-9);
  EXPECT_NEAR(x_over_r, 0.647793574696319, 1e-10);
}

}  // namespace
}  // namespace floe::bem
