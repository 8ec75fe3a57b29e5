#include "io/packed_array.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace floe::io {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are packed little-endian");

constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    unsigned group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8 | (i < count ? std::to_integer<unsigned>(bytes[at + i]) : 0u);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += digit <= count ? kDigits[group >> (18 - 6 * digit) & 63u] : '=';
  }
  return text;
}

nlohmann::ordered_json packed_floats(std::span<const double> values) {
  std::vector<float> floats(values.begin(), values.end());
  return {{"type", "f32"}, {"base64", base64(std::as_bytes(std::span<const float>(floats)))}};
}

nlohmann::ordered_json packed_short(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const double scale = largest > 0.0 && std::isfinite(largest) ? largest / 32767.0 : 1.0;
  std::vector<std::int16_t> integers(values.size());
  std::transform(values.begin(), values.end(), integers.begin(), [&](double value) {
    return std::isfinite(value) ? static_cast<std::int16_t>(std::lround(value / scale))
                                : std::int16_t{0};
  });
  return {{"type", "i16"},
          {"scale", scale},
          {"base64", base64(std::as_bytes(std::span<const std::int16_t>(integers)))}};
}

nlohmann::ordered_json packed_indices(std::span<const std::uint32_t> values) {
  return {{"type", "u32"}, {"base64", base64(std::as_bytes(values))}};
}

}  // namespace floe::io
