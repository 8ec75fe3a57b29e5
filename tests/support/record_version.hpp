#pragma once

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstring>
#include <string>

namespace floe::test {

/// The bytes of a record as a later floe would write them: whole, but of another format version.
inline std::string with_version(std::string record, char version) {
  constexpr std::size_t kVersionAt = 8, kChecksumAt = 24, kPayloadAt = 40;
  record[kVersionAt] = version;
  const XXH128_hash_t before = XXH3_128bits(record.data(), kChecksumAt);
  const XXH128_hash_t hash = XXH3_128bits_withSeed(
      record.data() + kPayloadAt, record.size() - kPayloadAt, before.low64 ^ before.high64);
  std::memcpy(record.data() + kChecksumAt, &hash.low64, sizeof hash.low64);
  std::memcpy(record.data() + kChecksumAt + 8, &hash.high64, sizeof hash.high64);
  return record;
}

}  // namespace floe::test
