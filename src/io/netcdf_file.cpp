#include "io/netcdf_file.hpp"

#include <floe/numeric/error.hpp>

#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <numeric>
#include <string_view>
#include <utility>

namespace floe::io {
namespace {

constexpr int kClosed = -1;
constexpr std::size_t kFirstSize = std::size_t{1} << 12;  // [byte], a file is never smaller
constexpr int kDeflateLevel = 1;  // higher ones take twice the time for a few per cent

// An image in memory is rounded up to whole blocks; HDF5's superblock tells where the file ends
// (HDF5 File Format Specification 3.0, II.A: version 0 at byte 40, 1 at 44, 2 and 3 at 28)
std::size_t used_size(std::string_view image) {
  constexpr std::size_t kVersion = 8, kSuperblock = 96;
  if (image.size() < kSuperblock) return image.size();
  const unsigned char version = static_cast<unsigned char>(image[kVersion]);
  if (version > 3) return image.size();
  const std::size_t at = version == 0 ? 40 : version == 1 ? 44 : 28;
  std::uint64_t end = 0;
  std::memcpy(&end, image.data() + at, sizeof(end));
  return end >= kSuperblock && end <= image.size() ? static_cast<std::size_t>(end) : image.size();
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& why) {
  throw FileError("cannot write " + path.string() + ": " + why);
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& why) {
  throw DataError("cannot read " + path.string() + ": " + why);
}

// Ends at the first zero; blanks at the end are padding too
std::string without_padding(std::string text) {
  text.resize(std::min(text.size(), text.find('\0')));
  text.resize(text.find_last_not_of(' ') + 1);
  return text;
}

std::size_t product(const std::vector<std::size_t>& lengths) {
  return std::accumulate(lengths.begin(), lengths.end(), std::size_t{1}, std::multiplies<>());
}

}  // namespace

NetcdfFile::NetcdfFile(std::filesystem::path path, Mode mode, int id)
    : path_(std::move(path)), mode_(mode), id_(id) {}

NetcdfFile NetcdfFile::create(const std::filesystem::path& path) {
  auto output = std::make_unique<AtomicFile>(path);
  int id = kClosed;
  const int status = nc_create_mem(path.c_str(), NC_NETCDF4, kFirstSize, &id);
  if (status != NC_NOERR) fail_to_write(path, nc_strerror(status));
  NetcdfFile file(path, Mode::kWrite, id);
  file.output_ = std::move(output);
  int earlier = 0;
  file.check(nc_set_fill(id, NC_NOFILL, &earlier));  // every variable is written in full
  return file;
}

NetcdfFile NetcdfFile::create_classic(const std::filesystem::path& path) {
  int id = kClosed;
  const int status = nc_create(path.c_str(), NC_64BIT_DATA | NC_CLOBBER, &id);
  if (status != NC_NOERR) fail_to_write(path, nc_strerror(status));
  NetcdfFile file(path, Mode::kWriteClassic, id);
  int earlier = 0;
  file.check(nc_set_fill(id, NC_NOFILL, &earlier));
  return file;
}

NetcdfFile NetcdfFile::open(const std::filesystem::path& path) {
  int id = kClosed;
  const int status = nc_open(path.c_str(), NC_NOWRITE, &id);
  if (status != NC_NOERR) fail_to_read(path, nc_strerror(status));
  return NetcdfFile(path, Mode::kRead, id);
}

NetcdfFile::NetcdfFile(NetcdfFile&& other) noexcept
    : path_(std::move(other.path_)),
      mode_(other.mode_),
      id_(std::exchange(other.id_, kClosed)),
      describing_(other.describing_),
      output_(std::move(other.output_)) {}

NetcdfFile::~NetcdfFile() {
  if (id_ != kClosed) nc_close(id_);
}

void NetcdfFile::close() {
  const int id = std::exchange(id_, kClosed);
  if (mode_ != Mode::kWrite) {
    check(nc_close(id));
    return;
  }
  NC_memio made{};
  check(nc_close_memio(id, &made));
  const std::unique_ptr<void, decltype(&std::free)> memory(made.memory, &std::free);
  const std::string_view image(static_cast<const char*>(made.memory), made.size);
  output_->write(image.substr(0, used_size(image)));
  output_->commit();
  output_.reset();
}

void NetcdfFile::check(int status, const std::string& what) const {
  if (status == NC_NOERR) return;
  std::string why = (what.empty() ? "" : what + ": ") + nc_strerror(status);
  if (mode_ == Mode::kRead) fail_to_read(path_, why);
  if (status == NC_ENOMEM) throw std::bad_alloc();
  fail_to_write(path_, why);
}

// A classic file is opened for a new name, and closed for values
void NetcdfFile::describe() {
  if (mode_ == Mode::kWriteClassic && !std::exchange(describing_, true)) check(nc_redef(id_));
}

void NetcdfFile::fill() {
  if (mode_ == Mode::kWriteClassic && std::exchange(describing_, false)) check(nc_enddef(id_));
}

int NetcdfFile::variable_id(const std::string& name) const {
  int variable = NC_GLOBAL;
  if (!name.empty()) check(nc_inq_varid(id_, name.c_str(), &variable), name);
  return variable;
}

std::vector<int> NetcdfFile::dimension_ids(const std::vector<std::string>& names) const {
  std::vector<int> ids(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    check(nc_inq_dimid(id_, names[i].c_str(), &ids[i]), names[i]);
  return ids;
}

std::size_t NetcdfFile::length_of(const std::vector<int>& dimensions) const {
  std::size_t length = 1;
  for (const int dimension : dimensions) {
    std::size_t extent = 0;
    check(nc_inq_dimlen(id_, dimension, &extent));
    length *= extent;
  }
  return length;
}

// Writing

void NetcdfFile::add_dimension(const std::string& name, std::size_t length) {
  FLOE_EXPECT(length > 0);  // zero would mean unlimited
  describe();
  int dimension = 0;
  check(nc_def_dim(id_, name.c_str(), length, &dimension), name);
}

void NetcdfFile::add_attribute(const std::string& variable, const std::string& name,
                               const std::string& text) {
  describe();
  check(nc_put_att_text(id_, variable_id(variable), name.c_str(), text.size(), text.data()), name);
}

void NetcdfFile::add_attribute(const std::string& variable, const std::string& name, double value) {
  describe();
  check(nc_put_att_double(id_, variable_id(variable), name.c_str(), NC_DOUBLE, 1, &value), name);
}

int NetcdfFile::define(const std::string& name, int type, const std::vector<int>& dimensions,
                       Compression compression) {
  describe();
  int variable = 0;
  check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(),
                   &variable),
        name);
  if (compression == Compression::kDeflate && !dimensions.empty())
    check(nc_def_var_deflate(id_, variable, 1, 1, kDeflateLevel), name);
  return variable;
}

void NetcdfFile::add_numbers(const std::string& name, const std::vector<std::string>& dimensions,
                             std::span<const double> values, Compression compression) {
  const std::vector<int> ids = dimension_ids(dimensions);
  FLOE_EXPECT(length_of(ids) == values.size());
  const int variable = define(name, NC_DOUBLE, ids, compression);
  fill();
  check(nc_put_var_double(id_, variable, values.data()), name);
}

void NetcdfFile::add_integers(const std::string& name, const std::vector<std::string>& dimensions,
                              std::span<const int> values) {
  const std::vector<int> ids = dimension_ids(dimensions);
  FLOE_EXPECT(length_of(ids) == values.size());
  const int variable = define(name, NC_INT, ids, Compression::kNone);
  fill();
  check(nc_put_var_int(id_, variable, values.data()), name);
}

void NetcdfFile::add_texts(const std::string& name, const std::vector<std::string>& dimensions,
                           const std::vector<std::string>& values) {
  std::vector<int> ids = dimension_ids(dimensions);
  FLOE_EXPECT(length_of(ids) == values.size());
  std::size_t longest = 1;
  for (const std::string& value : values) longest = std::max(longest, value.size());

  // The dimension of this length is shared
  const std::string length_name = "string" + std::to_string(longest);
  int length = 0;
  describe();
  if (nc_inq_dimid(id_, length_name.c_str(), &length) != NC_NOERR)
    check(nc_def_dim(id_, length_name.c_str(), longest, &length), length_name);
  ids.push_back(length);

  const int variable = define(name, NC_CHAR, ids, Compression::kNone);
  add_attribute(name, "_Encoding", "utf-8");
  std::string bytes;
  for (std::string value : values) {
    value.resize(longest, '\0');
    bytes += value;
  }
  fill();
  check(nc_put_var_text(id_, variable, bytes.data()), name);
}

void NetcdfFile::define_parts(const std::string& name, const std::vector<std::string>& dimensions,
                              std::size_t split) {
  const std::vector<int> ids = dimension_ids(dimensions);
  const bool classic = mode_ == Mode::kWriteClassic;
  const int variable =
      define(name, NC_DOUBLE, ids, classic ? Compression::kNone : Compression::kDeflate);
  if (classic) return;
  std::vector<std::size_t> chunk(ids.size(), 1);
  for (std::size_t i = split; i < ids.size(); ++i) chunk[i] = length_of({ids[i]});
  check(nc_def_var_chunking(id_, variable, NC_CHUNKED, chunk.data()), name);
}

void NetcdfFile::put_part(const std::string& name, const std::vector<std::size_t>& start,
                          const std::vector<std::size_t>& count, std::span<const double> values) {
  FLOE_EXPECT(product(count) == values.size());
  fill();
  check(nc_put_vara_double(id_, variable_id(name), start.data(), count.data(), values.data()),
        name);
}

// Reading

bool NetcdfFile::holds(const std::string& variable) const {
  int id = 0;
  return nc_inq_varid(id_, variable.c_str(), &id) == NC_NOERR;
}

std::vector<std::string> NetcdfFile::variables() const {
  int count = 0;
  check(nc_inq_nvars(id_, &count));
  std::vector<std::string> names;
  for (int variable = 0; variable < count; ++variable) {
    std::string name(NC_MAX_NAME + 1, '\0');
    check(nc_inq_varname(id_, variable, name.data()));
    names.push_back(name.c_str());
  }
  return names;
}

std::vector<std::string> NetcdfFile::dimensions(const std::string& variable) const {
  int count = 0;
  check(nc_inq_varndims(id_, variable_id(variable), &count), variable);
  std::vector<int> ids(static_cast<std::size_t>(count));
  check(nc_inq_vardimid(id_, variable_id(variable), ids.data()), variable);
  std::vector<std::string> names;
  for (const int id : ids) {
    std::string name(NC_MAX_NAME + 1, '\0');
    check(nc_inq_dimname(id_, id, name.data()), variable);
    names.push_back(name.c_str());
  }
  return names;
}

std::vector<std::size_t> NetcdfFile::shape(const std::string& variable) const {
  std::vector<std::size_t> lengths;
  for (const int id : dimension_ids(dimensions(variable))) lengths.push_back(length_of({id}));
  return lengths;
}

std::vector<double> NetcdfFile::numbers(const std::string& variable) const {
  const std::vector<std::size_t> extent = shape(variable);
  return numbers(variable, std::vector<std::size_t>(extent.size(), 0), extent);
}

std::vector<double> NetcdfFile::numbers(const std::string& variable,
                                        const std::vector<std::size_t>& start,
                                        const std::vector<std::size_t>& count) const {
  std::vector<double> values(product(count));
  if (values.empty()) return values;
  check(nc_get_vara_double(id_, variable_id(variable), start.data(), count.data(), values.data()),
        variable);
  return values;
}

void NetcdfFile::mask(const std::string& variable, const char* attribute,
                      std::vector<double>& values) const {
  if (const std::optional<double> missing = attribute_number(variable, attribute))
    std::replace(values.begin(), values.end(), *missing, std::numeric_limits<double>::quiet_NaN());
}

std::vector<double> NetcdfFile::unpacked_numbers(const std::string& variable) const {
  const std::vector<std::size_t> extent = shape(variable);
  return unpacked_numbers(variable, std::vector<std::size_t>(extent.size(), 0), extent);
}

std::vector<double> NetcdfFile::unpacked_numbers(const std::string& variable,
                                                 const std::vector<std::size_t>& start,
                                                 const std::vector<std::size_t>& count) const {
  std::vector<double> values = numbers(variable, start, count);
  mask(variable, "_FillValue", values);
  mask(variable, "missing_value", values);
  const double scale = attribute_number(variable, "scale_factor").value_or(1.0);
  const double offset = attribute_number(variable, "add_offset").value_or(0.0);
  for (double& value : values) value = value * scale + offset;
  return values;
}

std::vector<std::string> NetcdfFile::texts(const std::string& variable) const {
  nc_type type = 0;
  const int id = variable_id(variable);
  check(nc_inq_vartype(id_, id, &type), variable);
  std::vector<std::size_t> extent = shape(variable);
  std::vector<std::string> values;
  if (type == NC_STRING) {
    std::vector<char*> pointers(product(extent), nullptr);
    check(nc_get_var_string(id_, id, pointers.data()), variable);
    for (const char* text : pointers) values.push_back(without_padding(text ? text : ""));
    check(nc_free_string(pointers.size(), pointers.data()), variable);
    return values;
  }
  if (type != NC_CHAR) fail_to_read(path_, variable + " holds no texts");
  std::string bytes(product(extent), '\0');
  check(nc_get_var_text(id_, id, bytes.data()), variable);
  const std::size_t length = extent.empty() ? 1 : extent.back();
  for (std::size_t at = 0; at < bytes.size(); at += length)
    values.push_back(without_padding(bytes.substr(at, length)));
  return values;
}

std::optional<std::string> NetcdfFile::attribute_text(const std::string& variable,
                                                      const std::string& name) const {
  const int id = variable_id(variable);
  nc_type type = 0;
  std::size_t length = 0;
  if (nc_inq_att(id_, id, name.c_str(), &type, &length) != NC_NOERR) return std::nullopt;
  if (type == NC_STRING && length == 1) {
    char* pointer = nullptr;
    check(nc_get_att_string(id_, id, name.c_str(), &pointer), name);
    std::string text = pointer ? pointer : "";
    check(nc_free_string(1, &pointer), name);
    return text;
  }
  if (type != NC_CHAR) return std::nullopt;
  std::string text(length, '\0');
  check(nc_get_att_text(id_, id, name.c_str(), text.data()), name);
  return without_padding(text);
}

std::optional<double> NetcdfFile::attribute_number(const std::string& variable,
                                                   const std::string& name) const {
  const int id = variable_id(variable);
  nc_type type = 0;
  std::size_t length = 0;
  if (nc_inq_att(id_, id, name.c_str(), &type, &length) != NC_NOERR) return std::nullopt;
  if (type == NC_CHAR || type == NC_STRING || length != 1) return std::nullopt;
  double value = 0.0;
  check(nc_get_att_double(id_, id, name.c_str(), &value), name);
  return value;
}

}  // namespace floe::io
