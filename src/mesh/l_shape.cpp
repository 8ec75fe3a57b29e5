#include "mesh/generation.hpp"

#include <floe/mesh/l_shape.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>

namespace floe::mesh {
namespace {

// Parts of `length`, no longer than `size`, that go into `cut` too
int common_parts(double length, double cut, double size, const char* what) {
  const int fewest = count_parts(length, size, "lshape size");
  const int most = std::max(2 * fewest, 64);
  for (int count = fewest; count <= most; ++count)
    if (fits(cut, length, count)) return count;
  FLOE_VALIDATE(false, "invalid lshape cut_" << what << " = " << cut
                                             << " m (must be a whole number of equal elements of "
                                             << 0.5 * size << " to " << size << " m, and " << what
                                             << " = " << length << " m too)");
  return 0;
}

}  // namespace

Q8Mesh make_l_shape(const LShapeOptions& options) {
  demand_positive(options.length, "lshape length");
  demand_positive(options.width, "lshape width");
  demand_positive(options.cut_length, "lshape cut_length");
  demand_positive(options.cut_width, "lshape cut_width");
  demand_positive(options.element_size, "lshape element_size");
  FLOE_VALIDATE(options.cut_length < options.length && options.cut_width < options.width,
                "invalid lshape cut = " << options.cut_length << " × " << options.cut_width
                                        << " m (must be less than " << options.length << " × "
                                        << options.width << " m)");
  const int nx = common_parts(options.length, options.cut_length, options.element_size, "length");
  const int ny = common_parts(options.width, options.cut_width, options.element_size, "width");
  demand_few_elements(static_cast<double>(nx) * ny, "lshape size");
  const Index arm_x = nx - std::lround(options.cut_length / options.length * nx);
  const Index arm_y = ny - std::lround(options.cut_width / options.width * ny);

  // Number the nodes row by row of the half-step lattice, leaving out element centres and the cut
  MeshBuilder builder;
  const Index columns = 2 * nx + 1, rows = 2 * ny + 1;
  std::vector<Index> number(static_cast<std::size_t>(columns * rows), -1);
  const auto at = [&](Index i, Index j) -> Index& { return number[j * columns + i]; };
  // NOTE: equal steps come from a quotient of integers, whose error does not add up
  const auto place = [](double extent, Index i, int n) {
    return extent * static_cast<double>(i - n) / (2.0 * n);
  };
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i)
      if ((i % 2 == 0 || j % 2 == 0) && (i <= 2 * arm_x || j <= 2 * arm_y))
        at(i, j) = builder.add_node({place(options.length, i, nx), place(options.width, j, ny)});
  for (Index j = 0; j < rows - 1; j += 2)
    for (Index i = 0; i < columns - 1; i += 2)
      if (i < 2 * arm_x || j < 2 * arm_y)
        builder.elements.push_back({at(i, j), at(i + 2, j), at(i + 2, j + 2), at(i, j + 2),
                                    at(i + 1, j), at(i + 2, j + 1), at(i + 1, j + 2),
                                    at(i, j + 1)});
  return builder.finish();
}

}  // namespace floe::mesh
