#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <string>
#include <vector>

namespace floe::mesh {

/// Fingerprint of a mesh: XXH3-128 over the node and element counts, the coordinates and the
/// connectivity as they are stored, 32 hexadecimal digits. Equal meshes with equal numbering have
/// equal hashes; the last bit of a coordinate changes it.
std::string mesh_hash(const Q8Mesh& mesh);

/// The same of whole numbers, one an element.
std::string hash_of(const std::vector<int>& of_element);

}  // namespace floe::mesh
