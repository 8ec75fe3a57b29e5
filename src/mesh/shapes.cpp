#include <floe/mesh/shapes.hpp>

namespace floe::mesh {
namespace {

constexpr const char* kElementSize = "element_size";
constexpr const char* kAboutElementSize = "no element edge is longer [m]";

Q8Mesh make(const RectangleOptions& options) { return make_rectangle(options); }
Q8Mesh make(const DiscOptions& options) { return make_disc(options); }
Q8Mesh make(const RingOptions& options) { return make_ring(options); }
Q8Mesh make(const LShapeOptions& options) { return make_l_shape(options); }
Q8Mesh make(const ModuleArrayOptions& options) { return make_module_array(options); }

}  // namespace

Q8Mesh make_shape(const Shape& shape) {
  return std::visit([](const auto& options) { return make(options); }, shape);
}

ShapeKeys<DiscOptions> shape_keys(const DiscOptions&) {
  using Options = DiscOptions;
  return {.name = "disc",
          .about = "mesh of a disc, with curved edges",
          .lengths = {{"radius", &Options::radius, "radius [m]"},
                      {kElementSize, &Options::element_size, kAboutElementSize}},
          .counts = {}};
}

ShapeKeys<RingOptions> shape_keys(const RingOptions&) {
  using Options = RingOptions;
  return {.name = "ring",
          .about = "mesh of a ring, with curved edges",
          .lengths = {{"inner_radius", &Options::inner_radius, "inner radius [m]"},
                      {"outer_radius", &Options::outer_radius, "outer radius [m]"},
                      {kElementSize, &Options::element_size, kAboutElementSize}},
          .counts = {}};
}

ShapeKeys<LShapeOptions> shape_keys(const LShapeOptions&) {
  using Options = LShapeOptions;
  return {.name = "lshape",
          .about = "mesh of a rectangle without a smaller one at its corner +x, +y",
          .lengths = {{"length", &Options::length, "extent in x [m]"},
                      {"width", &Options::width, "extent in y [m]"},
                      {"cut_length", &Options::cut_length, "extent in x of what is missing [m]"},
                      {"cut_width", &Options::cut_width, "extent in y of what is missing [m]"},
                      {kElementSize, &Options::element_size, kAboutElementSize}},
          .counts = {}};
}

ShapeKeys<ModuleArrayOptions> shape_keys(const ModuleArrayOptions&) {
  using Options = ModuleArrayOptions;
  return {.name = "modules",
          .about = "mesh of equal separate rectangles in rows and columns",
          .lengths = {{"module_length", &Options::module_length, "extent of one in x [m]"},
                      {"module_width", &Options::module_width, "extent of one in y [m]"},
                      {"gap", &Options::gap, "water between neighbours [m]"},
                      {kElementSize, &Options::element_size, kAboutElementSize}},
          .counts = {{"modules_x", &Options::modules_x, "modules along x"},
                     {"modules_y", &Options::modules_y, "modules along y"}}};
}

}  // namespace floe::mesh
