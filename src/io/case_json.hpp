#pragma once

#include <floe/analysis.hpp>

#include <nlohmann/json.hpp>

namespace floe::io {

/// The case as it was understood, all defaults filled in: `options` of run.json.
nlohmann::ordered_json case_json(const Case& data);

/// Back from that; seas, which it tells in words only, are left out.
/// Throws StoreError when something is missing.
Case case_from_json(const nlohmann::ordered_json& options);

}  // namespace floe::io
