#pragma once

#include <floe/io/report.hpp>
#include <floe/mesh/drawing.hpp>

#include <nlohmann/json.hpp>

namespace floe::io {

/// Bending moments of every mode at the drawn nodes, {"x": […], "y": […]}, one packed array a mode
/// [N m/m per unit of the mode], so that the page can map the moment of any wave as Σ ξ_j M_j.
nlohmann::ordered_json moments_json(const ReportContent& content, const mesh::Drawing& drawing);

}  // namespace floe::io
