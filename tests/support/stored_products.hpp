#pragma once

#include "io/netcdf_file.hpp"
#include "test_case.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

/// What runs of the program leave in their folders, compared byte by byte.
namespace floe::test {

/// All products of a result folder but `run.json` and `result.nc`, which tell times; records are no
/// products.
inline std::map<std::string, std::string> products_in(const TestFolder& folder,
                                                      const std::string& name) {
  std::map<std::string, std::string> products;
  const auto root = folder.path() / name;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string file = std::filesystem::relative(entry.path(), root).string();
    const bool record = file.starts_with("records/");
    if (entry.is_regular_file() && file != "run.json" && file != "result.nc" && !record)
      products[file] = folder.read(name + "/" + file);
  }
  return products;
}

/// Every variable of a netCDF file as its names and bytes; attributes may tell times.
inline std::map<std::string, std::string> variables_in(const std::filesystem::path& path) {
  const io::NetcdfFile file = io::NetcdfFile::open(path);
  std::map<std::string, std::string> variables;
  for (const std::string& name : file.variables()) {
    std::string& text = variables[name];
    for (const std::string& dimension : file.dimensions(name)) text += dimension + " ";
    if (file.attribute_text(name, "_Encoding")) {
      for (const std::string& value : file.texts(name)) text += "\"" + value + "\"";
      continue;
    }
    const std::vector<double> numbers = file.numbers(name);
    text.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  }
  return variables;
}

/// The same products with the same bytes, the same variables, and nothing under construction left.
inline void expect_same_products(const TestFolder& folder, const std::string& a,
                                 const std::string& b) {
  const auto expected = products_in(folder, a), actual = products_in(folder, b);
  for (const auto& [name, content] : actual) EXPECT_TRUE(expected.contains(name)) << name;
  for (const auto& [name, content] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name;
    EXPECT_EQ(actual.at(name), content) << name;
  }
  const auto variables = variables_in(folder.path() / a / "result.nc");
  EXPECT_GT(variables.size(), 20u);
  EXPECT_TRUE(variables == variables_in(folder.path() / b / "result.nc"));
}

}  // namespace floe::test
