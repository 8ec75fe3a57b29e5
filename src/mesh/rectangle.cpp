#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>

namespace floe::mesh {
namespace {

constexpr double kMostElements = 1e8;

// Corner coordinates of `count` cells over [-extent/2, extent/2], edges shrinking to both ends;
// symmetric about 0 to the last bit
VecXd graded_corners(double extent, int count, double grading) {
  VecXd edge(count);
  const double half = 0.5 * (count - 1);
  for (int i = 0; i < count; ++i) {
    const double from_middle = half > 0.0 ? std::abs(i - half) / half : 0.0;
    edge[i] = std::pow(grading, -from_middle);
  }
  edge *= extent / edge.sum();

  // Go from the middle to the right, and mirror
  VecXd corner(count + 1);
  double place = count % 2 == 0 ? 0.0 : 0.5 * edge[count / 2];
  for (int i = (count + 1) / 2; i <= count; ++i) {
    // NOTE: equal cells come from a quotient of integers, whose error does not add up
    corner[i] = grading == 1.0 ? extent * (2.0 * i - count) / (2.0 * count) : place;
    if (i < count) place += edge[i];
  }
  corner[count] = 0.5 * extent;
  for (int i = 0; 2 * i < count; ++i) corner[i] = -corner[count - i];
  return corner;
}

double lattice_coordinate(const VecXd& corner, int twice) {
  return twice % 2 == 0 ? corner[twice / 2] : 0.5 * (corner[twice / 2] + corner[twice / 2 + 1]);
}

}  // namespace

Q8Mesh make_rectangle(const RectangleOptions& options) {
  FLOE_VALIDATE(options.length > 0.0 && std::isfinite(options.length),
                "invalid rectangle length = " << options.length << " m (must be positive)");
  FLOE_VALIDATE(options.width > 0.0 && std::isfinite(options.width),
                "invalid rectangle width = " << options.width << " m (must be positive)");
  FLOE_VALIDATE(options.nx >= 1 && options.ny >= 1,
                "invalid rectangle nx, ny = " << options.nx << ", " << options.ny
                                              << " elements (must be at least 1)");
  FLOE_VALIDATE(static_cast<double>(options.nx) * options.ny <= kMostElements,
                "invalid rectangle nx, ny = " << options.nx << ", " << options.ny
                                              << " elements (must be at most 1e8 in all)");
  FLOE_VALIDATE(options.grading >= 1.0 && options.grading <= 100.0,
                "invalid rectangle grading = " << options.grading << " (must be 1 to 100)");

  // Number the nodes row by row of the half-step lattice, leaving out element centres
  const int rows = 2 * options.ny + 1, columns = 2 * options.nx + 1;
  const VecXd x = graded_corners(options.length, options.nx, options.grading);
  const VecXd y = graded_corners(options.width, options.ny, options.grading);
  const auto number = [&](Index i, Index j) {
    const Index full = columns, half = options.nx + 1;
    const Index before = (j + 1) / 2 * full + j / 2 * half;
    return before + (j % 2 == 0 ? i : i / 2);
  };
  Points2 nodes(2, number(columns - 1, rows - 1) + 1);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      if (i % 2 == 0 || j % 2 == 0)
        nodes.col(number(i, j)) << lattice_coordinate(x, i), lattice_coordinate(y, j);

  // Connect corners and mid-sides
  Connectivity elements(8, static_cast<Index>(options.nx) * options.ny);
  Index element = 0;
  for (int j = 0; j < rows - 1; j += 2)
    for (int i = 0; i < columns - 1; i += 2)
      elements.col(element++) << number(i, j), number(i + 2, j), number(i + 2, j + 2),
          number(i, j + 2), number(i + 1, j), number(i + 2, j + 1), number(i + 1, j + 2),
          number(i, j + 1);
  return Q8Mesh(std::move(nodes), std::move(elements));
}

}  // namespace floe::mesh
