#pragma once

#include "test_case.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

/// What runs of the program leave in their folders, compared byte by byte.
namespace floe::test {

/// All products of a result folder but `run.json`, which tells times; records are no products.
inline std::map<std::string, std::string> products_in(const TestFolder& folder,
                                                      const std::string& name) {
  std::map<std::string, std::string> products;
  const auto root = folder.path() / name;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string file = std::filesystem::relative(entry.path(), root).string();
    const bool record = file.starts_with("records/");
    if (entry.is_regular_file() && file != "run.json" && !record)
      products[file] = folder.read(name + "/" + file);
  }
  return products;
}

/// The same products with the same bytes, and nothing under construction left.
inline void expect_same_products(const TestFolder& folder, const std::string& a,
                                 const std::string& b) {
  const auto expected = products_in(folder, a), actual = products_in(folder, b);
  for (const auto& [name, content] : actual) EXPECT_TRUE(expected.contains(name)) << name;
  for (const auto& [name, content] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name;
    EXPECT_EQ(actual.at(name), content) << name;
  }
}

}  // namespace floe::test
