#pragma once

#include "io/record.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace floe::io {

/// Whether records of an earlier run of the same case are taken over.
enum class Earlier { kUse, kIgnore };

/// The entry of a record that holds its key, and the key of one of that name and case.
inline const std::string kKey = "key";
std::string record_key(const std::string& identity, const std::string& name);

/// The records of one run: what an earlier run left, and what this one adds. Every record carries a
/// key of the case and of its own name, so that one of another case or place is noticed.
class RecordStore final {
 public:
  /// `identity` is a text that is the same for the same case only.
  RecordStore(std::filesystem::path directory, std::string identity, Earlier earlier);

  /// A record of the earlier run, decoded; nothing where it is missing. One that is damaged or of
  /// another case is moved to records/bad/, told in `damaged`, and nothing as well. Throws
  /// StoreError for one of another format version.
  template <typename Decode>
  auto known(const std::string& name, Decode decode) -> std::optional<decltype(decode(Record()))> {
    if (earlier_ == Earlier::kIgnore) return std::nullopt;
    const std::optional<Record> record = read(name);
    if (!record) return std::nullopt;
    try {
      auto value = decode(*record);
      good_.insert(name);
      return value;
    } catch (const StoreError&) {  // an entry is missing
      set_aside(name);
      return std::nullopt;
    }
  }

  /// The same for whether it is there and good.
  bool knows(const std::string& name) {
    return known(name, [](const Record&) { return true; }).has_value();
  }

  /// Writes the record; one of the earlier run that was read well stays. At most a second later it
  /// is synced with its folder. Throws ConvergenceError for a number that is not finite, FileError.
  void store(const std::string& name, Record record);
  /// The same over one of the earlier run, too.
  void replace(const std::string& name, Record record);
  /// Everything stored so far survives a power cut from here on.
  void sync();
  /// Deletes records, those that are there.
  void remove(const std::vector<std::string>& names);

  /// One sentence a record that was set aside.
  const std::vector<std::string>& damaged() const { return damaged_; }
  /// Names of the records that were set aside, relative to the directory.
  const std::vector<std::string>& set_aside_files() const { return set_aside_files_; }

 private:
  std::optional<Record> read(const std::string& name);
  void set_aside(const std::string& name);

  std::filesystem::path directory_;
  std::string identity_;
  Earlier earlier_;
  std::set<std::string> good_;  // records of the earlier run that were read
  std::vector<std::string> damaged_, set_aside_files_, unsynced_;
  std::chrono::steady_clock::time_point synced_at_;
};

}  // namespace floe::io
