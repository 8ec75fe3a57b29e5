#pragma once

#include <floe/io/stored_run.hpp>
#include <floe/plate/body_dofs.hpp>

#include <filesystem>
#include <vector>

/// A stored run in the files that other programs read. Each appears under its name when it is
/// complete; made from the run's records alone, the same records give the same numbers bit by bit.
/// Throw StoreError when records are missing or damaged, FileError when writing fails.
namespace floe::io {

/// One netCDF-4 file with the names, dimensions, units and signs of capytaine 3: coefficients,
/// forces and motions, then what capytaine does not have: structure, modes, node fields, points,
/// seas. docs/howto/result_nc.md lists the variables.
void write_netcdf(const StoredRun& run, const std::filesystem::path& path, plate::DofSet dofs);

/// WAMIT's text files STEM.1, .3, .3fk, .3sc, .4 and .hst: complex conjugates, headings in degrees,
/// divided by ρ, g, ω and powers of `length` [m]; one header line each. `dofs` must be one of the
/// sets with six rigid motions. Returns the files' names.
std::vector<std::filesystem::path> write_wamit(const StoredRun& run,
                                               const std::filesystem::path& stem,
                                               plate::DofSet dofs, double length = 1.0);

}  // namespace floe::io
