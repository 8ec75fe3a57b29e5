#pragma once

#include "io/toml_section.hpp"

#include <floe/wave/sea_state.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// Seas that are not one spectrum with one spreading: measured ones, and those of zones.
namespace floe::io {

/// The keys of a sea that belong to `spectrum = "measured"`, and to `[[sea.zone]]`.
const std::vector<std::string>& measured_keys();
const std::vector<std::string>& zone_keys();

/// A spectrum from a netCDF file, its path taken from `folder`. Repairs are told as notices.
void read_measured(const Section& sea, const std::filesystem::path& folder, wave::SeaState& state);

/// Spectra of zones, one a table of `list`; mean headings are left to the caller.
void read_zones(const Section& sea, const toml::array& list, wave::SeaState& state);

/// Refuses those of the keys that are given without what they belong to.
void refuse_keys_without(const Section& sea, const std::string& owner,
                         const std::vector<std::string>& keys);

}  // namespace floe::io
