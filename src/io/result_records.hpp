#pragma once

#include "io/record.hpp"

#include <floe/analysis.hpp>

#include <string>

/// What a run computes, as records and back. All numbers keep all their bits.
namespace floe::io {

/// The entry of a frequency that tells its wall time: two runs differ in it.
inline const std::string kSeconds = "seconds";
/// And the one that tells the kind of processor, in which they may differ.
inline const std::string kProcessor = "processor";

Record record_of(const mesh::Q8Mesh& mesh);
mesh::Q8Mesh mesh_from(const Record& record);

Record record_of(const plate::DryModes& modes);
plate::DryModes modes_from(const Record& record);

Record record_of(const FrequencyResult& result);
FrequencyResult frequency_from(const Record& record);

/// What is kept of a frequency that could not be solved: FrequencyReport::failure.
Record record_of_failure(const FrequencyReport& report);
std::string failure_from(const Record& record);

Record record_of(const SeaObservation& observation, const SeaGridReport& grid);
SeaObservation observation_from(const Record& record);
SeaGridReport sea_grid_from(const Record& record);

Record record_of(const SeaGridReport& grid);
SeaGridReport finished_grid_from(const Record& record);

Record record_of(const SeaTransfer& transfer);
SeaTransfer transfer_from(const Record& record);

Record record_of(const FluidSample& sample);
FluidSample sample_from(const Record& record);

Record record_of(const SeaMarch& march);
SeaMarch march_from(const Record& record);

Record record_of(const SeaResult& result);
SeaResult sea_from(const Record& record);

}  // namespace floe::io
