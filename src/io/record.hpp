#pragma once

#include <floe/numeric/error.hpp>
#include <floe/numeric/types.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace floe::io {

/// A record of another format version (exit code 9).
class RecordVersionError : public StoreError {
 public:
  using StoreError::StoreError;
};

/// Named numbers, matrices and texts in one checksummed file: what a run keeps of its work. Layout:
/// magic, format version, byte order, length of the payload, XXH3-128 of all of that and of the
/// payload, payload; a later version keeps this much. Written beside its name and renamed, so that
/// a reader sees all of it or nothing; what a power cut does to the last ones, the checksum tells.
class Record {
 public:
  void put(const std::string& name, const Eigen::Ref<const MatXd>& values);
  void put(const std::string& name, const Eigen::Ref<const MatXcd>& values);
  void put(const std::string& name, double value);
  void put(const std::string& name, const std::string& text);

  /// Throw StoreError when there is no such entry or it is of another kind.
  MatXd real(const std::string& name) const;
  MatXcd complex(const std::string& name) const;
  double number(const std::string& name) const;
  std::string text(const std::string& name) const;
  bool holds(const std::string& name) const { return entries_.contains(name); }
  /// Name of an entry that holds a number that is not finite; "" if there is none.
  std::string not_finite() const;
  /// Whether all entries but those `ignored` are the same, bit for bit.
  bool same_as(const Record& other, const std::vector<std::string>& ignored) const;

  /// Throws FileError when writing fails.
  void write(const std::filesystem::path& path) const;
  /// Throws StoreError when the file is not there, cut off or changed in any bit,
  /// RecordVersionError for another version. Allocates no more than the file is long.
  static Record read(const std::filesystem::path& path);

 private:
  enum class Kind : char { kReal = 'd', kComplex = 'z', kText = 't' };
  struct Entry {
    Kind kind;
    Index rows, columns;
    std::string bytes;
    bool operator==(const Entry&) const = default;
  };
  const Entry& entry(const std::string& name, Kind kind) const;
  void put(const std::string& name, Kind kind, Index rows, Index columns, std::string bytes);
  std::string payload() const;
  static Record parse(std::string_view payload, const std::filesystem::path& path);

  std::map<std::string, Entry> entries_;
};

}  // namespace floe::io
