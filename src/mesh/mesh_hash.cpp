#define XXH_INLINE_ALL
#include <floe/mesh/mesh_hash.hpp>

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <memory>

namespace floe::mesh {

namespace {

std::string text_of(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string mesh_hash(const Q8Mesh& mesh) {
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  const std::unique_ptr<XXH3_state_t, Free> state(XXH3_createState());
  if (state == nullptr) throw std::bad_alloc();
  const auto add = [&](const auto* values, Index count) {
    XXH3_128bits_update(state.get(), values, static_cast<std::size_t>(count) * sizeof(*values));
  };
  XXH3_128bits_reset(state.get());
  const std::int64_t counts[] = {mesh.node_count(), mesh.element_count()};
  add(counts, 2);
  add(mesh.nodes().data(), mesh.nodes().size());
  add(mesh.elements().data(), mesh.elements().size());
  return text_of(XXH3_128bits_digest(state.get()));
}

std::string hash_of(const std::vector<int>& of_element) {
  return text_of(XXH3_128bits(of_element.data(), of_element.size() * sizeof(int)));
}

}  // namespace floe::mesh
