#pragma once

#include <floe/mesh/disc.hpp>
#include <floe/mesh/l_shape.hpp>
#include <floe/mesh/module_array.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/mesh/ring.hpp>

#include <variant>
#include <vector>

namespace floe::mesh {

/// A shape that floe can mesh.
using Shape =
    std::variant<RectangleOptions, DiscOptions, RingOptions, LShapeOptions, ModuleArrayOptions>;

/// Its mesh; throws as the function of the shape.
Q8Mesh make_shape(const Shape& shape);

/// How the sizes of a shape are called in case files, in run.json and, with - for _, on the command
/// line. All of them must be given.
template <typename Options>
struct ShapeKeys {
  struct Length {
    const char* key;
    double Options::*member;
    const char* about;
  };
  struct Count {
    const char* key;
    int Options::*member;
    const char* about;
  };
  const char* name;
  const char* about;
  std::vector<Length> lengths;  ///< [m]
  std::vector<Count> counts;
};

/// The keys of each shape; the argument only chooses.
ShapeKeys<DiscOptions> shape_keys(const DiscOptions& shape);
ShapeKeys<RingOptions> shape_keys(const RingOptions& shape);
ShapeKeys<LShapeOptions> shape_keys(const LShapeOptions& shape);
ShapeKeys<ModuleArrayOptions> shape_keys(const ModuleArrayOptions& shape);

}  // namespace floe::mesh
