#pragma once

#include "program/account.hpp"

#include <floe/io/interchange.hpp>
#include <floe/mesh/shapes.hpp>

#include <filesystem>

/// The commands of the program, one function each. They throw; `run_command_line` turns what they
/// throw into the exit code.
namespace floe::program {

struct RunOptions {
  std::filesystem::path case_file;
  std::filesystem::path output;  ///< empty: the case's name + ".out" in the working directory
  int threads = 0;               ///< 0: as many as the process may use
  double memory = 0.0;           ///< [byte]; 0: what the machine allows
  double max_time = 0.0;         ///< [s]; 0: no limit
  bool fresh = false;
  bool resume = false;  ///< go on with an earlier run of the same case
  bool allow_coarse = false;
  Shard shard;  ///< the part of the sweep to run
  ProgressStyle progress = ProgressStyle::kAuto;
};

/// Runs a case and stores its results.
void run_case(const RunOptions& options);

/// Tells what a run would do and need, and refuses what a run would refuse; solves nothing.
void check_case(const RunOptions& options);

/// Solves a case on finer and finer meshes and with more modes, and tells the error of its answers.
void tell_convergence(const RunOptions& options);

struct StatsOptions {
  std::filesystem::path directory;  ///< of a run
  std::filesystem::path sea_file;
  std::filesystem::path output;  ///< empty: the sea file's name + ".out" in the working directory
  bool fresh = false;
};

/// Statistics of new seas from the transfer functions of a run; solves nothing.
void tell_statistics(const StatsOptions& options);

struct ReportOptions {
  std::filesystem::path directory;  ///< of a run
  std::filesystem::path output;     ///< empty: report.html in it
};

/// Writes the report of a run, one HTML page.
void make_report(const ReportOptions& options);

struct StatusOptions {
  std::filesystem::path directory;  ///< of a run
  bool json = false;
};

/// Tells how far a run is, without disturbing it.
void tell_status(const StatusOptions& options);

struct ExportOptions {
  std::filesystem::path directory;  ///< of a run
  std::string format;               ///< "netcdf", "wamit", "paraview"; empty: own products
  bool rigid_only = false;          ///< the six rigid motions of each body and nothing else
  bool all_dofs = false;            ///< these and the elastic modes
  double length = 1.0;              ///< of WAMIT's normalisation [m]
  io::ParaviewOptions paraview;
  std::filesystem::path output;  ///< file, WAMIT's stem, ParaView's folder; empty: in the directory
};

/// Writes a run as files that other programs read.
void export_for_others(const ExportOptions& options);

/// Makes all products of a run anew from its records.
void remake_products(const std::filesystem::path& directory);

/// One or the other, as the format says.
void export_results(const ExportOptions& options);

struct MergeOptions {
  std::vector<std::filesystem::path> parts;  ///< directories of runs with --shard
  std::filesystem::path output;
  bool fresh = false;
};

/// Puts the parts of a sweep together. Throws ConvergenceError where some are missing.
void merge_results(const MergeOptions& options);

struct MeshOptions {
  mesh::Shape shape;
  std::filesystem::path output;
};

/// Writes the mesh of a shape.
void make_mesh(const MeshOptions& options);

struct InitOptions {
  std::filesystem::path case_file;
  std::filesystem::path mesh;            ///< empty: a rectangle
  double length = 300.0, width = 60.0;   ///< of the rectangle [m]
  double thickness = 2.0, depth = 58.5;  ///< [m]
  std::vector<double> sea;               ///< empty, or significant height [m] and period [s]
  std::vector<double> heading_deg = {0.0, 45.0, 90.0};
};

/// Writes a commented case file for a mesh and a sea; never over one that is there.
void make_new_case(const InitOptions& options);

/// The case with what the command line adds to it; tells notices and warnings of the reading.
Case read_case_for(const RunOptions& options, Account& account);

/// Sets the number of threads; a notice when they are more than the process may use.
void use_threads(int threads, Account& account);

/// "1 element", "2 elements".
std::string counted(Index count, const std::string& what);

}  // namespace floe::program
