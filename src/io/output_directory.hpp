#pragma once

#include <floe/io/directory_store.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// The directory of one run: made, locked against a second run, and checked for what it holds.
class OutputDirectory final {
 public:
  /// `ways` are the flags of the command that deal with a result that is there already.
  OutputDirectory(std::filesystem::path path, Existing existing,
                  const std::string& ways = "--fresh to replace it");
  /// Removes the lock, and the directory if this run made it and it is empty.
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Whether its file system can keep a second run out.
  bool locks() const { return locks_; }
  /// What is free on its disk for this user, and what its records take already [byte].
  double free_space() const;
  double record_size() const;

  /// Deletes the files of the earlier run that is to be replaced, if there is one.
  void clear_earlier_run();
  /// Deletes only what that run left under construction.
  void clear_leftovers();
  /// Deletes these files of this run.
  void remove(const std::vector<std::string>& files) const;

 private:
  void make();
  void lock();
  void remove_leftovers(const std::vector<std::string>& files) const;
  void look_at_content(Existing existing, const std::string& ways);
  std::vector<std::string> files_of_earlier_run() const;

  std::filesystem::path path_;
  bool made_ = false;
  int lock_ = -1;
  bool locks_ = true;
  std::vector<std::string> earlier_files_;
};

/// Who holds the directory for a run, "process 12 on host"; "" if nobody does.
std::string holder_of(const std::filesystem::path& directory);

}  // namespace floe::io
