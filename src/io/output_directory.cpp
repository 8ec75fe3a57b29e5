#include "io/output_directory.hpp"

#include "io/manifest.hpp"
#include "io/product_names.hpp"
#include "io/record_names.hpp"
#include "io/run_json.hpp"

#include <floe/numeric/error.hpp>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <map>
#include <set>
#include <thread>
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

std::string holder_of(const std::filesystem::path& directory) {
  const int lock = ::open((directory / kLockName).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (lock < 0) return "";
  const bool held = ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  const std::string who = held ? holder(lock) : "";
  ::close(lock);
  return held && who.empty() ? "another process" : who;
}

OutputDirectory::OutputDirectory(std::filesystem::path path, Existing existing,
                                 const std::string& ways)
    : path_(std::move(path)) {
  make();
  try {
    lock();
    look_at_content(existing, ways);
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
  int looked = 0;
  for (int attempt = 0; attempt < 100; ++attempt) {
    lock_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (lock_ < 0) refuse_writing(path_, errno);
    // NOTE: a file system without locks cannot tell a second run; the first goes on without
    locks_ = ::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno == EWOULDBLOCK;
    const bool busy = locks_ && ::flock(lock_, LOCK_EX | LOCK_NB) != 0;
    if (busy) {
      const std::string who = holder(lock_);
      ::close(std::exchange(lock_, -1));
      // NOTE: floe status holds it for an instant, too
      if (++looked < 4) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        continue;
      }
      throw BusyError("another run holds " + path_.string() +
                      (who.empty() ? "" : " (" + who + ")"));
    }
    if (is_current(lock_, name)) break;
    ::close(std::exchange(lock_, -1));
  }
  if (lock_ < 0) throw BusyError("other runs hold " + path_.string());
  std::array<char, 65> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string text = fmt::format("process {} on {} since {:%Y-%m-%d %H:%M:%S} UTC\n",
                                       ::getpid(), host.data(), fmt::gmtime(std::time(nullptr)));
  if (::ftruncate(lock_, 0) != 0 || ::write(lock_, text.data(), text.size()) < 0)
    refuse_writing(path_ / kLockName, errno);
}

void OutputDirectory::look_at_content(Existing existing, const std::string& ways) {
  const auto holds = [&](const std::string& name) {
    return std::filesystem::exists(std::filesystem::symlink_status(path_ / name));
  };
  const bool manifest = holds(kManifest), account = holds("run.json");
  if (manifest || account || !records_in(path_).empty()) {
    FLOE_VALIDATE_AS(StoreError, existing != Existing::kRefuse,
                     path_.string() << " holds a result already (give " << ways
                                    << ", or another directory with -o)");
    // NOTE: a run that was killed before its first record left an account only, as one that runs
    const bool begun =
        !manifest && records_in(path_).empty() && status_of_run(path_ / "run.json") == kRunning;
    if (existing == Existing::kResume && !begun) static_cast<void>(read_manifest(path_));
    earlier_files_ = files_of_earlier_run();
    return;
  }
  for (const std::string& name : product_names())
    FLOE_VALIDATE_AS(
        StoreError, !holds(name),
        path_.string() << " holds a file " << name
                       << " that no run lists as its own, so --fresh would not replace it (remove "
                          "it, or give another directory with -o)");
}

// As the account lists them, or else as the manifest implies
std::vector<std::string> OutputDirectory::files_of_earlier_run() const {
  try {
    return files_of_run(path_ / "run.json");
  } catch (const StoreError&) {
    std::error_code ignored;
    if (!std::filesystem::exists(path_ / kManifest, ignored)) throw;
  }
  return files_of_manifest(path_);
}

double OutputDirectory::free_space() const {
  struct statvfs status {};
  if (::statvfs(path_.c_str(), &status) != 0) refuse_writing(path_, errno);
  return static_cast<double>(status.f_bavail) * static_cast<double>(status.f_frsize);
}

double OutputDirectory::record_size() const {
  double bytes = 0.0;
  for (const std::string& name : records_in(path_)) {
    std::error_code gone;
    const std::uintmax_t size = std::filesystem::file_size(path_ / name, gone);
    if (!gone) bytes += static_cast<double>(size);
  }
  return bytes;
}

void OutputDirectory::clear_earlier_run() {
  if (!earlier_files_.empty())  // what other commands make after the run
    for (const char* file : {"report.html", "result_rigid.nc", "result_all.nc", "result.1",
                             "result.3", "result.3fk", "result.3sc", "result.4", "result.hst"})
      earlier_files_.emplace_back(file);
  for (const std::string& name : records_in(path_))  // set aside, or left by a run without account
    if (std::find(earlier_files_.begin(), earlier_files_.end(), name) == earlier_files_.end())
      earlier_files_.push_back(name);
  remove(std::exchange(earlier_files_, {}));
}

void OutputDirectory::clear_leftovers() { remove_leftovers(std::exchange(earlier_files_, {})); }

void OutputDirectory::remove(const std::vector<std::string>& files) const {
  std::error_code ignored;
  const auto erase = [&](const std::string& file) {
    if (!is_inside(file)) return;
    const std::filesystem::path target = path_ / file;
    if (!std::filesystem::is_directory(std::filesystem::symlink_status(target, ignored)))
      std::filesystem::remove(target, ignored);
  };
  // What tells whose the files are goes last, so that a kill on the way leaves nothing unknown
  remove_leftovers(files);
  const std::set<std::string> last = {kManifest, "run.json"};
  for (const std::string& file : files)
    if (!last.contains(file)) erase(file);
  for (const std::string& file : last)
    if (std::find(files.begin(), files.end(), file) != files.end()) erase(file);
  // Removed only when nothing else is in them
  for (const std::string& folder : {std::string("fields"), kBadRecords, kRecords})
    ::rmdir((path_ / folder).c_str());
}

// What a killed run left beside the names of these files
void OutputDirectory::remove_leftovers(const std::vector<std::string>& files) const {
  std::map<std::filesystem::path, std::set<std::string>> products;  // by folder
  // NOTE: one that was killed at its first file has listed nothing yet
  products[path_].insert(product_names().begin(), product_names().end());
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
