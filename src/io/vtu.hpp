#pragma once

#include <floe/analysis.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// Writes one wave's node field for ParaView: unstructured grid of quadratic quads (cell type 23),
/// appended raw data in zlib-compressed blocks. Point data per metre of wave amplitude: w_re, w_im,
/// w_abs, w_phase [m, rad], rotation_x_re … rotation_y_im [rad], p_re, p_im [Pa].
/// Throws ConvergenceError when a value is not finite, FileError when writing fails.
void write_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh, const NodeField& field);

/// Writes the standard deviation of the deflection and its zero-crossing period everywhere, for all
/// seas and mean headings: point data std_w_NAME_HEADING [m] and period_w_NAME_HEADING [s].
void write_statistics_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
                          const std::vector<SeaResult>& results);

/// One file of a collection.
struct PvdEntry {
  double omega = 0.0;
  int heading = 0;   ///< number of the heading: ParaView's "part"
  std::string file;  ///< relative to the collection
};

/// Writes a ParaView collection over frequencies: the time step is ω.
void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries);

}  // namespace floe::io
