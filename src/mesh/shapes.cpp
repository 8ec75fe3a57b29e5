#include <floe/mesh/shapes.hpp>

namespace floe::mesh {
namespace {

constexpr const char* kElementSize = "element_size";
constexpr const char* kAboutElementSize = "no element edge is longer [m]";

}  // namespace

ShapeKeys<DiscOptions> shape_keys(const DiscOptions&) {
  using Shape = DiscOptions;
  return {.name = "disc",
          .about = "mesh of a disc, with curved edges",
          .lengths = {{"radius", &Shape::radius, "radius [m]"},
                      {kElementSize, &Shape::element_size, kAboutElementSize}},
          .counts = {}};
}

ShapeKeys<RingOptions> shape_keys(const RingOptions&) {
  using Shape = RingOptions;
  return {.name = "ring",
          .about = "mesh of a ring, with curved edges",
          .lengths = {{"inner_radius", &Shape::inner_radius, "inner radius [m]"},
                      {"outer_radius", &Shape::outer_radius, "outer radius [m]"},
                      {kElementSize, &Shape::element_size, kAboutElementSize}},
          .counts = {}};
}

ShapeKeys<LShapeOptions> shape_keys(const LShapeOptions&) {
  using Shape = LShapeOptions;
  return {.name = "lshape",
          .about = "mesh of a rectangle without a smaller one at its corner +x, +y",
          .lengths = {{"length", &Shape::length, "extent in x [m]"},
                      {"width", &Shape::width, "extent in y [m]"},
                      {"cut_length", &Shape::cut_length, "extent in x of what is missing [m]"},
                      {"cut_width", &Shape::cut_width, "extent in y of what is missing [m]"},
                      {kElementSize, &Shape::element_size, kAboutElementSize}},
          .counts = {}};
}

ShapeKeys<ModuleArrayOptions> shape_keys(const ModuleArrayOptions&) {
  using Shape = ModuleArrayOptions;
  return {.name = "modules",
          .about = "mesh of equal separate rectangles in rows and columns",
          .lengths = {{"module_length", &Shape::module_length, "extent of one in x [m]"},
                      {"module_width", &Shape::module_width, "extent of one in y [m]"},
                      {"gap", &Shape::gap, "water between neighbours [m]"},
                      {kElementSize, &Shape::element_size, kAboutElementSize}},
          .counts = {{"modules_x", &Shape::modules_x, "modules along x"},
                     {"modules_y", &Shape::modules_y, "modules along y"}}};
}

}  // namespace floe::mesh
