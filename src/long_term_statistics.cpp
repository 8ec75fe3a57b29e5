#include <floe/long_term_statistics.hpp>
#include <floe/numeric/error.hpp>
#include <floe/response/pseudo_excitation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe {

// One climate: where its waves come from, and what a metre of each period did so far
struct LongTermStatistics::Sum {
  struct Origin {
    response::DirectionGrid grid;
    response::CircleInterpolation at_headings;
  };
  wave::WaveClimate climate;
  std::vector<wave::Spectrum> spectra;  // one a period
  std::vector<Origin> origins;          // one a mean heading
  VecXd waves;                          // ∫ S dω of each period
  MatXd m0, m2;                         // observed × (headings · periods)
};

double LongTermResult::energy_outside() const {
  double outside = 0.0, all = 0.0;
  for (std::size_t j = 0; j < share_outside.size(); ++j) {
    outside += share_outside[j] * climate.energy(j);
    all += climate.energy(j);
  }
  return outside / all;
}

namespace {

// Every class that occurs from every heading; visit(class, column of the moments)
template <typename Visit>
void each_class(const wave::WaveClimate& climate, Visit visit) {
  const wave::ScatterDiagram& scatter = climate.scatter;
  const std::size_t periods = scatter.period.size();
  for (std::size_t h = 0; h < climate.mean_heading_deg.size(); ++h)
    for (std::size_t j = 0; j < periods; ++j)
      for (std::size_t i = 0; i < scatter.height.size(); ++i) {
        const double probability =
            climate.heading_probability[h] *
            scatter.probability(static_cast<Index>(i), static_cast<Index>(j));
        if (probability > 0.0)
          visit(SeaClass{scatter.height[i], scatter.period[j], climate.mean_heading_deg[h],
                         probability},
                static_cast<Index>(h * periods + j));
      }
}

}  // namespace

response::LongTermDistribution LongTermResult::distribution(std::size_t place, Index point) const {
  std::vector<response::ShortTermResponse> states;
  each_class(climate, [&](const SeaClass& sea, Index column) {
    const double square = sea.height * sea.height;
    states.push_back(
        {sea.share, square * m0[place](point, column), square * m2[place](point, column)});
  });
  return response::LongTermDistribution(states);
}

SeaClass LongTermResult::worst_class(std::size_t place, Index point, double level) const {
  const std::vector<double> shares = distribution(place, point).contributions(level);
  SeaClass worst;
  std::size_t next = 0;
  each_class(climate, [&](SeaClass sea, Index) {
    sea.share = shares[next++];
    if (sea.share > worst.share) worst = sea;
  });
  return worst;
}

LongTermStatistics::LongTermStatistics(std::vector<wave::WaveClimate> climates,
                                       SeaObservation observation, std::vector<double> omega,
                                       int headings)
    : observation_(std::move(observation)),
      omega_(std::move(omega)),
      weight_(response::trapezoid_weights(omega_)) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (wave::WaveClimate& climate : climates) {
    Sum sum{std::move(climate), {}, {}, {}, {}, {}};
    const std::size_t periods = sum.climate.scatter.period.size();
    for (std::size_t j = 0; j < periods; ++j) sum.spectra.push_back(sum.climate.spectrum(j));
    for (const double mean : sum.climate.mean_heading_deg) {
      response::DirectionGrid grid =
          response::direction_grid(sum.climate.spreading, kDegree * mean, headings);
      response::CircleInterpolation at_headings(grid.heading, headings);
      sum.origins.push_back({std::move(grid), std::move(at_headings)});
    }
    sum.waves = VecXd::Zero(static_cast<Index>(periods));
    sum.m0 =
        MatXd::Zero(observation_.points.rows(), static_cast<Index>(sum.origins.size() * periods));
    sum.m2 = sum.m0;
    sums_.push_back(std::move(sum));
  }
}

LongTermStatistics::~LongTermStatistics() = default;

void LongTermStatistics::add(const SeaTransfer& transfer) {
  FLOE_VALIDATE(added_ < omega_.size() && transfer.omega == omega_[added_],
                "invalid frequency = " << transfer.omega << " rad/s (must be that of place "
                                       << added_ << ")");
  const double omega = transfer.omega, weight = weight_[added_++];

  // What is observed of every wave, with its derivatives in time
  MatXcd seen = observation_.points.cast<Complex>() * transfer.state;
  const auto count = static_cast<Index>(observation_.quantity.size());
  const Index points = count > 0 ? seen.rows() / count : 0;
  for (Index q = 0; q < count; ++q)
    seen.middleRows(q * points, points) *=
        std::pow(omega, observation_.derivative[static_cast<std::size_t>(q)]);

  for (Sum& sum : sums_) {
    // Spectra of the waves of 1 m, one a period
    const auto periods = static_cast<Index>(sum.spectra.size());
    VecXd energy(periods);
    for (Index j = 0; j < periods; ++j)
      energy[j] = weight * sum.spectra[static_cast<std::size_t>(j)](omega);
    sum.waves += energy;

    // ∑ |y|² D Δθ from each mean heading (E.8), which all periods share
    for (std::size_t h = 0; h < sum.origins.size(); ++h) {
      const auto& [grid, at_headings] = sum.origins[h];
      const Eigen::Map<const VecXd> share(grid.weight.data(),
                                          static_cast<Index>(grid.weight.size()));
      const VecXd gain = at_headings(seen).cwiseAbs2() * share;
      const Index first = static_cast<Index>(h) * periods;
      sum.m0.middleCols(first, periods) += gain * energy.transpose();
      sum.m2.middleCols(first, periods) += omega * omega * gain * energy.transpose();
    }
  }
}

std::vector<LongTermResult> LongTermStatistics::results() const {
  FLOE_VALIDATE(added_ == omega_.size(), "invalid count of transfer functions = "
                                             << added_ << " (must be " << omega_.size() << ")");
  const auto count = static_cast<Index>(observation_.quantity.size());
  const Index points = count > 0 ? observation_.points.rows() / count : 0;
  std::vector<LongTermResult> results;
  for (const Sum& sum : sums_) {
    LongTermResult result{sum.climate, observation_.quantity, {}, {}, {}, 0.0};
    for (Index q = 0; q < count; ++q) {
      result.m0.push_back(sum.m0.middleRows(q * points, points));
      result.m2.push_back(sum.m2.middleRows(q * points, points));
    }
    for (std::size_t j = 0; j < sum.spectra.size(); ++j) {
      const double all = sum.spectra[j].m0();
      const double within = sum.spectra[j].variance(omega_.front(), omega_.back());
      result.share_outside.push_back(1.0 - within / all);
      if (!(sum.climate.energy(j) > 0.0)) continue;  // no such waves
      result.grid_error =
          std::max(result.grid_error, std::abs(sum.waves[static_cast<Index>(j)] - within) / all);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace floe
