#include "mesh/vtk_array.hpp"

#include <floe/numeric/error.hpp>

#include <zlib.h>

#include <array>
#include <cstring>

namespace floe::mesh {
namespace {

// The largest ratio to which zlib compresses (its FAQ)
constexpr std::uint64_t kLargestRatio = 1032;

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// Takes bytes from raw data, or from base64; the decoder starts anew for every part, as VTK
/// encodes header and data each by itself.
class ByteSource {
 public:
  ByteSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

  /// The next `count` bytes.
  std::string take(std::uint64_t count) {
    FLOE_VALIDATE_AS(MeshError, count <= left(),
                     "invalid size = " << count << " bytes (must be at most " << left()
                                       << ": no more are in the file)");
    if (!base64_) {
      const std::string bytes(text_.substr(0, count));
      text_.remove_prefix(count);
      return bytes;
    }
    std::string bytes;
    bytes.reserve(count + 3);
    while (bytes.size() < count) append_group(bytes);
    bytes.resize(count);
    return bytes;
  }

 private:
  std::uint64_t left() const { return base64_ ? text_.size() / 4 * 3 : text_.size(); }

  // Four characters, three bytes; = fills up the last group of a part
  void append_group(std::string& bytes) {
    std::array<int, 4> value{};
    FLOE_VALIDATE_AS(MeshError, text_.size() >= 4, "base64 ends too early");
    int fill = 0;
    for (int i = 0; i < 4; ++i) {
      value[i] = base64_value(text_[i]);
      if (text_[i] == '=' && i >= 2) {
        value[i] = 0;
        ++fill;
      }
      FLOE_VALIDATE_AS(
          MeshError, value[i] >= 0 && (fill == 0 || text_[i] == '='),
          "found '" << (text_[i] >= ' ' && text_[i] <= '~' ? text_[i] : '?') << "' in base64");
    }
    text_.remove_prefix(4);
    const std::array<int, 3> out = {value[0] << 2 | value[1] >> 4,
                                    (value[1] & 15) << 4 | value[2] >> 2,
                                    (value[2] & 3) << 6 | value[3]};
    for (int i = 0; i < 3 - fill; ++i) bytes += static_cast<char>(out[i]);
  }

  std::string_view text_;
  bool base64_;
};

std::uint64_t header_number(const std::string& bytes, std::size_t index, bool wide) {
  if (wide) {
    std::uint64_t value;
    std::memcpy(&value, bytes.data() + 8 * index, 8);
    return value;
  }
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + 4 * index, 4);
  return value;
}

std::string inflated(const std::string& block, std::uint64_t size) {
  FLOE_VALIDATE_AS(MeshError, size <= kLargestRatio * block.size() + 64,
                   "invalid block size = " << size << " bytes (must be what " << block.size()
                                           << " compressed bytes can hold)");
  std::string bytes(size, '\0');
  uLongf length = static_cast<uLongf>(size);
  const int status =
      uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()));
  FLOE_VALIDATE_AS(MeshError, status == Z_OK && length == size, "zlib data are damaged");
  return bytes;
}

// Number of blocks, their size, the size of the last where it is a part, the compressed sizes
std::string decode_compressed(ByteSource& source, std::string_view text, bool base64,
                              const VtkEncoding& encoding) {
  const std::size_t width = encoding.wide_header ? 8 : 4;
  const std::uint64_t blocks =
      header_number(ByteSource(text, base64).take(width), 0, encoding.wide_header);
  FLOE_VALIDATE_AS(MeshError, blocks <= text.size(),
                   "invalid number of blocks = " << blocks << " (must fit in the file)");
  const std::string header = source.take((3 + blocks) * width);
  const auto number = [&](std::size_t i) { return header_number(header, i, encoding.wide_header); };
  const std::uint64_t whole = number(1), last = number(2);
  std::uint64_t compressed = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    FLOE_VALIDATE_AS(MeshError, number(3 + b) <= text.size(),
                     "invalid compressed size = " << number(3 + b) << " (must fit in the file)");
    compressed += number(3 + b);
  }
  const std::string data = source.take(compressed);
  std::string bytes;
  std::size_t at = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::uint64_t size = b + 1 == blocks && last > 0 ? last : whole;
    bytes += inflated(data.substr(at, number(3 + b)), size);
    at += number(3 + b);
  }
  return bytes;
}

}  // namespace

std::string decode_vtk_bytes(std::string_view text, bool base64, const VtkEncoding& encoding) {
  std::string without_blanks;
  if (base64) {
    // Text in the file may be broken into lines
    for (const char c : text)
      if (c != ' ' && c != '\n' && c != '\r' && c != '\t') without_blanks += c;
    text = without_blanks;
  }
  ByteSource source(text, base64);
  if (encoding.compressed) return decode_compressed(source, text, base64, encoding);
  const std::size_t width = encoding.wide_header ? 8 : 4;
  // NOTE: header and data of an array that is not compressed are encoded as one
  const std::uint64_t size =
      header_number(ByteSource(text, base64).take(width), 0, encoding.wide_header);
  FLOE_VALIDATE_AS(MeshError, size <= text.size(),
                   "invalid size = " << size << " bytes (must be at most what is in the file)");
  return source.take(width + size).substr(width);
}

}  // namespace floe::mesh
