#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// Where records lie in a result directory.
namespace floe::io {

inline const std::string kRecords = "records";
inline const std::string kBadRecords = "records/bad";  // what was found damaged
inline const std::string kManifest = "records/manifest.json";
inline const std::string kFluidMesh = "records/mesh.rec";
inline const std::string kModeMesh = "records/plate_mesh.rec";  // only where it is another one
inline const std::string kModes = "records/modes.rec";
inline const std::string kObservation = "records/sea_observation.rec";
inline const std::string kSeaMarch = "records/sea_march.rec";  // until the seas are done
inline const std::string kSeaGrid = "records/sea_grid.rec";    // written when the seas are done

/// "records/frequency_00001.rec" for place 0.
std::string numbered_record(const std::string& what, std::size_t place);

/// Whether a file name, without its folder, is one that floe gives to records.
bool is_record_name(const std::string& name);

/// All files under `records/`, the bad ones too, that have names of records; relative to the
/// directory, sorted. Empty where there is no such folder.
std::vector<std::string> records_in(const std::filesystem::path& directory);

}  // namespace floe::io
