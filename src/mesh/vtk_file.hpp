#pragma once

#include "mesh/vtk_array.hpp"

#include <floe/numeric/types.hpp>

#include <pugixml.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace floe::mesh {

/// A VTU file: its XML, and its arrays whatever their encoding. Keeps a view of the bytes. What is
/// wrong becomes a MeshError that names the file and the array.
class VtkFile {
 public:
  VtkFile(std::string_view bytes, std::string file_name);

  /// The one piece of the grid.
  const pugi::xml_node& piece() const { return piece_; }
  /// The count that an attribute of the piece tells.
  Index count(const char* attribute) const;

  /// The array of that name below a child of the piece; with an empty name the only one there.
  pugi::xml_node find(const char* child, const char* name) const;
  pugi::xml_node require(const char* child, const char* name) const;

  std::vector<double> reals(const pugi::xml_node& array) const;
  std::vector<std::int64_t> integers(const pugi::xml_node& array) const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  void check_root(const pugi::xml_node& root);
  template <typename Number>
  std::vector<Number> numbers(const pugi::xml_node& array) const;
  std::string bytes_of(const pugi::xml_node& array) const;

  std::string file_name_;
  pugi::xml_document document_;
  pugi::xml_node piece_;
  VtkEncoding encoding_;
};

}  // namespace floe::mesh
