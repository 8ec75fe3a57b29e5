#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Arrays as short text inside JSON: base64 of little-endian numbers.
namespace floe::io {

/// {"type": "f32", "base64": …}; relative error 6e-8.
nlohmann::ordered_json packed_floats(std::span<const double> values);

/// {"type": "i16", "scale": s, "base64": …}, value = scale · integer; error at most
/// max|value|/65534. Half the size of floats.
nlohmann::ordered_json packed_short(std::span<const double> values);

/// {"type": "u32", "base64": …}
nlohmann::ordered_json packed_indices(std::span<const std::uint32_t> values);

/// RFC 4648, with padding.
std::string base64(std::span<const std::byte> bytes);

}  // namespace floe::io
