#include <floe/response/wave_directions.hpp>

#include <cmath>
#include <numbers>

namespace floe::response {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// The directions of a table, and between two of them as many more as keep steps below `step`;
// weights are those of the rule of trapezoids, exact for straight lines
DirectionGrid refined(const std::vector<double>& heading, double step) {
  DirectionGrid grid;
  for (std::size_t j = 0; j < heading.size(); ++j) {
    const double from = heading[j];
    const double to = j + 1 < heading.size() ? heading[j + 1] : heading.front() + kTurn;
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / step - 1e-9)));
    for (int i = 0; i < parts; ++i) grid.heading.push_back(from + (to - from) * i / parts);
  }
  const std::size_t count = grid.heading.size();
  for (std::size_t b = 0; b < count; ++b) {
    const double before = b > 0 ? grid.heading[b - 1] : grid.heading.back() - kTurn;
    const double after = b + 1 < count ? grid.heading[b + 1] : grid.heading.front() + kTurn;
    grid.weight.push_back(0.5 * (after - before));
  }
  return grid;
}

// Straight lines around the circle, headings × directions of the table
MatXd lines_between(const std::vector<double>& table, const std::vector<double>& heading) {
  MatXd matrix = MatXd::Zero(static_cast<Index>(heading.size()), static_cast<Index>(table.size()));
  std::size_t j = 0;
  for (std::size_t b = 0; b < heading.size(); ++b) {
    while (j + 1 < table.size() && heading[b] >= table[j + 1]) ++j;
    const std::size_t next = (j + 1) % table.size();
    const double to = next > 0 ? table[next] : table.front() + kTurn;
    const double share = (heading[b] - table[j]) / (to - table[j]);
    matrix(static_cast<Index>(b), static_cast<Index>(j)) += 1.0 - share;
    matrix(static_cast<Index>(b), static_cast<Index>(next)) += share;
  }
  return matrix;
}

DirectionGrid grid_of(const wave::Partition& partition, double mean_heading, int circle) {
  if (!partition.measured)
    return direction_grid(partition.spreading,
                          mean_heading + partition.turn_deg * std::numbers::pi / 180.0, circle);
  return refined(partition.measured->heading(), kTurn / circle);
}

}  // namespace

WaveDirections::WaveDirections(const wave::Partition& partition, double mean_heading, int circle)
    : partition_(partition),
      grid_(grid_of(partition, mean_heading, circle)),
      at_headings_(grid_.heading, circle) {
  if (partition.measured) from_table_ = lines_between(partition.measured->heading(), grid_.heading);
}

std::vector<double> WaveDirections::energies(double omega) const {
  std::vector<double> energy = grid_.weight;
  if (!partition_.measured) {
    const double density = partition_.spectrum(omega);
    for (double& value : energy) value *= density;
    return energy;
  }
  const VecXd density = from_table_ * partition_.measured->density(omega);
  for (std::size_t b = 0; b < energy.size(); ++b) energy[b] *= density[static_cast<Index>(b)];
  return energy;
}

MatXcd WaveDirections::pseudo(double omega, const MatXcd& circle) const {
  return pseudo_amplitudes(at_headings_(circle), 1.0, energies(omega));
}

double WaveDirections::energy(double omega) const {
  double sum = 0.0;
  for (const double value : energies(omega)) sum += value;
  return sum;
}

double WaveDirections::spreading_sum() const {
  double sum = 0.0;
  if (partition_.measured) return 1.0;
  for (const double value : grid_.weight) sum += value;
  return sum;
}

}  // namespace floe::response
