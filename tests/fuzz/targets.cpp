#define XXH_INLINE_ALL

#include "targets.hpp"

#include "io/matrix_market.hpp"
#include "io/record.hpp"
#include "io/result_records.hpp"
#include "io/scatter_csv.hpp"
#include "mesh/file_content.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <sys/mman.h>
#include <unistd.h>
#include <xxhash.h>

#include <cstdint>
#include <stdexcept>

namespace floe::fuzz {
namespace {

// A file in memory that has a path
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count <= 0) throw std::logic_error("cannot write a file in memory");
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

// The bytes as the payload of a record whose checksum is right: past the door
std::string sealed(std::string_view payload) {
  const auto put = [](std::string& text, const auto& value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const XXH128_hash_t hash = XXH3_128bits(payload.data(), payload.size());
  std::string bytes = "floe-rec";
  put(bytes, std::uint32_t{1});
  put(bytes, std::uint32_t{0x01020304});
  put(bytes, static_cast<std::uint64_t>(payload.size()));
  put(bytes, hash.low64);
  put(bytes, hash.high64);
  return bytes.append(payload);
}

// As stiffness and mass, and as modes and frequencies
void read_matrices(std::string_view bytes) {
  try {
    io::parse_sparse_matrix(bytes, "fuzz.mtx");
  } catch (const Error&) {
  }
  io::parse_dense_matrix(bytes, "fuzz.mtx");
}

// Everything that a record may hold
void read_results(std::string_view payload) {
  const MemoryFile file(sealed(payload));
  const io::Record record = io::Record::read(file.path());
  const auto attempt = [&](const auto& decode) {
    try {
      decode(record);
    } catch (const Error&) {
    }
  };
  attempt([](const io::Record& r) { io::mesh_from(r); });
  attempt([](const io::Record& r) { io::modes_from(r); });
  attempt([](const io::Record& r) { io::frequency_from(r); });
  attempt([](const io::Record& r) { io::observation_from(r); });
  attempt([](const io::Record& r) { io::finished_grid_from(r); });
  attempt([](const io::Record& r) { io::transfer_from(r); });
  attempt([](const io::Record& r) { io::sea_from(r); });
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"case", [](std::string_view bytes) { io::read_case(MemoryFile(bytes).path()); }},
      {"sea", [](std::string_view bytes) { io::read_sea_file(MemoryFile(bytes).path()); }},
      {"scatter",
       [](std::string_view bytes) {
         io::read_scatter_diagram(MemoryFile(bytes).path(), wave::PeriodType::kPeak);
       }},
      {"mesh", [](std::string_view bytes) { mesh::read_mesh_bytes(bytes, "fuzz.msh"); }},
      {"matrix", read_matrices},
      {"record", [](std::string_view bytes) { io::Record::read(MemoryFile(bytes).path()); }},
      {"results", read_results},
  };
  return all;
}

void run(const Target& target, std::string_view bytes) {
  try {
    target.read(bytes);
  } catch (const Error&) {
  }
}

}  // namespace floe::fuzz
