#include "bem/node_lattices.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <limits>

namespace floe::bem {
namespace {

// Lattice of each local node, its place as seen from the cell, and the side of the node on which
// the element lies, of four
struct LocalPlace {
  int lattice, dx, dy, side;
};
enum Side : int { kRightUpper, kLeftUpper, kRightLower, kLeftLower };
constexpr LocalPlace kLocal[8] = {
    {kCorners, 0, 0, kRightUpper},         {kCorners, 1, 0, kLeftUpper},
    {kCorners, 1, 1, kLeftLower},          {kCorners, 0, 1, kRightLower},
    {kHorizontalSides, 0, 0, kRightUpper}, {kHorizontalSides, 0, 1, kRightLower},
    {kVerticalSides, 0, 0, kRightUpper},   {kVerticalSides, 1, 0, kLeftUpper}};

// Elements around the points of a lattice, a bit a side
using Surroundings = std::vector<std::uint8_t>;

double moment_of(std::uint8_t sides, const SourceKind& source) {
  double sum = 0.0;
  for (const int side : {kRightUpper, kLeftUpper, kRightLower, kLeftLower}) {
    if (!(sides >> side & 1)) continue;
    const double sign_x = source.odd_x && side % 2 == 1 ? -1.0 : 1.0;
    const double sign_y = source.odd_y && side >= 2 ? -1.0 : 1.0;
    sum += sign_x * sign_y;
  }
  return sum / (source.lattice == kCorners ? 4.0 : 2.0);
}

// Sorts the nodes by line
OutlineNodes group_by_line(std::vector<OutlineNode> nodes, bool lines_along_x) {
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const OutlineNode& a, const OutlineNode& b) { return a.line < b.line; });
  OutlineNodes outline;
  outline.lines_along_x = lines_along_x;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (k == 0 || nodes[k].line != nodes[k - 1].line) {
      outline.line.push_back(nodes[k].line);
      outline.line_begin.push_back(static_cast<Index>(k));
    }
  outline.line_begin.push_back(static_cast<Index>(nodes.size()));
  outline.node = std::move(nodes);
  return outline;
}

OutlineNodes outline_nodes(const NodeLattice& lattice, const Surroundings& sides,
                           const SourceKind& source) {
  const bool odd = source.odd_x || source.odd_y;
  std::vector<OutlineNode> rows, columns;
  for (Index j = 0; j < lattice.ny; ++j)
    for (Index i = 0; i < lattice.nx; ++i) {
      const auto at = static_cast<std::size_t>(i + lattice.nx * j);
      const double moment = moment_of(sides[at], source);
      if (lattice.node[at] < 0 || moment == (odd ? 0.0 : 1.0)) continue;
      rows.push_back({j, i, lattice.node[at], moment});
      columns.push_back({i, j, lattice.node[at], moment});
    }
  OutlineNodes by_row = group_by_line(std::move(rows), true);
  if (!odd) return by_row;
  OutlineNodes by_column = group_by_line(std::move(columns), false);
  if (std::min(by_row.line.size(), by_column.line.size()) > kMostLines) return by_row;
  return by_column.line.size() < by_row.line.size() ? by_column : by_row;
}

}  // namespace

NodeLattices::NodeLattices(const ElementLattice& elements) {
  FLOE_VALIDATE(elements.connectivity.maxCoeff() < std::numeric_limits<std::int32_t>::max(),
                "invalid number of nodes (must be below 2^31)");
  std::array<Surroundings, kNodeLattices> surroundings;
  for (int s = 0; s < kNodeLattices; ++s) {
    lattice[s].nx = elements.nx + (kHalfX[s] ? 0 : 1);
    lattice[s].ny = elements.ny + (kHalfY[s] ? 0 : 1);
    lattice[s].node.assign(static_cast<std::size_t>(lattice[s].nx * lattice[s].ny), -1);
    surroundings[s].assign(lattice[s].node.size(), 0);
  }
  for (Index e = 0; e < elements.cell.cols(); ++e)
    for (int l = 0; l < 8; ++l) {
      const LocalPlace& local = kLocal[l];
      const auto at =
          static_cast<std::size_t>(elements.cell(0, e) + local.dx +
                                   lattice[local.lattice].nx * (elements.cell(1, e) + local.dy));
      lattice[local.lattice].node[at] = static_cast<std::int32_t>(elements.connectivity(l, e));
      surroundings[local.lattice][at] |= static_cast<std::uint8_t>(1 << local.side);
    }
  for (int p = 0; p < kSources; ++p) {
    const int s = kSource[p].lattice;
    outline[p] = outline_nodes(lattice[s], surroundings[s], kSource[p]);
  }
}

double NodeLattices::memory() const {
  std::size_t bytes = 0;
  for (const NodeLattice& nodes : lattice) bytes += sizeof(nodes.node[0]) * nodes.node.size();
  for (const OutlineNodes& nodes : outline) bytes += sizeof(OutlineNode) * nodes.node.size();
  return static_cast<double>(bytes);
}

}  // namespace floe::bem
