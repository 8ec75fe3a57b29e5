#include "mesh/generation.hpp"

#include <floe/numeric/error.hpp>

#include <cmath>

namespace floe::mesh {
namespace {

constexpr double kMostElements = 1e8;
constexpr double kFit = 1e-9;  // of a part

}  // namespace

void demand_positive(double value, const std::string& what) {
  FLOE_VALIDATE(value > 0.0 && std::isfinite(value),
                "invalid " << what << " = " << value << " m (must be positive)");
}

void demand_few_elements(double count, const std::string& what) {
  FLOE_VALIDATE(count <= kMostElements,
                "invalid " << what << " = " << count << " elements (must be at most 1e8 in all)");
}

int count_parts(double length, double part, const std::string& what) {
  const double count = std::max(1.0, std::ceil(length / part * (1.0 - kFit)));
  demand_few_elements(count, what);
  return static_cast<int>(count);
}

bool fits(double other, double length, int count) {
  const double parts = other / length * count;
  return std::abs(parts - std::round(parts)) <= kFit && std::round(parts) >= 1.0;
}

Index MeshBuilder::add_node(const Point2& point) {
  nodes.push_back(point);
  return static_cast<Index>(nodes.size()) - 1;
}

Q8Mesh MeshBuilder::finish() const {
  Points2 points(2, static_cast<Index>(nodes.size()));
  for (Index n = 0; n < points.cols(); ++n) points.col(n) = nodes[n];
  Connectivity connectivity(8, static_cast<Index>(elements.size()));
  for (Index e = 0; e < connectivity.cols(); ++e) connectivity.col(e) = elements[e];
  return Q8Mesh(std::move(points), std::move(connectivity));
}

void add_layers(MeshBuilder& builder, const std::vector<Index>& innermost, int layers,
                const std::function<Point2(int, int)>& place) {
  const int steps = static_cast<int>(innermost.size());
  std::vector<Index> inner = innermost, middle(steps), outer(steps);
  for (int layer = 0; layer < layers; ++layer) {
    for (int i = 0; i < steps; i += 2) middle[i] = builder.add_node(place(i, 2 * layer + 1));
    for (int i = 0; i < steps; ++i) outer[i] = builder.add_node(place(i, 2 * layer + 2));
    for (int i = 0; i < steps; i += 2) {
      const int next = (i + 2) % steps;
      builder.elements.push_back({inner[i], outer[i], outer[next], inner[next], middle[i],
                                  outer[i + 1], middle[next], inner[i + 1]});
    }
    inner = outer;
  }
}

}  // namespace floe::mesh
