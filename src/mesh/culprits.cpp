#include "mesh/culprits.hpp"

#include <floe/numeric/error.hpp>

namespace floe::mesh {

void Culprits::throw_if_any(const std::string& what, const std::string& required,
                            bool stopped_when_full) const {
  if (count_ == 0) return;
  std::ostringstream text;
  text << "invalid mesh: " << what << " = " << (stopped_when_full && full() ? "at least " : "")
       << count_ << " (" << required << "): ";
  for (std::size_t i = 0; i < names_.size(); ++i) text << (i == 0 ? "" : "; ") << names_[i];
  const Index unnamed = count_ - static_cast<Index>(names_.size());
  if (unnamed > 0) text << "; and " << unnamed << " more";
  throw MeshError(text.str());
}

std::string at(const Point2& point) {
  std::ostringstream text;
  text.precision(10);
  text << "(" << point.x() << ", " << point.y() << ") m";
  return text.str();
}

}  // namespace floe::mesh
