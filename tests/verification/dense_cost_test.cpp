#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>

#include <gtest/gtest.h>
#include <rigid_plate.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>

// The paper's second mesh, 4 m elements. CPU time, not wall time: other processes do not count.
namespace floe {
namespace {

template <typename Work>
double cpu_seconds(Work work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(verification_DenseCost, AssemblyTakesLessThanFactoringAt3556Nodes) {
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 75, .ny = 15});
  ASSERT_EQ(mesh.node_count(), 3556);
  const green::GreenTable green = test::green_table(1.01, test::table1_water(), 310.0);
  std::array<double, 3> ratio{};
  for (double& each : ratio) {
    // Everything that the frequency needs: table, element rules, matrix
    MatXcd matrix;
    const double assembly = cpu_seconds([&] {
      const green::GreenTable again = test::green_table(1.01, test::table1_water(), 310.0);
      matrix = bem::assemble_green_matrix(bem::ElementIntegrals(mesh), again);
    });
    matrix.diagonal().array() += 10.0;
    const double factoring = cpu_seconds([&] { numeric::DenseLu lu(std::move(matrix)); });
    std::printf("assembly %.2f s, LU %.2f s of CPU time\n", assembly, factoring);
    each = assembly / factoring;
  }
  std::sort(ratio.begin(), ratio.end());
  EXPECT_LT(ratio[1], 1.0);
}

}  // namespace
}  // namespace floe
