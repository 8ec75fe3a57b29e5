#pragma once

#include "io/toml_section.hpp"

#include <floe/analysis.hpp>
#include <floe/wave/scatter_diagram.hpp>

#include <filesystem>

/// The sections of a case file, one function each, in the order in which they need each other.
namespace floe::io {

void read_water(const Section& root, Case& data);
/// Needs the water; paths are taken from `folder`.
void read_plate(const Section& root, const std::filesystem::path& folder, Case& data);
std::vector<std::string> plate_keys();
/// `[mesh]`, and `[plate] mesh` if given; paths are taken from `folder`.
void read_meshes(const Section& root, const std::filesystem::path& folder, Case& data);
void read_modes(const Section& root, Case& data);
void read_waves(const Section& root, Case& data);  ///< needs the water
void read_solver(const Section& root, Case& data);
void read_output(const Section& root, Case& data);  ///< needs the waves
/// Cross-spectra and combinations in `[output]`; needs its points and quantities.
void read_relations(const Section& output, Case& data);
/// `[sea_grid]` and `[[sea]]`; a fault of a sea is a DataError.
void read_seas(const Section& root, const std::filesystem::path& folder, Case& data);
/// `[[sea]]` alone; the paths of measured spectra are taken from `folder`.
std::vector<wave::SeaState> read_sea_states(const Section& root,
                                            const std::filesystem::path& folder);
/// `[[scatter]]`; the paths of its tables are taken from `folder`.
std::vector<wave::WaveClimate> read_wave_climates(const Section& root,
                                                  const std::filesystem::path& folder);

/// Refuses a name that would be special in a table or a spreadsheet.
void check_name(std::string_view name, const toml::source_region& place, const std::string& what,
                const CaseSource& source);

/// The table of named things under a key, empty where it is not given; checks the names.
const toml::table& named_table(const Section& section, const std::string& key);

/// The keys under which waves can be named, and the frequency [rad/s] that a value of one means.
const std::vector<std::string>& wave_axes();
double axis_frequency(const std::string& axis, double value, const wave::Water& water);
/// What a value on an axis must be.
NumberRule axis_rule(const std::string& axis);
/// What a heading must be.
NumberRule heading_rule();
/// A warning where values under a key in degrees look like radians.
void warn_of_radians(const Section& section, const std::string& key,
                     const std::vector<double>& degrees);

}  // namespace floe::io
