#pragma once

#include "io/record.hpp"

#include <floe/numeric/error.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

/// Lists and counts as entries of records.
namespace floe::io {

/// A list of numbers as one entry.
template <typename Number>
VecXd as_vector(const std::vector<Number>& values) {
  VecXd vector(static_cast<Index>(values.size()));
  for (Index i = 0; i < vector.size(); ++i)
    vector[i] = static_cast<double>(values[static_cast<std::size_t>(i)]);
  return vector;
}

/// A number that says how many there are. Throws StoreError where it cannot.
template <typename Count>
Count count_of(double value) {
  constexpr double kMost = 1e9;
  FLOE_VALIDATE_AS(StoreError, value >= 0.0 && value <= kMost && value == std::floor(value),
                   "a record holds " << value << " where it says how many there are");
  return static_cast<Count>(value);
}

/// The other way round.
template <typename Number>
std::vector<Number> as_list(const MatXd& values) {
  std::vector<Number> list;
  for (Index i = 0; i < values.size(); ++i) {
    if constexpr (std::is_same_v<Number, double>)
      list.push_back(values(i));
    else
      list.push_back(count_of<Number>(values(i)));
  }
  return list;
}

/// A list of numbers that has its least length from the program. Throws StoreError where it is
/// shorter.
inline std::vector<double> facts_of(const Record& record, const std::string& name,
                                    std::size_t count) {
  std::vector<double> facts = as_list<double>(record.real(name));
  FLOE_VALIDATE_AS(StoreError, facts.size() >= count,
                   "a record holds " << facts.size() << " numbers of its " << name << ", less than "
                                     << count << " (it is of another version of floe)");
  return facts;
}

}  // namespace floe::io
