#include "mesh/hull_format.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace floe::mesh {
namespace {

constexpr std::size_t kLinesNeeded = 5;

// The first lines that are not blank
std::vector<std::string> first_lines(std::string_view bytes) {
  std::vector<std::string> lines;
  std::string_view rest = bytes.substr(0, 4096);
  while (!rest.empty() && lines.size() < kLinesNeeded) {
    const std::size_t end = rest.find('\n');
    const std::string line(rest.substr(0, end));
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return lines;
}

// The numbers at the start of a line; Fortran's 1.D0 too
std::vector<double> leading_numbers(std::string line) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::vector<double> numbers;
  const char *at = line.data(), *const last = at + line.size();
  while (true) {
    while (at < last && std::isspace(static_cast<unsigned char>(*at))) ++at;
    double value = 0.0;
    const auto [end, error] = std::from_chars(at, last, value);
    if (error != std::errc()) return numbers;
    numbers.push_back(value);
    at = std::find_if(end, last, [](unsigned char c) { return std::isspace(c); });
  }
}

bool is_one_of_two(double value, double a, double b) { return value == a || value == b; }

// 2 isym / 1 x y z
bool is_nemoh(const std::vector<std::string>& lines) {
  const std::vector<double> first = leading_numbers(lines[0]), second = leading_numbers(lines[1]);
  return first.size() == 2 && first[0] == 2.0 && is_one_of_two(first[1], 0.0, 1.0) &&
         second.size() == 4 && second[0] == 1.0;
}

// Any text / ULEN GRAV / ISX ISY / NPAN / numbers
bool is_wamit(const std::vector<std::string>& lines) {
  const std::vector<double> units = leading_numbers(lines[1]), symmetry = leading_numbers(lines[2]),
                            count = leading_numbers(lines[3]);
  return units.size() == 2 && units[0] > 0.0 && symmetry.size() == 2 &&
         is_one_of_two(symmetry[0], 0.0, 1.0) && is_one_of_two(symmetry[1], 0.0, 1.0) &&
         !count.empty() && count.size() <= 2 && count[0] >= 1.0 &&
         count[0] == std::floor(count[0]) && leading_numbers(lines[4]).size() >= 2;
}

bool is_hams(const std::vector<std::string>& lines) {
  std::string line = lines[0];
  std::transform(line.begin(), line.end(), line.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return line.find("hull mesh file") != std::string::npos ||
         line.find("waterplane mesh file") != std::string::npos;
}

}  // namespace

std::string_view hull_format(std::string_view bytes) {
  std::vector<std::string> lines = first_lines(bytes);
  if (lines.empty()) return "";
  lines.resize(kLinesNeeded);
  if (is_hams(lines)) return "HAMS .pnl";
  if (is_nemoh(lines)) return "NEMOH .dat";
  if (is_wamit(lines)) return "WAMIT .gdf";
  return "";
}

}  // namespace floe::mesh
