#include "io/atomic_file.hpp"

#include <floe/numeric/error.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace floe::io {
namespace {

constexpr std::size_t kBuffer = 1u << 18;

int open_new(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

std::filesystem::path beside(const std::filesystem::path& path) {
  return path.string() + ".tmp." + std::to_string(::getpid());
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error) {
  throw FileError("cannot write " + path.string() + ": " + std::strerror(error));
}

// A file system without syncs goes on without
bool synced(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(beside(path_)) {
  descriptor_ = open_new(temporary_);
  if (descriptor_ < 0 && errno == EEXIST && ::unlink(temporary_.c_str()) == 0)
    descriptor_ = open_new(temporary_);  // left behind by a dead process of the same number
  if (descriptor_ < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (buffer_.size() >= kBuffer) flush();
}

void AtomicFile::mark() {
  flush();
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail(errno);
  good_length_ = static_cast<std::uintmax_t>(status.st_size);
}

void AtomicFile::rollback() {
  buffer_.clear();
  if (::ftruncate(descriptor_, static_cast<off_t>(good_length_)) != 0 ||
      ::lseek(descriptor_, 0, SEEK_END) < 0)
    fail(errno);
}

void AtomicFile::commit(Sync sync) {
  flush();
  if (sync == Sync::kYes && !synced(descriptor_)) fail(errno);
  if (::close(std::exchange(descriptor_, -1)) != 0 ||
      ::rename(temporary_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary_.c_str());
    fail(error);
  }
}

void AtomicFile::flush() {
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t written = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    done += static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

void AtomicFile::fail(int error) const { fail_to_write(path_, error); }

PendingFile::PendingFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(beside(path_)) {
  if (::unlink(temporary_.c_str()) != 0 && errno != ENOENT) fail_to_write(path_, errno);
}

PendingFile::~PendingFile() { ::unlink(temporary_.c_str()); }

void PendingFile::commit() {
  const int descriptor = ::open(temporary_.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) fail_to_write(path_, errno);
  const int error = synced(descriptor) ? 0 : errno;
  ::close(descriptor);
  if (error != 0) fail_to_write(path_, error);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

void copy_whole_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  PendingFile copy(to);
  std::error_code error;
  std::filesystem::copy_file(from, copy.temporary(), error);
  if (error)
    throw FileError("cannot copy " + from.string() + " to " + to.string() + ": " + error.message());
  copy.commit();
}

void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool good = descriptor >= 0 && synced(descriptor);
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!good) fail_to_write(path, error);
}

void make_folder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
    throw FileError("cannot write to " + folder.string() + ": " + std::strerror(errno));
}

}  // namespace floe::io
