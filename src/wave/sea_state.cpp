#include <floe/wave/sea_state.hpp>

namespace floe::wave {

double SeaState::density(double omega) const {
  double sum = 0.0;
  for (const Partition& partition : partitions) sum += partition.spectrum(omega);
  return sum;
}

double SeaState::variance(double from, double to) const {
  double sum = 0.0;
  for (const Partition& partition : partitions) sum += partition.spectrum.variance(from, to);
  return sum;
}

double SeaState::m0() const {
  double sum = 0.0;
  for (const Partition& partition : partitions) sum += partition.spectrum.m0();
  return sum;
}

}  // namespace floe::wave
