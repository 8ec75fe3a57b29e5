#define XXH_INLINE_ALL
#include <floe/mesh/mesh_hash.hpp>

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <memory>

namespace floe::mesh {

namespace {

class Hash {
 public:
  Hash() : state_(XXH3_createState()) {
    if (state_ == nullptr) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
  }
  template <typename Value>
  void add(const Value* values, Index count) {
    XXH3_128bits_update(state_.get(), values, static_cast<std::size_t>(count) * sizeof(Value));
  }
  std::string text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

}  // namespace

std::string mesh_hash(const Q8Mesh& mesh) {
  Hash hash;
  const std::int64_t counts[] = {mesh.node_count(), mesh.element_count()};
  hash.add(counts, 2);
  hash.add(mesh.nodes().data(), mesh.nodes().size());
  hash.add(mesh.elements().data(), mesh.elements().size());
  return hash.text();
}

std::string group_hash(const Q8Mesh& mesh) {
  Hash hash;
  for (const ElementGroup& group : mesh.groups()) {
    const std::int64_t counts[] = {std::ssize(group.name), std::ssize(group.elements)};
    hash.add(counts, 2);
    hash.add(group.name.data(), std::ssize(group.name));
    hash.add(group.elements.data(), std::ssize(group.elements));
  }
  return hash.text();
}

}  // namespace floe::mesh
