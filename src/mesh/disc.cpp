#include "mesh/generation.hpp"

#include <floe/mesh/disc.hpp>

#include <cmath>
#include <numbers>

namespace floe::mesh {
namespace {

// Distance of the core's corners from the centre, relative to the radius; keeps the worst aspect
// ratio, and from two layers on the jumps between neighbours, below 2
constexpr double kCore = 0.65;
// Half the angle of the core's sides, arcs: makes its corners 120° wide
constexpr double kHalfAngle = std::numbers::pi / 12.0;

/// The core: the square [-1, 1]² with its sides bent to arcs, filled by blending opposite sides.
class Core {
 public:
  explicit Core(double radius)
      : corner_(kCore * radius / std::numbers::sqrt2), arc_(corner_ / std::sin(kHalfAngle)) {}

  Point2 at(double u, double v) const {
    return {along(u) + u * (height(v) - corner_), along(v) + v * (height(u) - corner_)};
  }
  double height(double u) const {
    return corner_ + arc_ * (std::cos(u * kHalfAngle) - std::cos(kHalfAngle));
  }

 private:
  double along(double u) const { return arc_ * std::sin(u * kHalfAngle); }

  double corner_;  // both coordinates of the corner at (1, 1)
  double arc_;     // radius of the sides
};

// Adds the n × n elements of the core; returns the nodes of its outline, from the lower left
// corner counter-clockwise
std::vector<Index> add_core(MeshBuilder& builder, const Core& core, int n) {
  const int side = 2 * n + 1;
  std::vector<Index> number(static_cast<std::size_t>(side) * side, -1);
  const auto at = [&](int i, int j) -> Index& {
    return number[static_cast<std::size_t>(j) * side + i];
  };
  const auto share = [&](int i) { return static_cast<double>(i - n) / n; };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      if (i % 2 == 0 || j % 2 == 0) at(i, j) = builder.add_node(core.at(share(i), share(j)));
  for (int j = 0; j < side - 1; j += 2)
    for (int i = 0; i < side - 1; i += 2)
      builder.elements.push_back({at(i, j), at(i + 2, j), at(i + 2, j + 2), at(i, j + 2),
                                  at(i + 1, j), at(i + 2, j + 1), at(i + 1, j + 2), at(i, j + 1)});
  std::vector<Index> outline;
  for (int i = 0; i < 2 * n; ++i) outline.push_back(at(i, 0));
  for (int j = 0; j < 2 * n; ++j) outline.push_back(at(2 * n, j));
  for (int i = 2 * n; i > 0; --i) outline.push_back(at(i, 2 * n));
  for (int j = 2 * n; j > 0; --j) outline.push_back(at(0, j));
  return outline;
}

}  // namespace

Q8Mesh make_disc(const DiscOptions& options) {
  demand_positive(options.radius, "disc radius");
  demand_positive(options.element_size, "disc element_size");

  // The longest edges are those on the circle and those in the middle of the core's sides outwards
  const Core core(options.radius);
  const int n =
      count_parts(0.5 * std::numbers::pi * options.radius, options.element_size, "disc size");
  const int layers =
      count_parts(options.radius - core.height(0.0), options.element_size, "disc size");
  demand_few_elements(static_cast<double>(n) * (n + 4.0 * layers), "disc size");

  // Go straight from the core's outline to the circle
  MeshBuilder builder;
  const std::vector<Index> outline = add_core(builder, core, n);
  add_layers(builder, outline, layers, [&](int i, int j) -> Point2 {
    const double angle = std::numbers::pi * (-0.75 + 0.25 * i / n);
    const Point2 rim = options.radius * Point2(std::cos(angle), std::sin(angle));
    const double share = 0.5 * j / layers;
    return j == 2 * layers ? rim : (1.0 - share) * builder.nodes[outline[i]] + share * rim;
  });
  return builder.finish();
}

}  // namespace floe::mesh
