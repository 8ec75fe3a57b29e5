#include "bem/near_pattern.hpp"

#include "bem/congruence.hpp"

#include <floe/mesh/box_tree.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <unordered_map>

namespace floe::bem {
namespace {

double longest_extent(const Eigen::Matrix<double, 2, 8>& nodes) {
  double longest =
      std::max((nodes.col(5) - nodes.col(7)).norm(), (nodes.col(6) - nodes.col(4)).norm());
  for (int side = 0; side < 4; ++side)
    longest = std::max(longest, (nodes.col(side) - nodes.col((side + 1) % 4)).norm());
  return longest;
}

// Elements near each node by their distance
std::vector<std::vector<std::int32_t>> elements_within(const mesh::Q8Mesh& mesh,
                                                       const mesh::BoxTree& nodes, double radius) {
  std::vector<std::vector<std::int32_t>> near(mesh.node_count());
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto corners = mesh.element_nodes(e);
    const Point2 centre = corners * mesh::q8_shape(0.0, 0.0);
    const double reach = radius * longest_extent(corners);
    nodes.visit(mesh::box_around(centre, reach), [&](Index node) {
      if ((mesh.nodes().col(node) - centre).norm() <= reach)
        near[node].push_back(static_cast<std::int32_t>(e));
    });
  }
  return near;
}

void sort_unique(std::vector<std::int32_t>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

NearPattern::NearPattern(const mesh::Q8Mesh& mesh, double radius) {
  find_pairs(mesh, radius);
  number_kinds(mesh);
  number_entries(mesh);
}

void NearPattern::find_pairs(const mesh::Q8Mesh& mesh, double radius) {
  const Index count = mesh.node_count();
  std::vector<mesh::Box> boxes;
  for (Index i = 0; i < count; ++i) boxes.push_back(mesh::box_around(mesh.nodes().col(i), 0.0));
  const mesh::BoxTree tree(boxes);
  target_.assign(tree.order().begin(), tree.order().end());

  const std::vector<std::vector<std::int32_t>> near = elements_within(mesh, tree, radius);
  pair_begin_.assign(count + 1, 0);
  for (Index row = 0; row < count; ++row)
    pair_begin_[row + 1] = pair_begin_[row] + near[target_[row]].size();
  pair_element_.reserve(pair_begin_.back());
  for (Index row = 0; row < count; ++row)
    pair_element_.insert(pair_element_.end(), near[target_[row]].begin(), near[target_[row]].end());
}

void NearPattern::number_kinds(const mesh::Q8Mesh& mesh) {
  // Where hardly two elements are equal, looking for equal pairs costs more than it saves
  const ElementClasses classes(mesh);
  if (4 * classes.count() >= mesh.element_count()) return;
  pair_kind_.resize(pair_element_.size());
  std::unordered_map<PairKey, std::int32_t, PairKeyHash> known;
  for (Index row = 0; row < rows(); ++row)
    for (std::size_t k = pair_begin_[row]; k < pair_begin_[row + 1]; ++k) {
      const auto next = static_cast<std::int32_t>(kinds_.size());
      pair_kind_[k] =
          known.try_emplace(classes.key(target_[row], pair_element_[k]), next).first->second;
      if (pair_kind_[k] == next) kinds_.push_back({target_[row], pair_element_[k]});
    }
}

void NearPattern::number_entries(const mesh::Q8Mesh& mesh) {
  // Collect the columns of each row, then of each block
  std::vector<std::vector<std::int32_t>> row_columns(rows());
#pragma omp parallel for schedule(dynamic, 64)
  for (Index row = 0; row < rows(); ++row) {
    for (const std::int32_t element : near_elements(row))
      for (int m = 0; m < 8; ++m)
        row_columns[row].push_back(static_cast<std::int32_t>(mesh.elements()(m, element)));
    sort_unique(row_columns[row]);
  }
  entry_begin_.assign(rows() + 1, 0);
  for (Index row = 0; row < rows(); ++row)
    entry_begin_[row + 1] = entry_begin_[row] + row_columns[row].size();
  entry_column_.resize(entry_begin_.back());

  column_begin_.assign(1, 0);
  for (Index block = 0; block < blocks(); ++block) {
    std::vector<std::int32_t> columns;
    const Index first = block * kBlockRows, last = std::min(rows(), first + kBlockRows);
    for (Index row = first; row < last; ++row)
      columns.insert(columns.end(), row_columns[row].begin(), row_columns[row].end());
    sort_unique(columns);
    FLOE_VALIDATE_AS(BudgetError, columns.size() <= 65536,
                     "invalid near field = " << columns.size()
                                             << " nodes near one place (must be at most 65536; let "
                                                "elements grow less from one to the next)");
    for (Index row = first; row < last; ++row)
      for (std::size_t k = 0; k < row_columns[row].size(); ++k)
        entry_column_[entry_begin_[row] + k] = static_cast<std::uint16_t>(
            std::lower_bound(columns.begin(), columns.end(), row_columns[row][k]) -
            columns.begin());
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    column_begin_.push_back(columns_.size());
  }
}

void NearPattern::place_entries(Index block, Index row,
                                std::vector<std::int32_t>& entry_of_node) const {
  const auto nodes = columns(block);
  const std::size_t begin = entry_begin(row), end = entry_begin(row + 1);
  for (std::size_t k = begin; k < end; ++k)
    entry_of_node[nodes[entry_column_[k]]] = static_cast<std::int32_t>(k - begin);
}

double NearPattern::memory() const {
  return 4.0 * static_cast<double>(target_.size() + pair_element_.size() + pair_kind_.size() +
                                   columns_.size() + 2 * kinds_.size()) +
         8.0 *
             static_cast<double>(pair_begin_.size() + entry_begin_.size() + column_begin_.size()) +
         2.0 * static_cast<double>(entry_column_.size());
}

}  // namespace floe::bem
