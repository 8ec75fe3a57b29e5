#pragma once

#include "io/netcdf_file.hpp"
#include "test_case.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

/// What runs of the program leave in their folders, compared byte by byte.
namespace floe::test {

/// result.nc tells when it was made, unless it is told.
inline const struct FixedTime {
  FixedTime() { ::setenv("SOURCE_DATE_EPOCH", "0", 1); }
} kFixedTime;

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

/// Every variable of a netCDF file as its dimensions and bytes.
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

/// `run.json` without what two equal runs may differ in: times, threads, memory, records set aside.
inline nlohmann::json lasting_account(const TestFolder& folder, const std::string& name) {
  nlohmann::json run = nlohmann::json::parse(folder.read(name + "/run.json"));
  for (const char* key : {"plan", "stages", "seconds_before", "peak_memory", "files"})
    run.erase(key);
  for (nlohmann::json& frequency : run.at("frequencies")) frequency.erase("seconds");
  return run;
}

/// The same products with the same bytes, the same account, and nothing under construction left.
/// Runs by the modal route have a result.nc, of which each variable is compared by name, too.
inline void expect_same_products(const TestFolder& folder, const std::string& a,
                                 const std::string& b) {
  const auto expected = products_in(folder, a), actual = products_in(folder, b);
  for (const auto& [name, content] : actual) EXPECT_TRUE(expected.contains(name)) << name;
  for (const auto& [name, content] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name;
    EXPECT_TRUE(actual.at(name) == content) << name << " differs";
  }
  const nlohmann::json account = lasting_account(folder, a);
  EXPECT_EQ(account, lasting_account(folder, b));
  EXPECT_EQ(expected.contains("result.nc"), account.at("route") == "modal");
  if (!expected.contains("result.nc")) return;
  const auto variables = variables_in(folder.path() / a / "result.nc");
  EXPECT_GT(variables.size(), 20u);
  EXPECT_TRUE(variables == variables_in(folder.path() / b / "result.nc"));
}

}  // namespace floe::test
