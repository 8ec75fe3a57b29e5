#pragma once

#include "test_case.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

/// What the case file's reader says of sections behind those of kCaseText.
namespace floe::test {

inline Case read_with(const std::string& sections) {
  const TestFolder folder;
  return io::read_case(folder.write("case.toml", kCaseText + sections)).data;
}

/// The message of a fault, without its folder; only a DataError becomes exit code 5.
inline std::string refusal(const std::string& sections) {
  const TestFolder folder;
  const auto path = folder.write("case.toml", kCaseText + sections);
  try {
    io::read_case(path);
  } catch (const DataError& error) {
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
  return "accepted";
}

}  // namespace floe::test
