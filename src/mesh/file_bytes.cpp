#include "mesh/file_bytes.hpp"

#include <floe/numeric/error.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace floe::mesh {
namespace {

// Closes a file descriptor at the end of its scope
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  // Closes now; false if the system reports that something was not written
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

const char* kind_of_file(mode_t mode) {
  if (S_ISDIR(mode)) return "directory";
  if (S_ISFIFO(mode)) return "pipe";
  if (S_ISSOCK(mode)) return "socket";
  return "device";
}

// Writes everything; 0 or the errno of what went wrong
int write_all(Descriptor& file, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::write(file.number(), content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 ? errno : EIO;
    done += static_cast<std::size_t>(count);
  }
  return file.close() ? 0 : errno;
}

}  // namespace

std::string read_regular_file(const std::filesystem::path& path) {
  // NOTE: opening a pipe waits for a writer unless O_NONBLOCK is set
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0)
    FLOE_DETAIL_THROW(MeshError, path.string() << ": cannot open: " << std::strerror(errno));
  FLOE_VALIDATE_AS(
      MeshError, S_ISREG(status.st_mode),
      path.string() << ": found a " << kind_of_file(status.st_mode) << " (must be a regular file)");

  std::string content(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::read(file.number(), content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    FLOE_VALIDATE_AS(FileError, count >= 0,
                     path.string() << ": cannot read: " << std::strerror(errno));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  content.resize(done);
  return content;
}

void replace_file(const std::filesystem::path& path, const std::string& content) {
  std::error_code ignored;
  const bool direct =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  std::filesystem::path target = path;
  if (!direct) target += ".tmp." + std::to_string(::getpid());

  Descriptor file(::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  int error = file.number() < 0 ? errno : write_all(file, content);
  if (error == 0 && !direct && ::rename(target.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  if (!direct) std::filesystem::remove(target, ignored);
  throw FileError(path.string() + ": cannot write: " + std::strerror(error));
}

}  // namespace floe::mesh
