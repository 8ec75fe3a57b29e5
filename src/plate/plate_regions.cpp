#include <floe/numeric/error.hpp>
#include <floe/plate/plate_regions.hpp>

#include <utility>

namespace floe::plate {

PlateRegions::PlateRegions(std::vector<PlateProperties> properties, std::vector<int> of_element)
    : properties_(std::move(properties)), of_element_(std::move(of_element)) {
  FLOE_VALIDATE(!properties_.empty(), "invalid plate regions = 0 (must be at least 1)");
  for (const int region : of_element_)
    FLOE_VALIDATE(region >= 0 && region < count(),
                  "invalid plate region = " << region << " (must be 0 to " << count() - 1 << ")");
  for (PlateProperties& region : properties_) {
    region.shear_correction = properties_.front().shear_correction;
    region.loss_factor = properties_.front().loss_factor;
  }
}

std::vector<Index> PlateRegions::element_counts() const {
  std::vector<Index> counts(properties_.size(), 0);
  for (const int region : of_element_) ++counts[region];
  if (of_element_.empty()) counts.front() = 1;
  return counts;
}

PlateRegions PlateRegions::at(const std::vector<Index>& elements) const {
  PlateRegions part(*this);
  if (of_element_.empty()) return part;
  part.of_element_.clear();
  for (const Index element : elements) part.of_element_.push_back(of_element_[element]);
  return part;
}

}  // namespace floe::plate
