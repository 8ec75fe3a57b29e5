#pragma once

#include <floe/analysis.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// Writes one wave's node field for ParaView: unstructured grid of quadratic quads (cell type 23),
/// appended raw data in zlib-compressed blocks. Point data per metre of wave amplitude: w_re, w_im,
/// w_abs, w_phase [m, rad], rotation_x_re … rotation_y_im [rad], p_re, p_im [Pa].
/// Throws ConvergenceError when a value is not finite, FileError when writing fails.
void write_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh, const NodeField& field);

/// Writes one moment of a node field's motion for a wave of one metre: at `phase` [rad] the real
/// part of X e^{-i phase}. Point data w [m], displacement (0, 0, w) for ParaView's Warp By Vector,
/// p [Pa].
void write_phase_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
                     const NodeField& field, double phase);

/// Equidistant points, x running fastest.
struct PointGrid {
  Point2 origin = Point2::Zero();
  double step = 0.0;  ///< [m]
  Index columns = 0;  ///< along x
  Index rows = 0;     ///< along y
  Points2 points() const;
};

/// Writes the elevation of the whole wave at the points of a grid as ImageData: zeta_re, zeta_im,
/// zeta_abs [m/m], zeta_phase [rad], on_plate (1 under the plate, where it is w + p/ρg).
/// Throws ConvergenceError when a value is not finite.
void write_surface_vti(const std::filesystem::path& path, const PointGrid& grid,
                       const VecXcd& elevation, const std::vector<std::uint8_t>& on_plate,
                       double omega, double heading_deg);

/// Writes the standard deviation of the deflection and its zero-crossing period everywhere, for all
/// seas and mean headings: point data std_w_NAME_HEADING [m] and period_w_NAME_HEADING [s].
void write_statistics_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
                          const std::vector<SeaResult>& results);

/// One file of a collection.
struct PvdEntry {
  double omega = 0.0;  ///< or what else the time step is to be
  int heading = 0;     ///< number of the heading: ParaView's "part"
  std::string file;    ///< relative to the collection
};

/// Writes a ParaView collection over frequencies: the time step is ω.
void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries);

}  // namespace floe::io
