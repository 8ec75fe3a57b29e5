#include "mesh/generation.hpp"

#include <floe/mesh/module_array.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

namespace floe::mesh {
namespace {

constexpr double kShorter = 1.25;  // as many elements more may be taken to fit the gap

// Elements along a module, such that the gap is a whole number of them if possible
int parts_along(double length, double gap, double size) {
  const int fewest = count_parts(length, size, "modules size");
  for (int count = fewest; count <= kShorter * fewest; ++count)
    if (fits(gap, length, count)) return count;
  return fewest;
}

}  // namespace

Q8Mesh make_module_array(const ModuleArrayOptions& options) {
  demand_positive(options.module_length, "modules module_length");
  demand_positive(options.module_width, "modules module_width");
  demand_positive(options.gap, "modules gap");
  demand_positive(options.element_size, "modules element_size");
  FLOE_VALIDATE(options.modules_x >= 1 && options.modules_y >= 1,
                "invalid modules_x, modules_y = " << options.modules_x << ", " << options.modules_y
                                                  << " (must be at least 1)");
  const int nx = parts_along(options.module_length, options.gap, options.element_size);
  const int ny = parts_along(options.module_width, options.gap, options.element_size);
  demand_few_elements(static_cast<double>(nx) * ny * options.modules_x * options.modules_y,
                      "modules size");

  // Copy one module to all places
  const Q8Mesh module = make_rectangle(
      {.length = options.module_length, .width = options.module_width, .nx = nx, .ny = ny});
  const Index count = static_cast<Index>(options.modules_x) * options.modules_y;
  Points2 nodes(2, count * module.node_count());
  Connectivity elements(8, count * module.element_count());
  for (Index copy = 0; copy < count; ++copy) {
    const Index i = copy % options.modules_x, j = copy / options.modules_x;
    const Point2 centre((options.module_length + options.gap) * 0.5 *
                            static_cast<double>(2 * i - options.modules_x + 1),
                        (options.module_width + options.gap) * 0.5 *
                            static_cast<double>(2 * j - options.modules_y + 1));
    nodes.middleCols(copy * module.node_count(), module.node_count()) =
        module.nodes().colwise() + centre;
    elements.middleCols(copy * module.element_count(), module.element_count()) =
        module.elements().array() + copy * module.node_count();
  }
  return Q8Mesh(std::move(nodes), std::move(elements));
}

}  // namespace floe::mesh
