#include "plate/adjacency.hpp"

#include <algorithm>

namespace floe::plate {
namespace {

void gather_neighbours(const IndexLists& at_node, const mesh::Connectivity& elements, Index node,
                       std::vector<Index>& found) {
  found.clear();
  for (Index k = at_node.begin[node]; k < at_node.begin[node + 1]; ++k)
    for (int a = 0; a < 8; ++a) found.push_back(elements(a, at_node.value[k]));
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

void accumulate(std::vector<Index>& begin) {
  for (std::size_t n = 1; n < begin.size(); ++n) begin[n] += begin[n - 1];
}

}  // namespace

IndexLists elements_of_nodes(Index node_count, const mesh::Connectivity& elements) {
  IndexLists lists;
  lists.begin.assign(node_count + 1, 0);
  for (Index e = 0; e < elements.cols(); ++e)
    for (int a = 0; a < 8; ++a) ++lists.begin[elements(a, e) + 1];
  accumulate(lists.begin);
  lists.value.resize(lists.begin.back());
  std::vector<Index> next(lists.begin.begin(), lists.begin.end() - 1);
  for (Index e = 0; e < elements.cols(); ++e)
    for (int a = 0; a < 8; ++a) lists.value[next[elements(a, e)]++] = e;
  return lists;
}

IndexLists neighbours_of_nodes(Index node_count, const mesh::Connectivity& elements) {
  const IndexLists at_node = elements_of_nodes(node_count, elements);
  IndexLists lists;
  lists.begin.assign(node_count + 1, 0);
  // Count, then fill: the lists are gathered twice, which is cheaper than keeping them apart
#pragma omp parallel
  {
    std::vector<Index> found;
#pragma omp for schedule(static)
    for (Index n = 0; n < node_count; ++n) {
      gather_neighbours(at_node, elements, n, found);
      lists.begin[n + 1] = static_cast<Index>(found.size());
    }
#pragma omp single
    {
      accumulate(lists.begin);
      lists.value.resize(lists.begin.back());
    }
#pragma omp for schedule(static)
    for (Index n = 0; n < node_count; ++n) {
      gather_neighbours(at_node, elements, n, found);
      std::copy(found.begin(), found.end(), lists.value.begin() + lists.begin[n]);
    }
  }
  return lists;
}

IndexLists color_elements(Index node_count, const mesh::Connectivity& elements) {
  // Give each element the lowest colour that none of its nodes has seen
  std::vector<std::vector<bool>> seen;
  std::vector<Index> color(elements.cols());
  for (Index e = 0; e < elements.cols(); ++e) {
    std::size_t c = 0;
    const auto is_taken = [&] {
      for (int a = 0; a < 8; ++a)
        if (seen[c][elements(a, e)]) return true;
      return false;
    };
    while (c < seen.size() && is_taken()) ++c;
    if (c == seen.size()) seen.emplace_back(node_count, false);
    for (int a = 0; a < 8; ++a) seen[c][elements(a, e)] = true;
    color[e] = static_cast<Index>(c);
  }

  // Sort the elements by colour
  IndexLists lists;
  lists.begin.assign(seen.size() + 1, 0);
  for (const Index c : color) ++lists.begin[c + 1];
  accumulate(lists.begin);
  lists.value.resize(elements.cols());
  std::vector<Index> next(lists.begin.begin(), lists.begin.end() - 1);
  for (Index e = 0; e < elements.cols(); ++e) lists.value[next[color[e]]++] = e;
  return lists;
}

}  // namespace floe::plate
