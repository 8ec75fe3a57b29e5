#include "sea_relations.hpp"

#include <floe/numeric/error.hpp>
#include <floe/response/design_values.hpp>
#include <floe/response/pseudo_excitation.hpp>

#include <algorithm>
#include <cmath>

namespace floe {
namespace {

// yᵀ A y = σx² + σy² - σxσy + 3τ²
MatXd von_mises_form() {
  MatXd form(3, 3);
  form << 1.0, -0.5, 0.0, -0.5, 1.0, 0.0, 0.0, 0.0, 3.0;
  return form;
}

}  // namespace

RelationSums::RelationSums(const SeaRelations& relations, const SeaObservation& observation)
    : relations_(relations) {
  for (const QuantityPair& pair : relations_.pairs)
    pair_.emplace_back(place_of(pair.first, observation), place_of(pair.second, observation));
  for (const Combination& combination : relations_.combinations) {
    term_.emplace_back();
    for (const CombinationTerm& term : combination.terms)
      term_.back().push_back(place_of(term.of, observation));
  }
  spectra_.emplace_back(observation.points(row_, Eigen::all));
}

// The place among quantities_, where it is put if it is new
Index RelationSums::place_of(const PointQuantity& wanted, const SeaObservation& observation) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    if (quantities_[i].point == wanted.point && quantities_[i].quantity == wanted.quantity)
      return static_cast<Index>(i);
  const auto& observed = observation.quantity;
  const auto at = std::find(observed.begin(), observed.end(), wanted.quantity);
  FLOE_VALIDATE(at != observed.end(), "invalid quantity of a relation = number "
                                          << wanted.quantity + 1 << " (must be observed in seas)");
  const Index points = observation.points.rows() / static_cast<Index>(observed.size());
  const auto place = static_cast<std::size_t>(at - observed.begin());
  quantities_.push_back(wanted);
  row_.push_back(static_cast<Index>(place) * points + static_cast<Index>(wanted.point));
  derivative_.push_back(observation.derivative[place]);
  phase_.push_back(observation.phase[place]);
  return static_cast<Index>(quantities_.size()) - 1;
}

void RelationSums::add(double omega, const MatXcd& pseudo) {
  if (relations_.empty()) return;
  VecXcd factor(static_cast<Index>(row_.size()));
  for (std::size_t i = 0; i < row_.size(); ++i)
    factor[static_cast<Index>(i)] =
        std::polar(1.0, phase_[i]) * std::pow(Complex(0.0, -omega), derivative_[i]);
  spectra_.front().add(pseudo, factor);
}

// Cross-spectra of a combination's terms, with their factors
std::vector<MatXcd> RelationSums::of_terms(const Combination& combination,
                                           std::size_t number) const {
  const std::vector<Index>& terms = term_[number];
  VecXd factor(static_cast<Index>(terms.size()));
  for (std::size_t i = 0; i < terms.size(); ++i)
    factor[static_cast<Index>(i)] = combination.terms[i].factor;
  std::vector<MatXcd> spectra;
  for (const MatXcd& all : spectra_.front().spectra())
    spectra.push_back(factor.asDiagonal() * MatXcd(all(terms, terms)) * factor.asDiagonal());
  return spectra;
}

void RelationSums::tell(const std::vector<double>& weight, SeaResult& result) const {
  if (relations_.empty()) return;
  const std::vector<MatXcd>& all = spectra_.front().spectra();
  const auto frequencies = static_cast<Index>(all.size());
  const response::GaussianVector vector = response::gaussian_vector(all, result.omega, weight);
  for (const auto& [a, b] : pair_) {
    PairResult pair{VecXcd(frequencies), vector.covariance(a, b), 0.0};
    for (Index i = 0; i < frequencies; ++i)
      pair.spectrum[i] = all[static_cast<std::size_t>(i)](a, b);
    const double scale = std::sqrt(vector.covariance(a, a) * vector.covariance(b, b));
    if (scale > 0.0) pair.correlation = pair.covariance / scale;
    result.pairs.push_back(std::move(pair));
  }
  for (std::size_t c = 0; c < relations_.combinations.size(); ++c) {
    const Combination& combination = relations_.combinations[c];
    const bool sum = combination.kind == Combination::Kind::kSum;
    const std::vector<MatXcd> terms = of_terms(combination, c);
    const Index count = static_cast<Index>(combination.terms.size());
    const MatXd form = sum ? MatXd::Ones(count, count) : von_mises_form();
    CombinationResult told{VecXd(frequencies), VecXd::Zero(4), 0.0};
    for (Index i = 0; i < frequencies; ++i) {
      const auto at = static_cast<std::size_t>(i);
      told.spectrum[i] = form.cwiseProduct(terms[at].real()).sum();
      for (Index m = 0; m < 4; ++m)
        told.moments[m] += weight[at] * told.spectrum[i] *
                           std::pow(result.omega[at], response::PseudoExcitation::kOrders[m]);
    }
    told.most_probable_maximum =
        sum ? response::design_values(std::max(told.moments[0], 0.0),
                                      std::max(told.moments[2], 0.0), result.duration)
                  .most_probable_maximum
            : response::most_probable_maximum(
                  response::gaussian_vector(terms, result.omega, weight), form, result.duration);
    result.combinations.push_back(std::move(told));
  }
}

}  // namespace floe
