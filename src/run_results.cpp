#include <floe/run_results.hpp>

namespace floe {

void MemoryStore::begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate&) {
  results_.data = data;
  results_.fluid_mesh = mesh;
  results_.mode_mesh = mesh;  // until there are modes
}

void MemoryStore::modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) {
  results_.modes = modes;
  results_.mode_mesh = mesh;
}

void MemoryStore::frequency(const FrequencyResult& result) {
  results_.frequencies.push_back(result);
}

void MemoryStore::begin_seas(const SeaObservation& observation, const SeaGridReport&) {
  results_.observation = observation;
}

void MemoryStore::sea_transfer(const SeaTransfer& transfer) {
  results_.transfers.push_back(transfer);
}

void MemoryStore::sea(const SeaResult& result) { results_.seas.push_back(result); }

void MemoryStore::end_seas(const SeaGridReport& grid) { results_.sea_grid = grid; }

void MemoryStore::finish(const std::vector<StageTime>& times) { results_.stages = times; }

RunResults analyse(const Case& data) {
  RunResults results;
  MemoryStore store(results);
  MemoryLog log(results);
  analyse(data, log, store);
  return results;
}

}  // namespace floe
