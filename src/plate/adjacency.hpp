#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <vector>

namespace floe::plate {

/// Lists of whole numbers of different lengths in one array.
struct IndexLists {
  std::vector<Index> begin;  ///< list n is value[begin[n]] … value[begin[n + 1] - 1]
  std::vector<Index> value;
};

/// The elements at each node, rising.
IndexLists elements_of_nodes(Index node_count, const mesh::Connectivity& elements);

/// The nodes that share an element with each node, itself included, rising.
IndexLists neighbours_of_nodes(Index node_count, const mesh::Connectivity& elements);

/// Elements sorted into colours: no two of a colour share a node, so that the elements of one can
/// be added in parallel, and colour after colour in the same order for any number of threads.
IndexLists color_elements(Index node_count, const mesh::Connectivity& elements);

}  // namespace floe::plate
