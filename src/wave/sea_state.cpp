#include <floe/wave/sea_state.hpp>

namespace floe::wave {
namespace {

// Partitions add up; zones are told by their mean
double over_all(const SeaState& sea, double sum) {
  return sea.zones ? sum / static_cast<double>(sea.partitions.size()) : sum;
}

}  // namespace

double SeaState::density(double omega) const {
  double sum = 0.0;
  for (const Partition& partition : partitions) sum += partition.spectrum(omega);
  return over_all(*this, sum);
}

double SeaState::variance(double from, double to) const {
  double sum = 0.0;
  for (const Partition& partition : partitions) sum += partition.spectrum.variance(from, to);
  return over_all(*this, sum);
}

double SeaState::m0() const {
  double sum = 0.0;
  for (const Partition& partition : partitions) sum += partition.spectrum.m0();
  return over_all(*this, sum);
}

}  // namespace floe::wave
