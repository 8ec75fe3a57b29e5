#pragma once

#include <floe/plate/mindlin.hpp>

namespace floe::plate {

/// assemble_plate over nodes and elements that need not be a whole mesh: one piece of it.
PlateMatrices assemble(const Points2& nodes, const mesh::Connectivity& elements,
                       const PlateRegions& regions);

}  // namespace floe::plate
