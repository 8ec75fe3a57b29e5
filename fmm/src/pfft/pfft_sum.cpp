#include "pfft/engine.hpp"

#include <floe/fmm/pfft_sum.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <utility>

namespace floe::fmm {

PfftSum::PfftSum(std::shared_ptr<const PfftPlan> plan, const RadialKernel& kernel, Parts parts)
    : plan_(std::move(plan)) {
  const WaveTerm wave = kernel.wave();
  FLOE_VALIDATE(wave.wavenumber <= plan_->options().max_wavenumber * (1.0 + 1e-9),
                "invalid wavenumber = " << wave.wavenumber << " rad/m (the plan allows "
                                        << plan_->options().max_wavenumber << ")");
  const Complex c = wave.coefficient;
  FLOE_VALIDATE(std::abs(c.real()) <= 1e-14 * std::abs(c.imag()),
                "invalid wave coefficient = " << c << " (must be imaginary)");
  engine_ = pfft::make_engine(plan_->geometry(), kernel, parts == Parts::all);
}

PfftSum::~PfftSum() = default;

Index PfftSum::source_count() const { return plan_->geometry().sources.count(); }
Index PfftSum::target_count() const { return plan_->geometry().targets().count(); }
double PfftSum::memory() const { return engine_->memory(); }

void PfftSum::far_apply(const Eigen::Ref<const MatXcd>& charges,
                        Eigen::Ref<MatXcd> potentials) const {
  FLOE_EXPECT(charges.rows() == source_count() && potentials.rows() == target_count());
  engine_->apply(charges, potentials, false);
}

void PfftSum::apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials) const {
  FLOE_EXPECT(charges.rows() == source_count() && potentials.rows() == target_count());
  FLOE_VALIDATE(engine_->has_near(), "invalid pfft sum = far part only (apply needs all)");
  engine_->apply(charges, potentials, true);
}

std::vector<Index> PfftSum::near_sources(Index target) const {
  const pfft::Geometry& geometry = plan_->geometry();
  const Index t = geometry.targets().sorted[target];
  std::vector<Index> sources;
  sources.reserve(static_cast<std::size_t>(2.0 * plan_->design().near_pairs /
                                           static_cast<double>(target_count())));
  pfft::for_near_ranges(geometry.grid, geometry.near, geometry.sources.cell_begin,
                        geometry.targets().cell_x[t], geometry.targets().cell_y[t],
                        [&](Index begin, Index end) {
                          sources.insert(sources.end(), geometry.sources.original.begin() + begin,
                                         geometry.sources.original.begin() + end);
                        });
  std::sort(sources.begin(), sources.end());
  return sources;
}

void PfftSum::far_values(Index target, std::span<const Index> sources,
                         std::span<Complex> values) const {
  engine_->far_values(target, sources, values);
}

}  // namespace floe::fmm
