#pragma once

#include "io/body_results.hpp"
#include "io/netcdf_file.hpp"

#include <floe/io/stored_run.hpp>

#include <string>
#include <vector>

/// The parts of result.nc, one function each.
namespace floe::io {

/// Gives a variable its `long_name`, and `units` and `comment` where they are not "".
void describe(NetcdfFile& file, const std::string& variable, const std::string& long_name,
              const std::string& units = "", const std::string& comment = "");

/// The dimension `name` and a variable of that name, where there is anything.
void add_axis(NetcdfFile& file, const std::string& name, const std::vector<std::string>& labels,
              const std::string& long_name);

/// Real parts, then imaginary parts, of one matrix a frequency (rows × headings), in the order
/// complex, frequency, heading, row.
std::vector<double> split_complex(const std::vector<MatXcd>& matrices);

/// Frequencies, headings, degrees of freedom, bodies, water: what all other parts need.
void add_coordinates(NetcdfFile& file, const StoredRun& run, const BodyResults& results);
/// What capytaine has, and the structure.
void add_hydrodynamics(NetcdfFile& file, const BodyResults& results);
/// What the solution of each frequency is worth.
void add_solver(NetcdfFile& file, const BodyResults& results);
/// Nodes, elements and the shapes of the degrees of freedom.
void add_plate(NetcdfFile& file, const StoredRun& run, const BodyResults& results);
/// Points, lines, wave points and node fields.
void add_places(NetcdfFile& file, const StoredRun& run, const BodyResults& results);
/// Spectra and statistics.
void add_seas(NetcdfFile& file, const StoredRun& run);

}  // namespace floe::io
