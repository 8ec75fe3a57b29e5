#include <floe/numeric/error.hpp>
#include <floe/wave/zones.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace floe::wave {
namespace {

// Less of all zones at a point, and it lies in none: a corner where one zone ends has a quarter
constexpr double kCovered = 0.2;

// 0 to 1 over the width around an edge, with two continuous derivatives; s(t) + s(-t) = 1
double smooth_step(double distance, double width) {
  const double t = std::clamp(distance / width + 0.5, 0.0, 1.0);
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

double within(const ZoneBounds& bounds, double width, double x, double y) {
  return smooth_step(x - bounds.x_from, width) * smooth_step(bounds.x_to - x, width) *
         smooth_step(y - bounds.y_from, width) * smooth_step(bounds.y_to - y, width);
}

}  // namespace

MatXd uniform_coherence(Index count, double c) {
  return (1.0 - c) * MatXd::Identity(count, count) + c * MatXd::Ones(count, count);
}

MatXd coherence_factor(const MatXd& coherence) {
  FLOE_VALIDATE(coherence.rows() == coherence.cols() && coherence.rows() > 0 &&
                    coherence.allFinite() && coherence == coherence.transpose() &&
                    (coherence.diagonal().array() == 1.0).all() && coherence.minCoeff() >= 0.0 &&
                    coherence.maxCoeff() <= 1.0,
                "invalid coherence (must be symmetric, 1 on the diagonal and 0 to 1 elsewhere)");
  const Eigen::SelfAdjointEigenSolver<MatXd> eigen(coherence);
  const VecXd& value = eigen.eigenvalues();  // ascending
  const double largest = value[value.size() - 1];
  FLOE_VALIDATE(value[0] >= -1e-10 * largest,
                "invalid coherence with the eigenvalue "
                    << value[0] << " (must have none below 0: no three seas can be related so)");
  const Index terms = (value.array() > 1e-12 * largest).count();
  return eigen.eigenvectors().rightCols(terms) * value.tail(terms).cwiseSqrt().asDiagonal();
}

MatXd zone_amplitudes(const Zones& zones, const Points2& points) {
  const auto count = static_cast<Index>(zones.bounds.size());
  FLOE_VALIDATE(count > 0 && zones.coherence.rows() == count && zones.transition > 0.0,
                "invalid zones: " << count << " with a transition of " << zones.transition
                                  << " m (must be positive, with a coherence for each pair)");
  MatXd amplitude(points.cols(), count);
  for (Index i = 0; i < points.cols(); ++i) {
    for (Index z = 0; z < count; ++z)
      amplitude(i, z) = within(zones.bounds[static_cast<std::size_t>(z)], zones.transition,
                               points(0, i), points(1, i));
    FLOE_VALIDATE(amplitude.row(i).sum() >= kCovered,
                  "[" << points(0, i) << ", " << points(1, i)
                      << "] m of the plate lies in no zone (zones must cover the plate)");
    const double variance = amplitude.row(i) * zones.coherence * amplitude.row(i).transpose();
    amplitude.row(i) /= std::sqrt(variance);
  }
  return amplitude;
}

}  // namespace floe::wave
