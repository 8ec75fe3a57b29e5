#include "bem/congruence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace floe::bem {

std::size_t PairKeyHash::operator()(const PairKey& key) const {
  // Multiplications by odd constants, high bits folded down
  std::uint64_t hash = static_cast<std::uint64_t>(key.x) * 0x9e3779b97f4a7c15ULL;
  hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(key.y)) * 0xc2b2ae3d27d4eb4fULL;
  hash =
      (hash ^ (hash >> 29) ^ static_cast<std::uint64_t>(key.element_class)) * 0x165667b19e3779f9ULL;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

ElementClasses::ElementClasses(const mesh::Q8Mesh& mesh)
    : mesh_(mesh), class_(mesh.element_count()) {
  double smallest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    smallest =
        std::min(smallest, (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).minCoeff());
  }
  // Coordinates are known to some 1e-16 of the mesh's size: a finer quantum would part equal ones
  quantum_ = std::max(1e-9 * smallest, 1e-13 * mesh.size());

  std::map<std::array<std::int64_t, 14>, std::int32_t> known;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    std::array<std::int64_t, 14> shape;
    for (int m = 1; m < 8; ++m)
      for (int axis = 0; axis < 2; ++axis)
        shape[2 * (m - 1) + axis] = std::llround((nodes(axis, m) - nodes(axis, 0)) / quantum_);
    class_[e] = known.try_emplace(shape, static_cast<std::int32_t>(known.size())).first->second;
  }
  count_ = static_cast<Index>(known.size());
}

PairKey ElementClasses::key(Index node, Index element) const {
  const Point2 offset = mesh_.nodes().col(node) - mesh_.nodes().col(mesh_.elements()(0, element));
  return {class_[element], std::llround(offset.x() / quantum_),
          std::llround(offset.y() / quantum_)};
}

}  // namespace floe::bem
