#include "sea_relations.hpp"

#include <floe/numeric/error.hpp>
#include <floe/sea_statistics.hpp>

#include <cmath>
#include <numbers>

namespace floe {

// One sea from one mean heading: where its partitions' waves come from and what they did so far
struct SeaStatistics::Sum {
  struct Origin {
    response::DirectionGrid grid;
    response::CircleInterpolation at_headings;
  };
  std::size_t sea;
  double mean_heading_deg;
  std::vector<Origin> origins;  // one a partition
  response::PseudoExcitation response;
  RelationSums relations;
};

SeaStatistics::SeaStatistics(const std::vector<wave::SeaState>& seas, SeaObservation observation,
                             std::vector<double> omega, int headings, const SeaRelations& relations)
    : seas_(seas),
      observation_(std::move(observation)),
      omega_(std::move(omega)),
      weight_(response::trapezoid_weights(omega_)) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (std::size_t s = 0; s < seas_.size(); ++s)
    for (const double mean : seas_[s].mean_heading_deg) {
      Sum sum{s,
              mean,
              {},
              response::PseudoExcitation(observation_.points),
              RelationSums(relations, observation_)};
      for (const wave::Partition& partition : seas_[s].partitions) {
        response::DirectionGrid grid = response::direction_grid(
            partition.spreading, kDegree * (mean + partition.turn_deg), headings);
        response::CircleInterpolation at_headings(grid.heading, headings);
        sum.origins.push_back({std::move(grid), std::move(at_headings)});
      }
      sums_.push_back(std::move(sum));
    }
}

SeaStatistics::~SeaStatistics() = default;

void SeaStatistics::add(const SeaTransfer& transfer, const NodeSpectrumSink& sink) {
  for (Sum& sum : sums_) {
    const std::size_t i = sum.response.omega().size();
    FLOE_VALIDATE(
        i < omega_.size() && transfer.omega == omega_[i],
        "invalid frequency = " << transfer.omega << " rad/s (must be that of place " << i << ")");
    MatXcd pseudo(transfer.state.rows(), 0);
    for (std::size_t p = 0; p < sum.origins.size(); ++p) {
      const MatXcd waves = response::pseudo_amplitudes(
          sum.origins[p].at_headings(transfer.state),
          seas_[sum.sea].partitions[p].spectrum(transfer.omega), sum.origins[p].grid.weight);
      pseudo.conservativeResize(Eigen::NoChange, pseudo.cols() + waves.cols());
      pseudo.rightCols(waves.cols()) = waves;
    }
    sum.response.add(transfer.omega, weight_[i], pseudo);
    sum.relations.add(transfer.omega, pseudo);
    if (!sink) continue;
    const MatXcd modes = pseudo.topRows(observation_.nodes.cols());
    sink(static_cast<std::size_t>(&sum - sums_.data()),
         response::standard_deviation(observation_.nodes, modes.conjugate() * modes.transpose())
             .cwiseAbs2());
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

  add_spectra(sum.response.spectra(), result);
  sum.relations.tell(weight_, result);

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
