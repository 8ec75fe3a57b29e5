#pragma once

#include "mesh/half_edges.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <span>

namespace floe::mesh {

/// No two elements overlap, and none touches another without sharing a node or a whole edge.
///
/// Elements with det J > 0 that lie on the two sides of their shared edges form a sheet that can
/// cover a place twice in three ways only, and these are tested:
///   the elements around a node fill more than 2π;
///   two boundary edges cross;
///   a boundary lies inside an element of another part of the sheet.
/// So, but for the angles, work is spent at the boundary only. A boundary node within `tolerance`
/// [m] of a boundary edge that it does not belong to hangs there (T-junction, unmerged pieces).
void check_overlap(const Points2& nodes, const Connectivity& elements,
                   std::span<const HalfEdge> half_edges, double tolerance,
                   const MeshLabels& labels);

}  // namespace floe::mesh
