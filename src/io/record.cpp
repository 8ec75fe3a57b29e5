#define XXH_INLINE_ALL
#include "io/record.hpp"

#include "io/atomic_file.hpp"
#include "io/regular_file.hpp"

#include <floe/numeric/error.hpp>

#include <xxhash.h>

#include <bit>
#include <cstdint>
#include <cstring>

namespace floe::io {
namespace {

static_assert(std::endian::native == std::endian::little, "records are written little-endian");

constexpr std::string_view kMagic = "floe-rec";
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kByteOrder = 0x01020304;
// Of any version: magic, version, byte order and length of the payload, then the checksum of these
// and of the payload
constexpr std::size_t kBeforeChecksum = 8 + 4 + 4 + 8;
constexpr std::size_t kHeader = kBeforeChecksum + 16;
constexpr std::uintmax_t kLargestRecord = std::uintmax_t{1} << 40;

template <typename Number>
void append(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

XXH128_hash_t checksum(std::string_view before, std::string_view payload) {
  const XXH128_hash_t first = XXH3_128bits(before.data(), before.size());
  return XXH3_128bits_withSeed(payload.data(), payload.size(), first.low64 ^ first.high64);
}

// Takes values off the front of a text; what is not there throws
class Reader {
 public:
  Reader(std::string_view rest, const std::filesystem::path& path) : rest_(rest), path_(path) {}

  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) fail("is cut off");
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  template <typename Number>
  Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  bool empty() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }
  [[noreturn]] void fail(const std::string& how) const {
    throw StoreError("record " + path_.string() + " " + how +
                     " (floe run --resume computes it again)");
  }

 private:
  std::string_view rest_;
  const std::filesystem::path& path_;
};

template <typename Matrix>
std::string bytes_of(const Matrix& values) {
  return {reinterpret_cast<const char*>(values.data()),
          static_cast<std::size_t>(values.size()) * sizeof(typename Matrix::Scalar)};
}

template <typename Matrix>
Matrix matrix_of(const std::string& bytes, Index rows, Index columns) {
  Matrix values(rows, columns);
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace

void Record::put(const std::string& name, Kind kind, Index rows, Index columns, std::string bytes) {
  FLOE_EXPECT(!entries_.contains(name));
  entries_.emplace(name, Entry{kind, rows, columns, std::move(bytes)});
}

void Record::put(const std::string& name, const Eigen::Ref<const MatXd>& values) {
  put(name, Kind::kReal, values.rows(), values.cols(), bytes_of(MatXd(values)));
}

void Record::put(const std::string& name, const Eigen::Ref<const MatXcd>& values) {
  put(name, Kind::kComplex, values.rows(), values.cols(), bytes_of(MatXcd(values)));
}

void Record::put(const std::string& name, double value) { put(name, MatXd::Constant(1, 1, value)); }

void Record::put(const std::string& name, const std::string& text) {
  put(name, Kind::kText, static_cast<Index>(text.size()), 1, text);
}

const Record::Entry& Record::entry(const std::string& name, Kind kind) const {
  const auto at = entries_.find(name);
  FLOE_VALIDATE_AS(StoreError, at != entries_.end() && at->second.kind == kind,
                   "a record holds no " << name << " of the right kind");
  return at->second;
}

MatXd Record::real(const std::string& name) const {
  const Entry& found = entry(name, Kind::kReal);
  return matrix_of<MatXd>(found.bytes, found.rows, found.columns);
}

MatXcd Record::complex(const std::string& name) const {
  const Entry& found = entry(name, Kind::kComplex);
  return matrix_of<MatXcd>(found.bytes, found.rows, found.columns);
}

double Record::number(const std::string& name) const {
  const MatXd value = real(name);
  FLOE_VALIDATE_AS(StoreError, value.size() == 1, "a record's " << name << " is no number");
  return value(0, 0);
}

std::string Record::text(const std::string& name) const { return entry(name, Kind::kText).bytes; }

std::string Record::not_finite() const {
  for (const auto& [name, entry] : entries_) {
    if (entry.kind == Kind::kText) continue;
    const VecXd numbers =
        matrix_of<VecXd>(entry.bytes, static_cast<Index>(entry.bytes.size() / sizeof(double)), 1);
    if (!numbers.allFinite()) return name;
  }
  return "";
}

bool Record::same_as(const Record& other, const std::vector<std::string>& ignored) const {
  Record a = *this, b = other;
  for (const std::string& name : ignored) {
    a.entries_.erase(name);
    b.entries_.erase(name);
  }
  return a.entries_ == b.entries_;
}

std::string Record::payload() const {
  std::string bytes;
  for (const auto& [name, entry] : entries_) {
    append(bytes, static_cast<std::uint32_t>(name.size()));
    bytes += name;
    append(bytes, static_cast<char>(entry.kind));
    append(bytes, static_cast<std::uint64_t>(entry.rows));
    append(bytes, static_cast<std::uint64_t>(entry.columns));
    bytes += entry.bytes;
  }
  return bytes;
}

void Record::write(const std::filesystem::path& path) const {
  const std::string bytes = payload();
  std::string header(kMagic);
  append(header, kVersion);
  append(header, kByteOrder);
  append(header, static_cast<std::uint64_t>(bytes.size()));
  const XXH128_hash_t hash = checksum(header, bytes);
  append(header, hash.low64);
  append(header, hash.high64);
  AtomicFile file(path);
  file.write(header);
  file.write(bytes);
  file.commit(Sync::kNo);
}

Record Record::parse(std::string_view payload, const std::filesystem::path& path) {
  Record record;
  Reader reader(payload, path);
  while (!reader.empty()) {
    const std::string name(reader.take(reader.number<std::uint32_t>()));
    const auto kind = static_cast<Kind>(reader.number<char>());
    const auto rows = reader.number<std::uint64_t>(), columns = reader.number<std::uint64_t>();
    const std::uint64_t width = kind == Kind::kText ? 1 : kind == Kind::kReal ? 8 : 16;
    if (kind != Kind::kText && kind != Kind::kReal && kind != Kind::kComplex)
      reader.fail("holds an entry of no known kind");
    // Divide, for a product of two unverified counts may wrap around
    const std::uint64_t most = reader.left() / width;
    if (rows > kLargestRecord || columns > kLargestRecord ||
        (columns != 0 && rows > most / columns))
      reader.fail("is cut off");
    if (record.holds(name)) reader.fail("names an entry twice");
    record.put(name, kind, static_cast<Index>(rows), static_cast<Index>(columns),
               std::string(reader.take(rows * columns * width)));
  }
  return record;
}

Record Record::read(const std::filesystem::path& path) {
  std::string content;
  try {
    content = read_regular_file(path, kLargestRecord);
  } catch (const InputError& error) {
    throw StoreError(error.what());
  }
  Reader reader(content, path);
  if (content.size() < kHeader || reader.take(kMagic.size()) != kMagic)
    reader.fail("is not one of floe");
  const auto version = reader.number<std::uint32_t>(), order = reader.number<std::uint32_t>();
  const auto length = reader.number<std::uint64_t>();
  const auto low = reader.number<std::uint64_t>(), high = reader.number<std::uint64_t>();
  if (length != reader.left()) reader.fail("is cut off");
  const std::string_view payload = reader.take(length);
  const XXH128_hash_t hash =
      checksum(std::string_view(content).substr(0, kBeforeChecksum), payload);
  if (hash.low64 != low || hash.high64 != high) reader.fail("is damaged");

  // Whole, but from elsewhere
  FLOE_VALIDATE_AS(io::RecordVersionError, version == kVersion,
                   "record " << path.string() << " has the format version " << version
                             << ", this floe reads " << kVersion
                             << " (give --fresh to replace the results)");
  if (order != kByteOrder) reader.fail("comes from another machine");
  return parse(payload, path);
}

}  // namespace floe::io
