#include "io/atomic_file.hpp"
#include "io/body_results.hpp"

#include <floe/io/interchange.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace floe::io {
namespace {

enum class Motion { kTranslation, kRotation, kElastic };

// What WAMIT divides by: powers of the length L. Elastic modes have none
class Normalisation {
 public:
  Normalisation(const StoredRun& run, const BodyResults& results, double length)
      : length_(length),
        density_(run.data().water.density),
        weight_(run.data().water.density * run.data().water.gravity) {
    for (const plate::BodyDof& dof : results.dofs.dof)
      motion_.push_back(dof.rigid == 0  ? Motion::kElastic
                        : dof.rigid > 3 ? Motion::kRotation
                                        : Motion::kTranslation);
  }
  double mass(Index i, Index j) const { return density_ * pair_power(3, i, j); }
  double stiffness(Index i, Index j) const { return weight_ * pair_power(2, i, j); }
  double force(Index i) const { return weight_ * power(2 + is(Motion::kRotation, i), i); }
  double response(Index i) const { return power(-is(Motion::kRotation, i), i); }

 private:
  int is(Motion motion, Index i) const {
    return motion_[static_cast<std::size_t>(i)] == motion ? 1 : 0;
  }
  double power(int exponent, Index i) const {
    return is(Motion::kElastic, i) ? 1.0 : std::pow(length_, exponent);
  }
  double pair_power(int least, Index i, Index j) const {
    if (is(Motion::kElastic, i) || is(Motion::kElastic, j)) return 1.0;
    return std::pow(length_, least + is(Motion::kRotation, i) + is(Motion::kRotation, j));
  }

  double length_, density_, weight_;
  std::vector<Motion> motion_;
};

// NOTE: adding zero turns -0 into 0
std::string number(double value) { return fmt::format("{:17.9E}", value + 0.0); }

std::string header(const std::string& columns, const StoredRun& run, const BodyResults& results,
                   double length) {
  std::string text = fmt::format(
      "# floe {}: {}; L = {} m, rho = {} kg/m3, g = {} m/s2, depth = {} m; exp(+i omega t), "
      "phases relative to the wave at the origin, BETA: direction of travel from +x towards +y; "
      "rotations about the centre of mass of each body",
      FLOE_VERSION, columns, length, run.data().water.density, run.data().water.gravity,
      run.data().water.depth);
  for (std::size_t b = 0; b < results.dofs.body.size(); ++b) {
    const Point2 centre = results.dofs.centre.col(static_cast<Index>(b));
    text += fmt::format("; {} at ({}, {}, 0)", results.dofs.body[b], centre.x(), centre.y());
  }
  const std::vector<std::string> names = results.dof_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (results.dofs.dof[i].rigid == 0)
      text += fmt::format("{}{} = {}",
                          i > 0 && results.dofs.dof[i - 1].rigid == 0
                              ? ", "
                              : "; dry modes of unit modal mass [kg], no power of L: ",
                          i + 1, names[i]);
  return text + "\n";
}

// Longest waves last
std::vector<const BodyFrequency*> by_period(const BodyResults& results) {
  std::vector<const BodyFrequency*> sorted;
  for (const BodyFrequency& frequency : results.frequencies) sorted.push_back(&frequency);
  std::reverse(sorted.begin(), sorted.end());
  return sorted;
}

std::string coefficients(const BodyResults& results, const Normalisation& unit) {
  std::string text;
  for (const BodyFrequency* frequency : by_period(results)) {
    const double period = 2.0 * std::numbers::pi / frequency->omega;
    for (Index i = 0; i < results.dofs.count(); ++i)
      for (Index j = 0; j < results.dofs.count(); ++j)
        text +=
            fmt::format("{} {:5} {:5} {} {}\n", number(period), i + 1, j + 1,
                        number(frequency->added_mass(i, j) / unit.mass(i, j)),
                        number(frequency->damping(i, j) / (frequency->omega * unit.mass(i, j))));
  }
  return text;
}

std::string stiffnesses(const BodyResults& results, const Normalisation& unit) {
  std::string text;
  for (Index i = 0; i < results.dofs.count(); ++i)
    for (Index j = 0; j < results.dofs.count(); ++j)
      text += fmt::format("{:5} {:5} {}\n", i + 1, j + 1,
                          number(results.hydrostatic_stiffness(i, j) / unit.stiffness(i, j)));
  return text;
}

// Complex numbers of the other sign of time: conjugates
std::string amplitudes(const BodyResults& results,
                       const std::function<MatXcd(const BodyFrequency&)>& values,
                       const std::function<double(Index)>& unit) {
  std::string text;
  for (const BodyFrequency* frequency : by_period(results)) {
    const double period = 2.0 * std::numbers::pi / frequency->omega;
    const MatXcd value = values(*frequency);
    for (Index b = 0; b < value.cols(); ++b)
      for (Index i = 0; i < value.rows(); ++i) {
        const Complex z = std::conj(value(i, b)) / unit(i);
        const double phase = z == Complex(0.0) ? 0.0 : std::arg(z) * 180.0 / std::numbers::pi;
        text += fmt::format("{} {} {:5} {} {} {} {}\n", number(period),
                            number(results.heading_deg[static_cast<std::size_t>(b)]), i + 1,
                            number(std::abs(z)), number(phase), number(z.real()), number(z.imag()));
      }
  }
  return text;
}

}  // namespace

std::vector<std::filesystem::path> write_wamit(const StoredRun& run,
                                               const std::filesystem::path& stem,
                                               plate::DofSet dofs, double length) {
  FLOE_VALIDATE(length > 0.0 && std::isfinite(length),
                "invalid length = " << length << " m (must be positive)");
  FLOE_VALIDATE(dofs != plate::DofSet::kPlate,
                "invalid degrees of freedom (must begin with all six rigid motions)");
  const BodyResults results = body_results(run, dofs);
  const Normalisation unit(run, results, length);

  std::vector<std::filesystem::path> files;
  const auto write = [&](const std::string& suffix, const std::string& columns,
                         const std::string& rows) {
    files.emplace_back(stem.string() + suffix);
    write_file(files.back(), header(columns, run, results, length) + rows);
  };
  const auto force = [&](Index i) { return unit.force(i); };
  const std::string force_columns = "PER[s] BETA[deg] I Mod Pha[deg] Re Im of F/(rho g A L^m)";
  write(".1", "PER[s] I J A/(rho L^k) B/(rho omega L^k)", coefficients(results, unit));
  write(
      ".3", force_columns + ", exciting force",
      amplitudes(
          results, [](const BodyFrequency& f) -> MatXcd { return f.froude_krylov + f.diffraction; },
          force));
  write(".3fk", force_columns + ", Froude-Krylov force",
        amplitudes(
            results, [](const BodyFrequency& f) { return f.froude_krylov; }, force));
  write(".3sc", force_columns + ", diffraction force",
        amplitudes(
            results, [](const BodyFrequency& f) { return f.diffraction; }, force));
  write(".4", "PER[s] BETA[deg] I Mod Pha[deg] Re Im of X L^n/A, motions of the elastic plate",
        amplitudes(
            results, [](const BodyFrequency& f) { return f.response; },
            [&](Index i) { return unit.response(i); }));
  write(".hst", "I J C/(rho g L^k)", stiffnesses(results, unit));
  return files;
}

}  // namespace floe::io
