#pragma once

#include "io/atomic_file.hpp"
#include "io/netcdf_file.hpp"

#include <floe/analysis.hpp>

#include <filesystem>
#include <vector>

namespace floe::io {

/// Spectra of the deflection at all nodes, `node_spectra.nc`: variable spectrum(sea, omega, node)
/// [m² s/rad], written one sea and frequency at a time, with the names and mean headings of the
/// seas, ω [rad/s] and the nodes' x, y [m]. Appears under its name with `commit`.
class NodeSpectraFile {
 public:
  static constexpr const char* kName = "node_spectra.nc";

  NodeSpectraFile(const std::filesystem::path& folder, const mesh::Q8Mesh& mesh,
                  const std::vector<wave::SeaState>& seas, const std::vector<double>& omega);

  /// `result` counts the mean headings of all seas, `frequency` the frequencies, from 0.
  void put(std::size_t result, std::size_t frequency, const VecXd& spectrum);
  void commit();

 private:
  PendingFile pending_;
  NetcdfFile file_;
};

}  // namespace floe::io
