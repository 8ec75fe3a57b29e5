#include "plate/shifted_factor.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/plate_compliance.hpp>

#include <cmath>

namespace floe::plate {
namespace {

// Matrix on the deflections as one on all unknowns; zeros are kept so that the three unknowns of a
// node have the same neighbours
SparseMatrix on_all_unknowns(const SparseMatrix& deflections) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  entries.reserve(9 * static_cast<std::size_t>(deflections.nonZeros()));
  for (Index column = 0; column < deflections.cols(); ++column)
    for (SparseMatrix::InnerIterator it(deflections, column); it; ++it)
      for (int a = 0; a < kUnknownsPerNode; ++a)
        for (int b = 0; b < kUnknownsPerNode; ++b)
          entries.emplace_back(kUnknownsPerNode * it.row() + a, kUnknownsPerNode * column + b,
                               a + b == 0 ? it.value() : 0.0);
  SparseMatrix all(kUnknownsPerNode * deflections.rows(), kUnknownsPerNode * deflections.cols());
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

}  // namespace

PlateCompliance::PlateCompliance(const PlateMatrices& plate, double loss_factor, double omega,
                                 const SparseMatrix& foundation)
    : loss_factor_(loss_factor) {
  FLOE_VALIDATE(loss_factor >= 0.0 && loss_factor <= 0.5,
                "invalid plate.loss_factor = " << loss_factor << " (must be 0 to 0.5)");
  PlateMatrices dynamic;
  dynamic.stiffness = plate.stiffness - omega * omega * plate.mass;
  dynamic.stiffness += on_all_unknowns(foundation);
  dynamic.mass.resize(dynamic.stiffness.rows(), dynamic.stiffness.cols());
  factor_ = std::make_shared<const ShiftedFactor>(dynamic, 1.0);
  if (loss_factor > 0.0) stiffness_ = plate.stiffness;
}

MatXcd PlateCompliance::displacement(const Eigen::Ref<const MatXcd>& load) const {
  FLOE_EXPECT(kUnknownsPerNode * load.rows() == factor_->size());
  MatXcd force = MatXcd::Zero(factor_->size(), load.cols());
  for (Index node = 0; node < load.rows(); ++node)
    force.row(kUnknownsPerNode * node) = load.row(node);
  MatXcd displacement = factor_->solve(force);
  if (loss_factor_ == 0.0) return displacement;

  // The loss by its Neumann series: d = F⁻¹ (f + iη K d), a contraction by η
  const int terms = static_cast<int>(std::ceil(std::log(1e-12) / std::log(loss_factor_)));
  MatXcd term = displacement;
  for (int i = 0; i < terms; ++i) {
    const MatXcd lost = Complex(0.0, loss_factor_) * (stiffness_.cast<Complex>() * term);
    term = factor_->solve(lost);
    displacement += term;
  }
  return displacement;
}

Index PlateCompliance::entry_count() const { return factor_->entry_count(); }

}  // namespace floe::plate
