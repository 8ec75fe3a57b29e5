#pragma once

#include "floe_program.hpp"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

/// Faults that the program must survive, as tables: what is wrong, and what the program does.
namespace floe::test {

/// One way to harm a run. Whatever happens, the program ends by itself, says one line of error or
/// none, and writes nowhere but into its output directory `case.out`.
struct Fault {
  int row;                       ///< of the list in rows.hpp
  std::string name;              ///< CamelCase
  int code;                      ///< exit code
  std::string says;              ///< part of the error, or of the output where there is none
  std::string text = kCaseText;  ///< of case.toml; empty: no such file
  std::string arguments = "check case.toml";            ///< of the program
  std::function<void(const TestFolder&)> prepare = {};  ///< what lies there besides
  std::string before = {};                              ///< put before the program by the shell
};

inline std::ostream& operator<<(std::ostream& out, const Fault& fault) {
  return out << "row " << fault.row << ", " << fault.name;
}

/// Runs the program on the fault and holds what it did against the table.
void expect_survived(const Fault& fault);

std::vector<Fault> case_faults();      ///< rows 1 … 18
std::vector<Fault> mesh_faults();      ///< rows 19 … 35
std::vector<Fault> sea_faults();       ///< rows 36 … 41
std::vector<Fault> resource_faults();  ///< rows 42 … 55
std::vector<Fault> disk_faults();      ///< rows 56 … 72

/// The case on a mesh file.
std::string with_mesh_file(const std::string& name);

}  // namespace floe::test
