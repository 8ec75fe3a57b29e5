#pragma once

#include <floe/wave/directional_spectrum.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// What a user says about a file of measured spectra. Units and convention are for files that do
/// not say them; a file that says something else is refused.
struct MeasuredRequest {
  std::optional<std::size_t> time_index, site_index;  ///< from 0; for files that hold several
  std::string density_units;                          ///< "m2 s degree-1", "m2 s rad-1", "m2 s"
  std::string frequency_units;                        ///< "Hz"
  std::string direction_units;                        ///< "degree", "rad"
  std::string directions;                             ///< "coming-from", "going-to"
  std::optional<double> x_axis_bearing_deg;  ///< of the structure's +x, clockwise from north
};

/// One spectrum as a file holds it, and what the file says about it.
struct StoredSpectrum {
  std::vector<double> frequency, direction;  ///< no direction: summed over them
  std::vector<double> density;               ///< frequencies × directions, these run faster
  std::string density_units, frequency_units, direction_units;  ///< "" where the file is silent
  std::string direction_name;  ///< standard_name and long_name of the directions
};

/// A measured sea in the frame of the structure.
struct MeasuredSea {
  std::optional<wave::DirectionalSpectrum> directional;  ///< nothing: `spectrum` is all there is
  std::optional<wave::Spectrum> spectrum;                ///< S(ω)
  std::string description;
  std::vector<std::string> notices;  ///< what was repaired
};

/// Reads one spectrum of a netCDF file in the convention of wavespectra, `efth(time, site, freq,
/// dir)` or `efth(…, freq)`, or of WAVEWATCH III, `efth(time, station, frequency, direction)`; the
/// dimensions in any order. In a child process with limits of time and memory: a damaged file
/// cannot crash, hang or swell the program. Throws DataError `PATH: why`.
StoredSpectrum read_stored_spectrum(const std::filesystem::path& path,
                                    const MeasuredRequest& request);

/// Checks and converts it: density per Hz and degree or radian to (rad/s) and rad, directions
/// coming from or going to (clockwise from north) to headings (E.26). Frequencies and directions
/// are sorted, a direction given twice (0 and 360) with the same values is dropped once, negative
/// values of rounding become 0; each with a notice. Throws DataError when units or convention are
/// neither in the file nor in the request, or differ; when a value is missing or negative, a
/// frequency double, the directions do not go round, or nothing is left.
MeasuredSea measured_sea(StoredSpectrum stored, const MeasuredRequest& request);

}  // namespace floe::io
