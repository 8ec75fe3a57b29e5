#include <floe/numeric/error.hpp>
#include <floe/response/wave_directions.hpp>
#include <floe/sea_statistics.hpp>

#include <cmath>
#include <numbers>

namespace floe {

// One sea from one mean heading: where its partitions' waves come from and what they did so far
struct SeaStatistics::Sum {
  std::size_t sea;
  double mean_heading_deg;
  std::vector<response::WaveDirections> origins;  // one a partition
  MatXd coherence_factor;                         // zones × terms (E.24); empty without zones
  std::size_t first_zone;                         // in SeaTransfer::zone_states
  response::PseudoExcitation response;
  double waves = 0.0;  // ∫ S dω as the frequencies sum it up

  MatXcd pseudo(const wave::SeaState& state, const SeaTransfer& transfer) const;
};

SeaStatistics::SeaStatistics(const std::vector<wave::SeaState>& seas, SeaObservation observation,
                             std::vector<double> omega, int headings)
    : seas_(seas),
      observation_(std::move(observation)),
      omega_(std::move(omega)),
      weight_(response::trapezoid_weights(omega_)) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  std::size_t zones = 0;
  for (std::size_t s = 0; s < seas_.size(); ++s) {
    const wave::SeaState& sea = seas_[s];
    for (const double mean : sea.mean_heading_deg) {
      Sum sum{s, mean, {}, {}, zones, response::PseudoExcitation(observation_.points)};
      for (const wave::Partition& partition : sea.partitions)
        sum.origins.emplace_back(partition, kDegree * mean, headings);
      if (sea.zones) sum.coherence_factor = wave::coherence_factor(sea.zones->coherence);
      sums_.push_back(std::move(sum));
    }
    if (sea.zones) zones += sea.partitions.size();
  }
}

SeaStatistics::~SeaStatistics() = default;

// All pseudo-responses of one frequency side by side: partitions know nothing of each other, the
// terms of zones are ∑_z L_zr √(S_z D Δθ) ξ_z (E.24)
MatXcd SeaStatistics::Sum::pseudo(const wave::SeaState& state, const SeaTransfer& transfer) const {
  std::vector<MatXcd> parts;
  Index columns = 0;
  for (std::size_t p = 0; p < origins.size(); ++p) {
    const MatXcd& circle = state.zones ? transfer.zone_states.at(first_zone + p) : transfer.state;
    parts.push_back(origins[p].pseudo(transfer.omega, circle));
    columns += parts.back().cols();
  }
  const Index rows = transfer.state.rows();
  if (state.zones) {
    const Index each = parts.front().cols(), terms = coherence_factor.cols();
    MatXcd all = MatXcd::Zero(rows, each * terms);
    for (Index r = 0; r < terms; ++r)
      for (std::size_t z = 0; z < parts.size(); ++z)
        all.middleCols(r * each, each) += coherence_factor(static_cast<Index>(z), r) * parts[z];
    return all;
  }
  MatXcd all(rows, columns);
  Index first = 0;
  for (const MatXcd& part : parts) {
    all.middleCols(first, part.cols()) = part;
    first += part.cols();
  }
  return all;
}

void SeaStatistics::add(const SeaTransfer& transfer) {
  for (Sum& sum : sums_) {
    const std::size_t i = sum.response.omega().size();
    FLOE_VALIDATE(
        i < omega_.size() && transfer.omega == omega_[i],
        "invalid frequency = " << transfer.omega << " rad/s (must be that of place " << i << ")");
    sum.response.add(transfer.omega, weight_[i], sum.pseudo(seas_[sum.sea], transfer));
    for (const response::WaveDirections& origin : sum.origins)
      sum.waves += weight_[i] * origin.energy(transfer.omega);
  }
}

std::vector<SeaResult> SeaStatistics::results() const {
  std::vector<SeaResult> results;
  for (const Sum& sum : sums_) results.push_back(result_of(sum));
  return results;
}

// Spectra and moments at the points, by quantity
void SeaStatistics::add_spectra(const MatXd& spectra, SeaResult& result) const {
  const auto count = static_cast<Index>(observation_.quantity.size());
  const Index points = count > 0 ? observation_.points.rows() / count : 0;
  const auto frequencies = static_cast<Index>(omega_.size());
  const Eigen::Map<const Eigen::ArrayXd> omega(omega_.data(), frequencies),
      weight(weight_.data(), frequencies);
  for (Index q = 0; q < count; ++q) {
    const int derivative = observation_.derivative[static_cast<std::size_t>(q)];
    MatXd own =
        spectra.middleRows(q * points, points) * omega.pow(2 * derivative).matrix().asDiagonal();
    MatXd moments(points, 4);
    for (Index m = 0; m < 4; ++m)
      moments.col(m) = own * (omega.pow(response::PseudoExcitation::kOrders[m]) * weight).matrix();
    if (q == 0) result.grid_error = grid_error(own.colwise().sum(), moments.col(0).sum());
    result.spectra.push_back(std::move(own));
    result.moments.push_back(std::move(moments));
  }
}

// Relative difference of an integral over ω to that over every other frequency, both ends among
// them
double SeaStatistics::grid_error(const VecXd& spectrum, double integral) const {
  if (omega_.size() % 2 == 0 || !(integral > 0.0)) return 0.0;
  std::vector<double> omega;
  for (std::size_t i = 0; i < omega_.size(); i += 2) omega.push_back(omega_[i]);
  const std::vector<double> weight = response::trapezoid_weights(omega);
  double coarse = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i)
    coarse += weight[i] * spectrum[static_cast<Index>(2 * i)];
  return std::abs(coarse - integral) / integral;
}

SeaResult SeaStatistics::result_of(const Sum& sum) const {
  FLOE_VALIDATE(sum.response.omega().size() == omega_.size(),
                "invalid count of transfer functions = " << sum.response.omega().size()
                                                         << " (must be " << omega_.size() << ")");
  const wave::SeaState& sea = seas_[sum.sea];
  SeaResult result;
  result.sea = sea.name;
  result.mean_heading_deg = sum.mean_heading_deg;
  result.omega = omega_;
  result.quantity = observation_.quantity;
  result.duration = sea.duration;
  result.significant_height = 4.0 * std::sqrt(sea.m0());
  result.share_outside = 1.0 - sea.variance(omega_.front(), omega_.back()) / sea.m0();
  const double means = sea.zones ? static_cast<double>(sum.origins.size()) : 1.0;
  result.band_height = 4.0 * std::sqrt(sum.waves / means);
  for (const response::WaveDirections& origin : sum.origins)
    if (std::abs(origin.spreading_sum() - 1.0) > std::abs(result.spreading_sum - 1.0))
      result.spreading_sum = origin.spreading_sum();

  add_spectra(sum.response.spectra(), result);

  // Deflection along lines and everywhere, from the covariances of the modes
  const Index modes = observation_.nodes.cols();
  const auto deviation = [&](const MatXd& shape, int order) {
    return response::standard_deviation(
        shape, sum.response.modal_covariance(order).topLeftCorner(modes, modes));
  };
  result.line_deviation = deviation(observation_.lines, 0);
  result.node_moments.resize(observation_.nodes.rows(), 4);
  for (Index m = 0; m < 4; ++m)
    result.node_moments.col(m) =
        deviation(observation_.nodes, response::PseudoExcitation::kOrders[m]).cwiseAbs2();
  return result;
}

}  // namespace floe
