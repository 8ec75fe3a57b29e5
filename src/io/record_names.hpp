#pragma once

#include <cstddef>
#include <string>

/// Where records lie in a result directory.
namespace floe::io {

inline const std::string kManifest = "records/manifest.json";
inline const std::string kFluidMesh = "records/mesh.rec";
inline const std::string kModeMesh = "records/plate_mesh.rec";  // only where it is another one
inline const std::string kModes = "records/modes.rec";
inline const std::string kObservation = "records/sea_observation.rec";
inline const std::string kSeaGrid = "records/sea_grid.rec";  // written when the seas are done

inline std::string numbered_record(const std::string& what, std::size_t place) {
  std::string digits = std::to_string(place + 1);
  if (digits.size() < 5) digits.insert(0, 5 - digits.size(), '0');
  return "records/" + what + "_" + digits + ".rec";
}

}  // namespace floe::io
