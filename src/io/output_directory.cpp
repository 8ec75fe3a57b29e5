#include "io/output_directory.hpp"

#include "io/run_json.hpp"

#include <floe/numeric/error.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <utility>

namespace floe::io {
namespace {

constexpr const char* kLockName = "run.lock";

[[noreturn]] void refuse_writing(const std::filesystem::path& path, int error) {
  throw FileError("cannot write to " + path.string() + ": " + std::strerror(error));
}

// Who holds the lock, as it wrote itself
std::string holder(int descriptor) {
  std::array<char, 128> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size() - 1, 0);
  std::string line(text.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  return line.substr(0, line.find('\n'));
}

// True when `descriptor` is still the file of that name
bool is_current(int descriptor, const std::filesystem::path& path) {
  struct stat open_file {
  }, named_file{};
  return ::fstat(descriptor, &open_file) == 0 && ::stat(path.c_str(), &named_file) == 0 &&
         open_file.st_ino == named_file.st_ino && open_file.st_dev == named_file.st_dev;
}

// Paths of an earlier run's list that stay inside the directory
bool is_inside(const std::filesystem::path& file) {
  return !file.empty() && file.is_relative() &&
         std::none_of(file.begin(), file.end(), [](const auto& part) { return part == ".."; });
}

// NAME.tmp.PID of one of the products
bool is_leftover_of(const std::string& name, const std::set<std::string>& products) {
  const std::size_t at = name.rfind(".tmp.");
  return at != std::string::npos && at + 5 < name.size() &&
         name.find_first_not_of("0123456789", at + 5) == std::string::npos &&
         products.contains(name.substr(0, at));
}

}  // namespace

const std::vector<std::string>& product_names() {
  static const std::vector<std::string> names = {"dry_modes.csv",      "rao_points.csv",
                                                 "rao_lines.csv",      "rao_quantities.csv",
                                                 "wave_points.csv",    "hydro_coefficients.csv",
                                                 "exciting_force.csv", "fields.pvd",
                                                 "result.nc",          "run.json"};
  return names;
}

OutputDirectory::OutputDirectory(std::filesystem::path path, Existing existing)
    : path_(std::move(path)) {
  make();
  try {
    lock();
    look_at_content(existing);
  } catch (...) {
    if (lock_ >= 0) {
      ::unlink((path_ / kLockName).c_str());
      ::close(lock_);
    }
    if (made_) ::rmdir(path_.c_str());
    throw;
  }
}

OutputDirectory::~OutputDirectory() {
  ::unlink((path_ / kLockName).c_str());
  ::close(lock_);
  if (made_) ::rmdir(path_.c_str());  // fails, as it should, when something was stored
}

void OutputDirectory::make() {
  made_ = ::mkdir(path_.c_str(), 0777) == 0;
  if (made_) return;
  const int error = errno;
  struct stat status {};
  if (error != EEXIST) refuse_writing(path_, error);
  if (::stat(path_.c_str(), &status) != 0) refuse_writing(path_, errno);
  if (!S_ISDIR(status.st_mode)) refuse_writing(path_, ENOTDIR);
}

void OutputDirectory::lock() {
  const std::filesystem::path name = path_ / kLockName;
  // A lock file that is removed between opening and locking is no lock: open the next one
  for (int attempt = 0; attempt < 100; ++attempt) {
    lock_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (lock_ < 0) refuse_writing(path_, errno);
    // NOTE: a file system without locks cannot tell a second run; the first goes on without
    const bool without = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno != EWOULDBLOCK;
    const bool busy = !without && ::flock(lock_, LOCK_EX | LOCK_NB) != 0;
    if (busy) {
      const std::string who = holder(lock_);
      ::close(std::exchange(lock_, -1));
      throw BusyError("another run holds " + path_.string() +
                      (who.empty() ? "" : " (" + who + ")"));
    }
    if (is_current(lock_, name)) break;
    ::close(std::exchange(lock_, -1));
  }
  if (lock_ < 0) throw BusyError("other runs hold " + path_.string());
  std::array<char, 65> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string text =
      "process " + std::to_string(::getpid()) + " on " + std::string(host.data()) + "\n";
  if (::ftruncate(lock_, 0) != 0 || ::write(lock_, text.data(), text.size()) < 0)
    refuse_writing(path_ / kLockName, errno);
}

void OutputDirectory::look_at_content(Existing existing) {
  const std::filesystem::path account = path_ / "run.json";
  const bool holds_run = std::filesystem::exists(std::filesystem::symlink_status(account));
  if (holds_run) {
    FLOE_VALIDATE_AS(StoreError, existing != Existing::kRefuse,
                     path_.string() << " holds a result already (give --resume to go on with it, "
                                       "--fresh to replace it, or another directory with -o)");
    earlier_files_ = files_of_run(account);
    return;
  }
  for (const std::string& name : product_names())
    FLOE_VALIDATE_AS(
        StoreError, !std::filesystem::exists(std::filesystem::symlink_status(path_ / name)),
        path_.string() << " holds a file " << name
                       << " that no run lists as its own, so --fresh would not replace it (remove "
                          "it, or give another directory with -o)");
}

void OutputDirectory::clear_earlier_run() {
  if (!earlier_files_.empty())  // what other commands make after the run
    for (const char* file : {"report.html", "result_rigid.nc", "result_all.nc", "result.1",
                             "result.3", "result.3fk", "result.3sc", "result.4", "result.hst"})
      earlier_files_.emplace_back(file);
  remove(std::exchange(earlier_files_, {}));
}

void OutputDirectory::clear_leftovers() { remove_leftovers(std::exchange(earlier_files_, {})); }

void OutputDirectory::remove(const std::vector<std::string>& files) const {
  std::error_code ignored;
  for (const std::string& file : files) {
    if (!is_inside(file)) continue;
    const std::filesystem::path target = path_ / file;
    if (!std::filesystem::is_directory(std::filesystem::symlink_status(target, ignored)))
      std::filesystem::remove(target, ignored);
  }
  remove_leftovers(files);
  // Removed only when nothing else is in them
  for (const char* folder : {"fields", "records"}) ::rmdir((path_ / folder).c_str());
}

// What a killed run left beside the names of these files
void OutputDirectory::remove_leftovers(const std::vector<std::string>& files) const {
  std::map<std::filesystem::path, std::set<std::string>> products;  // by folder
  for (const std::string& file : files)
    if (is_inside(file))
      products[(path_ / file).parent_path()].insert((path_ / file).filename().string());
  for (const auto& [folder, names] : products) {
    std::error_code ignored;
    for (std::filesystem::directory_iterator at(folder, ignored), end; !ignored && at != end;
         at.increment(ignored)) {
      std::error_code gone;
      if (is_leftover_of(at->path().filename().string(), names))
        std::filesystem::remove(at->path(), gone);
    }
  }
}

}  // namespace floe::io
