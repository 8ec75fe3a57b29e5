#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace floe::bem {

/// Names a (target, element) pair up to a common shift of both.
struct PairKey {
  std::int32_t element_class;
  std::int64_t x, y;  ///< of the target from the element's first node, in quanta of the mesh
  bool operator==(const PairKey&) const = default;
};

struct PairKeyHash {
  std::size_t operator()(const PairKey& key) const;
};

/// Sorts the elements of a mesh into classes that are equal but for a shift, to 1e-9 of the mesh's
/// smallest element: equal pairs of target and element have equal integrals.
class ElementClasses {
 public:
  /// Keeps a view of the mesh.
  explicit ElementClasses(const mesh::Q8Mesh& mesh);

  Index count() const { return count_; }
  PairKey key(Index node, Index element) const;

 private:
  const mesh::Q8Mesh& mesh_;  // view
  double quantum_;            // [m]
  std::vector<std::int32_t> class_;
  Index count_ = 0;
};

}  // namespace floe::bem
