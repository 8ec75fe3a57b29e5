#pragma once

#include <string_view>

namespace floe::mesh {

/// The panel mesh of a hull that the bytes begin as, by the layout of the first lines: "WAMIT
/// .gdf", "NEMOH .dat", "HAMS .pnl"; empty if none.
std::string_view hull_format(std::string_view bytes);

}  // namespace floe::mesh
