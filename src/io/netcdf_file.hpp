#pragma once

#include "io/atomic_file.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace floe::io {

/// Whether a variable is stored deflated (lossless).
enum class Compression { kNone, kDeflate };

/// A netCDF file: NETCDF4 or of the 64-bit classic kind when written, any kind when read. Closed by
/// the destructor; after writing call `close`, which tells whether everything arrived. Numbers are
/// doubles whatever the file has;
/// texts are arrays of characters, the last dimension their length, in UTF-8.
/// Every return code of the library is looked at: what goes wrong while writing throws FileError,
/// while reading DataError, with the file's name and the library's words.
class NetcdfFile final {
 public:
  /// A new NETCDF4 file, made in memory and written when it is closed, as AtomicFile does.
  /// NOTE: HDF5 must not meet a full disk, it would try again when the process ends, and crash.
  static NetcdfFile create(const std::filesystem::path& path);
  /// A new file that grows on the disk, without compression; what has this name is overwritten.
  static NetcdfFile create_classic(const std::filesystem::path& path);
  /// An existing file, to read. Also throws DataError when it is no netCDF file.
  static NetcdfFile open(const std::filesystem::path& path);
  ~NetcdfFile();
  NetcdfFile(NetcdfFile&& other) noexcept;
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  NetcdfFile& operator=(NetcdfFile&&) = delete;
  void close();

  // Writing

  void add_dimension(const std::string& name, std::size_t length);
  /// Of a variable that is there already; of the file where `variable` is "".
  void add_attribute(const std::string& variable, const std::string& name, const std::string& text);
  void add_attribute(const std::string& variable, const std::string& name, double value);
  /// A whole variable, the last dimension running fastest; no dimension: a scalar.
  void add_numbers(const std::string& name, const std::vector<std::string>& dimensions,
                   std::span<const double> values, Compression compression = Compression::kNone);
  void add_integers(const std::string& name, const std::vector<std::string>& dimensions,
                    std::span<const int> values);
  /// Characters (values…, stringN) with N the longest length, attribute `_Encoding` = utf-8.
  void add_texts(const std::string& name, const std::vector<std::string>& dimensions,
                 const std::vector<std::string>& values);
  /// A variable, deflated where the file can, that is filled part by part, a part for each place of
  /// the first `split` dimensions.
  void define_parts(const std::string& name, const std::vector<std::string>& dimensions,
                    std::size_t split);
  void put_part(const std::string& name, const std::vector<std::size_t>& start,
                const std::vector<std::size_t>& count, std::span<const double> values);

  // Reading

  bool holds(const std::string& variable) const;
  std::vector<std::string> variables() const;
  /// Names and lengths of a variable's dimensions, slowest first.
  std::vector<std::string> dimensions(const std::string& variable) const;
  std::vector<std::size_t> shape(const std::string& variable) const;
  /// All values as they are stored, or those of a part.
  std::vector<double> numbers(const std::string& variable) const;
  std::vector<double> numbers(const std::string& variable, const std::vector<std::size_t>& start,
                              const std::vector<std::size_t>& count) const;
  /// The values meant: `scale_factor` and `add_offset` applied, NaN for `_FillValue` and
  /// `missing_value`.
  std::vector<double> unpacked_numbers(const std::string& variable) const;
  std::vector<double> unpacked_numbers(const std::string& variable,
                                       const std::vector<std::size_t>& start,
                                       const std::vector<std::size_t>& count) const;
  /// Texts without the padding (zeros, blanks) at their ends; from characters or from strings.
  std::vector<std::string> texts(const std::string& variable) const;
  /// Nothing where there is no such attribute or it is of the other kind.
  std::optional<std::string> attribute_text(const std::string& variable,
                                            const std::string& name) const;
  std::optional<double> attribute_number(const std::string& variable,
                                         const std::string& name) const;

 private:
  enum class Mode { kWrite, kWriteClassic, kRead };
  NetcdfFile(std::filesystem::path path, Mode mode, int id);
  void check(int status, const std::string& what = "") const;
  int variable_id(const std::string& name) const;
  std::vector<int> dimension_ids(const std::vector<std::string>& names) const;
  void describe();
  void fill();
  int define(const std::string& name, int type, const std::vector<int>& dimensions,
             Compression compression);
  std::size_t length_of(const std::vector<int>& dimensions) const;
  void mask(const std::string& variable, const char* attribute, std::vector<double>& values) const;

  std::filesystem::path path_;
  Mode mode_;
  int id_;
  bool describing_ = true;              // a classic file is either described or filled
  std::unique_ptr<AtomicFile> output_;  // of what is made in memory
};

}  // namespace floe::io
