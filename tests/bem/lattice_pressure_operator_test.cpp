#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <omp.h>

#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace floe::bem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The cells of an nx × ny lattice of 3 × 2 m that `keep` chooses
mesh::Q8Mesh lattice_mesh(int nx, int ny, const std::function<bool(int, int)>& keep) {
  const mesh::Q8Mesh full =
      mesh::make_rectangle({.length = 3.0 * nx, .width = 2.0 * ny, .nx = nx, .ny = ny});
  std::vector<Index> kept;
  std::set<Index> used;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      if (keep(i, j)) kept.push_back(static_cast<Index>(j) * nx + i);
  for (const Index e : kept)
    for (int a = 0; a < 8; ++a) used.insert(full.elements()(a, e));
  std::vector<Index> number(full.node_count(), -1);
  Points2 nodes(2, static_cast<Index>(used.size()));
  Index next = 0;
  for (const Index node : used) {
    nodes.col(next) = full.nodes().col(node);
    number[node] = next++;
  }
  mesh::Connectivity elements(8, static_cast<Index>(kept.size()));
  for (std::size_t e = 0; e < kept.size(); ++e)
    for (int a = 0; a < 8; ++a)
      elements(a, static_cast<Index>(e)) = number[full.elements()(a, kept[e])];
  return {nodes, elements};
}

struct Outline {
  const char* name;
  mesh::Q8Mesh mesh;
};

std::vector<Outline> outlines() {
  return {
      {"rectangle", lattice_mesh(9, 5, [](int, int) { return true; })},
      {"one element", lattice_mesh(1, 1, [](int, int) { return true; })},
      {"L", lattice_mesh(8, 7, [](int i, int j) { return i < 3 || j < 2; })},
      {"hole", lattice_mesh(8, 7, [](int i, int j) { return i < 2 || i > 4 || j < 2 || j > 4; })},
      {"two plates", lattice_mesh(11, 4, [](int i, int) { return i < 4 || i > 6; })},
      {"frame one element wide",
       lattice_mesh(6, 9, [](int i, int j) { return i == 0 || i == 5 || j == 0 || j == 4; })},
      {"lone elements", lattice_mesh(5, 3, [](int i, int j) { return i % 2 + j % 2 == 0; })}};
}

// Holds the lattice operator, its element integrals to each tolerance, against the dense one
void expect_twins(const Outline& outline, double depth, const std::vector<double>& tolerances) {
  const mesh::Q8Mesh& mesh = outline.mesh;
  const green::GreenTable green(green::GreenFunction(0.2, depth), 40.0);
  const DensePressureOperator dense(ElementIntegrals(mesh, {.tolerance = 1e-12}), green);
  const MatXcd x = MatXcd::Random(mesh.node_count(), 3);
  MatXcd expected(x.rows(), 3), actual(x.rows(), 3);
  dense.apply(x, expected);
  for (const double tolerance : tolerances) {
    const auto plan =
        std::make_shared<const LatticePlan>(mesh, IntegralOptions{.tolerance = tolerance});
    LatticePressureOperator(plan, green).apply(x, actual);
    EXPECT_LE(test::relative_error(actual, expected), tolerance)
        << outline.name << ", depth " << depth;
  }
}

TEST(twin_LatticePressureOperator, EqualsTheDenseOperatorOnEveryOutline) {
  // With the same integrals, 1e-12, what remains is rounding
  for (const Outline& outline : outlines()) expect_twins(outline, 10.0, {1e-3, 1e-5, 1e-7, 1e-12});
}

TEST(twin_LatticePressureOperator, EqualsTheDenseOperatorOnOutlinesWithManySteps) {
  // More steps than the outline may have lines: all sources are transformed as lattices
  expect_twins({"stairs", lattice_mesh(20, 20, [](int i, int j) { return i == j || i == j + 1; })},
               10.0, {1e-7, 1e-12});
  expect_twins({"comb", lattice_mesh(3, 19, [](int i, int j) { return i == 0 || j % 2 == 0; })},
               10.0, {1e-7, 1e-12});
}

TEST(twin_LatticePressureOperator, EqualsTheDenseOperatorAtEveryDepth) {
  for (const double depth : {0.5, kInfinity}) expect_twins(outlines()[3], depth, {1e-7, 1e-12});
}

// Operator, block of columns and each column alone, with 1, 2, 3 and 7 threads
void expect_same_bits(const mesh::Q8Mesh& mesh) {
  const int before = omp_get_max_threads();
  const MatXcd x = MatXcd::Random(mesh.node_count(), 5);
  MatXcd first;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    const green::GreenTable green(green::GreenFunction(0.2, 10.0), 80.0);
    const LatticePressureOperator lattice(std::make_shared<const LatticePlan>(mesh), green);
    MatXcd y(x.rows(), x.cols());
    lattice.apply(x, y);
    if (threads == 1) first = y;
    EXPECT_EQ(first, y) << threads << " threads";
    for (Index column = 0; column < x.cols(); ++column) {
      MatXcd alone(x.rows(), 1);
      lattice.apply(x.col(column), alone);
      EXPECT_EQ(y.col(column), alone.col(0)) << threads << " threads";
    }
  }
  omp_set_num_threads(before);
}

TEST(LatticePressureOperator, HasTheSameBitsForAnyNumberOfThreadsAndInBlocks) {
  expect_same_bits(outlines()[0].mesh);
  expect_same_bits(outlines()[3].mesh);
  expect_same_bits(lattice_mesh(20, 20, [](int i, int j) { return i == j || i == j + 1; }));
}

TEST(ElementLattice, IsFoundWhateverTheNumberingOfElements) {
  const mesh::Q8Mesh mesh = lattice_mesh(4, 3, [](int, int) { return true; });
  mesh::Connectivity turned = mesh.elements();
  for (int a = 0; a < 4; ++a) {
    turned(a, 5) = mesh.elements()((a + 1) % 4, 5);
    turned(4 + a, 5) = mesh.elements()(4 + (a + 1) % 4, 5);
  }
  const auto plain = find_element_lattice(mesh);
  const auto found = find_element_lattice({mesh.nodes(), turned});
  ASSERT_TRUE(plain && found);
  EXPECT_EQ(found->connectivity, plain->connectivity);
  EXPECT_EQ(found->nx, 4);
  EXPECT_EQ(found->ny, 3);
  EXPECT_DOUBLE_EQ(found->filling(), 1.0);
}

TEST(ElementLattice, IsNotFoundWhereElementsDiffer) {
  EXPECT_FALSE(find_element_lattice(
      mesh::make_rectangle({.length = 9.0, .width = 6.0, .nx = 5, .ny = 3, .grading = 1.5})));
  const mesh::Q8Mesh mesh = lattice_mesh(4, 3, [](int, int) { return true; });
  Points2 moved = mesh.nodes();
  moved(0, 20) += 1e-6;
  EXPECT_FALSE(find_element_lattice({moved, mesh.elements()}));
  EXPECT_THROW(LatticePlan({moved, mesh.elements()}), MeshError);
}

}  // namespace
}  // namespace floe::bem
