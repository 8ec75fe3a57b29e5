#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace floe::io {

/// Whether a file is to survive a power cut that follows at once.
enum class Sync { kYes, kNo };

/// A file that appears under its name only when it is complete: it grows as `NAME.tmp.PID` beside
/// it and is renamed over it. A symbolic link of that name is replaced, its target left alone.
/// Every failure throws FileError with the file's name and the system's text.
class AtomicFile final {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();  ///< removes what was not committed
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(std::string_view bytes);
  /// Hands everything to the system and remembers this length as good.
  void mark();
  /// Drops what was written since the last mark.
  void rollback();
  /// Writes out, syncs unless told not to, and renames. Without a sync a power cut may leave less
  /// than the whole under the name; a killed process does not.
  void commit(Sync sync = Sync::kYes);

 private:
  void flush();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
  std::string buffer_;
  std::uintmax_t good_length_ = 0;
};

/// The same for a file that another library writes by name: under `temporary` until `commit` syncs
/// it and renames it over `path`. Throws FileError like the above.
class PendingFile final {
 public:
  explicit PendingFile(std::filesystem::path path);
  ~PendingFile();  ///< removes what was not committed
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_, temporary_;
};

/// Writes a whole file that way.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Copies a file, however large, that way. Throws FileError also when it cannot be read.
void copy_whole_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Has the system write a file or folder out to the disk. Throws FileError.
void sync_to_disk(const std::filesystem::path& path);

/// Makes a folder where there is none; its parent must exist. Throws FileError.
void make_folder(const std::filesystem::path& folder);

}  // namespace floe::io
