#define XXH_INLINE_ALL
#include "io/record_store.hpp"

#include "io/atomic_file.hpp"
#include "io/record_names.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>

namespace floe::io {
namespace {

// A sync takes longer than small cases do: a power cut may cost this much work
constexpr std::chrono::seconds kSyncInterval{1};

}  // namespace

std::string record_key(const std::string& identity, const std::string& name) {
  const std::string text = identity + "\n" + name;
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

RecordStore::RecordStore(std::filesystem::path directory, std::string identity, Earlier earlier)
    : directory_(std::move(directory)),
      identity_(std::move(identity)),
      earlier_(earlier),
      synced_at_(std::chrono::steady_clock::now()) {}

std::optional<Record> RecordStore::read(const std::string& name) {
  const std::filesystem::path path = directory_ / name;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path))) return std::nullopt;
  try {
    Record record = Record::read(path);
    if (record.text(kKey) == record_key(identity_, name)) return record;
  } catch (const RecordVersionError&) {
    throw;
  } catch (const StoreError&) {
  }
  set_aside(name);
  return std::nullopt;
}

void RecordStore::set_aside(const std::string& name) {
  const std::filesystem::path from = directory_ / name;
  const std::string aside = kBadRecords + "/" + from.filename().string();
  make_folder(directory_ / kBadRecords);
  if (::rename(from.c_str(), (directory_ / aside).c_str()) != 0)
    throw FileError("cannot write " + (directory_ / aside).string() + ": " + std::strerror(errno));
  damaged_.push_back("record " + from.string() + " is damaged (moved to " + aside + ")");
  set_aside_files_.push_back(aside);
}

void RecordStore::store(const std::string& name, Record record) {
  if (good_.contains(name)) return;
  const std::string bad = record.not_finite();
  FLOE_VALIDATE_AS(ConvergenceError, bad.empty(),
                   "invalid " << bad << " in " << name << " (must be finite)");
  record.put(kKey, record_key(identity_, name));
  record.write(directory_ / name);
  unsynced_.push_back(name);
  if (std::chrono::steady_clock::now() - synced_at_ >= kSyncInterval) sync();
}

void RecordStore::replace(const std::string& name, Record record) {
  good_.erase(name);
  store(name, std::move(record));
}

void RecordStore::sync() {
  if (!unsynced_.empty()) {
    for (const std::string& name : unsynced_) sync_to_disk(directory_ / name);
    sync_to_disk(directory_ / kRecords);
    unsynced_.clear();
  }
  synced_at_ = std::chrono::steady_clock::now();
}

void RecordStore::remove(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    ::unlink((directory_ / name).c_str());
    good_.erase(name);
    std::erase(unsynced_, name);
  }
}

}  // namespace floe::io
