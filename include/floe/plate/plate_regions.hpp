#pragma once

#include <floe/numeric/types.hpp>
#include <floe/plate/plate_properties.hpp>

#include <vector>

namespace floe::plate {

/// The properties of every element of a plate: one set for all, or one for each of its regions. The
/// shear correction and the loss factor are those of the first set, for all.
class PlateRegions {
 public:
  /// One set for every element. Implicit: a uniform plate is the common one.
  PlateRegions(const PlateProperties& uniform) : properties_{uniform} {}

  /// `of_element[e]` chooses the set of element e. Throws InputError without a set, or where one is
  /// chosen that there is not.
  PlateRegions(std::vector<PlateProperties> properties, std::vector<int> of_element);

  int count() const { return static_cast<int>(properties_.size()); }
  const PlateProperties& operator[](int region) const { return properties_[region]; }
  /// The region of an element, and its properties.
  int region(Index element) const { return of_element_.empty() ? 0 : of_element_[element]; }
  const PlateProperties& of(Index element) const { return properties_[region(element)]; }
  /// The region of every element; empty where all are of one.
  const std::vector<int>& of_element() const { return of_element_; }
  /// How many elements each region has; of a uniform plate, whose number is not known here, 1.
  std::vector<Index> element_counts() const;
  double loss_factor() const { return properties_.front().loss_factor; }

  /// The same for a mesh of these elements alone, in their order.
  PlateRegions at(const std::vector<Index>& elements) const;

 private:
  std::vector<PlateProperties> properties_;
  std::vector<int> of_element_;  // empty: all are of region 0
};

}  // namespace floe::plate
