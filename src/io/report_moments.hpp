#pragma once

#include <floe/io/report.hpp>
#include <floe/mesh/drawing.hpp>

#include <nlohmann/json.hpp>

namespace floe::io {

/// Bending moments of every shape (3N × shapes) at the drawn nodes, {"x": […], "y": […]}, one
/// packed array a shape [N m/m per unit of it], so that the page can map the moment of any wave as
/// Σ ξ_j M_j. Null where they are not known: of a structure of another program, or of regions whose
/// mesh has gone.
nlohmann::ordered_json moments_json(const ReportContent& content, const MatXd& shapes,
                                    const mesh::Drawing& drawing);

}  // namespace floe::io
