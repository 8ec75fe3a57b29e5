#include "mesh/generation.hpp"

#include <floe/mesh/ring.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>
#include <numbers>

namespace floe::mesh {
namespace {

constexpr int kFewestAround = 8;

}  // namespace

Q8Mesh make_ring(const RingOptions& options) {
  demand_positive(options.inner_radius, "ring inner_radius");
  demand_positive(options.outer_radius, "ring outer_radius");
  demand_positive(options.element_size, "ring element_size");
  FLOE_VALIDATE(options.inner_radius < options.outer_radius,
                "invalid ring inner_radius = " << options.inner_radius
                                               << " m (must be less than outer_radius = "
                                               << options.outer_radius << " m)");

  // Layers whose radii have one ratio, the outermost as thick as its arcs are long
  const int around =
      std::max(kFewestAround, count_parts(2.0 * std::numbers::pi * options.outer_radius,
                                          options.element_size, "ring size"));
  const double angle = 2.0 * std::numbers::pi / around;
  const double span = std::log(options.outer_radius / options.inner_radius);
  const int layers = count_parts(span, -std::log1p(-angle), "ring size");
  demand_few_elements(static_cast<double>(around) * layers, "ring size");

  const auto radius = [&](int layer) {
    if (layer == layers) return options.outer_radius;
    return options.inner_radius * std::exp(span * layer / layers);
  };
  const auto place = [&](int i, int j) -> Point2 {
    const double r = 0.5 * (radius(j / 2) + radius((j + 1) / 2));
    return r * Point2(std::cos(0.5 * angle * i), std::sin(0.5 * angle * i));
  };
  MeshBuilder builder;
  std::vector<Index> innermost;
  for (int i = 0; i < 2 * around; ++i) innermost.push_back(builder.add_node(place(i, 0)));
  add_layers(builder, innermost, layers, place);
  return builder.finish();
}

}  // namespace floe::mesh
