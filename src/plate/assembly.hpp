#pragma once

#include <floe/plate/mindlin.hpp>

#include <vector>

/// Assembly over nodes and elements that need not be a whole mesh (one piece of it).
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

PlateMatrices assemble(const Points2& nodes, const mesh::Connectivity& elements,
                       const PlateProperties& properties);

}  // namespace floe::plate
