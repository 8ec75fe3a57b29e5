#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

/// Readers of files that come from outside, as functions of bytes. Whatever the bytes, a reader
/// returns or throws an error of floe; anything else is a defect.
namespace floe::fuzz {

struct Target {
  std::string name;  ///< of its corpus, a folder beside this file
  std::function<void(std::string_view)> read;
};

inline void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

const std::vector<Target>& targets();

/// Reads and forgets the errors of floe.
void run(const Target& target, std::string_view bytes);

}  // namespace floe::fuzz
