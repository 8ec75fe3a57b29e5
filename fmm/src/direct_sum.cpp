#include <floe/fmm/direct_sum.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace floe::fmm {
namespace {

constexpr Index kBlock = 512;  // sources evaluated at once

}  // namespace

DirectSum::DirectSum(Points2 sources, Points2 targets, const RadialKernel& kernel)
    : sources_(std::move(sources)), targets_(std::move(targets)), kernel_(kernel) {
  FLOE_VALIDATE(sources_.allFinite() && targets_.allFinite(),
                "invalid point coordinate = nan or inf (must be finite)");
}

Eigen::RowVectorXcd DirectSum::potential_at(Index target,
                                            const Eigen::Ref<const MatXcd>& charges) const {
  Eigen::RowVectorXcd potential = Eigen::RowVectorXcd::Zero(charges.cols());
  std::vector<double> distance(kBlock);
  std::vector<Complex> value(kBlock);
  for (Index first = 0; first < sources_.cols(); first += kBlock) {
    const Index count = std::min(kBlock, sources_.cols() - first);
    for (Index j = 0; j < count; ++j)
      distance[j] = (sources_.col(first + j) - targets_.col(target)).norm();

    // Leave out coincident points: any distance will do for them, their value is dropped
    std::vector<Index> coincident;
    for (Index j = 0; j < count; ++j)
      if (distance[j] == 0.0) {
        coincident.push_back(j);
        distance[j] = 1.0;
      }
    kernel_.evaluate({distance.data(), static_cast<std::size_t>(count)},
                     {value.data(), static_cast<std::size_t>(count)});
    for (const Index j : coincident) value[j] = 0.0;
    for (Index column = 0; column < charges.cols(); ++column) {
      Complex sum = 0.0;
      for (Index j = 0; j < count; ++j) sum += value[j] * charges(first + j, column);
      potential[column] += sum;
    }
  }
  return potential;
}

void DirectSum::apply(const Eigen::Ref<const MatXcd>& charges,
                      Eigen::Ref<MatXcd> potentials) const {
  FLOE_EXPECT(charges.rows() == source_count() && potentials.rows() == target_count());
#pragma omp parallel for schedule(dynamic, 16)
  for (Index i = 0; i < targets_.cols(); ++i) potentials.row(i) = potential_at(i, charges);
}

void DirectSum::far_apply(const Eigen::Ref<const MatXcd>& charges,
                          Eigen::Ref<MatXcd> potentials) const {
  apply(charges, potentials);
}

std::vector<Index> DirectSum::near_sources(Index target) const {
  std::vector<Index> coincident;
  for (Index j = 0; j < sources_.cols(); ++j)
    if (sources_.col(j) == targets_.col(target)) coincident.push_back(j);
  return coincident;
}

void DirectSum::far_values(Index, std::span<const Index>, std::span<Complex> values) const {
  std::fill(values.begin(), values.end(), Complex(0.0, 0.0));
}

double DirectSum::memory() const {
  return static_cast<double>(sizeof(double)) * 2.0 *
         static_cast<double>(sources_.cols() + targets_.cols());
}

}  // namespace floe::fmm
