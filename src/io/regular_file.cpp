#include "io/regular_file.hpp"

#include <floe/numeric/error.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace floe::io {
namespace {

// A file descriptor that is closed with its scope
class OpenFile {
 public:
  // NOTE: O_NONBLOCK keeps a FIFO that takes the file's place after the check from blocking
  explicit OpenFile(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

void require_regular(const struct stat& status, const std::filesystem::path& path) {
  FLOE_VALIDATE(!S_ISDIR(status.st_mode), path.string()
                                              << ": not a regular file (it is a directory)");
  FLOE_VALIDATE(S_ISREG(status.st_mode), path.string() << ": not a regular file");
}

}  // namespace

std::string read_regular_file(const std::filesystem::path& path, std::uintmax_t largest) {
  // Look before opening, and again at what was opened
  struct stat status {};
  FLOE_VALIDATE(::stat(path.c_str(), &status) == 0,
                path.string() << ": cannot read: " << std::strerror(errno));
  require_regular(status, path);
  const OpenFile file(path);
  FLOE_VALIDATE(file.descriptor() >= 0 && ::fstat(file.descriptor(), &status) == 0,
                path.string() << ": cannot read: " << std::strerror(errno));
  require_regular(status, path);
  FLOE_VALIDATE(static_cast<std::uintmax_t>(status.st_size) <= largest,
                path.string() << ": invalid file size = " << status.st_size
                              << " bytes (must be at most " << largest << ")");

  // Read it all
  std::string content(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t filled = 0;
  while (filled < content.size()) {
    const ssize_t got = ::read(file.descriptor(), content.data() + filled, content.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    FLOE_VALIDATE(got >= 0, path.string() << ": cannot read: " << std::strerror(errno));
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  content.resize(filled);
  return content;
}

}  // namespace floe::io
