#pragma once

#include <floe/numeric/types.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace floe::mesh {

/// The nodes or elements that break one rule: the first ten by name, the others counted.
class Culprits {
 public:
  /// Notes one culprit; the parts are streamed one after the other.
  template <typename... Parts>
  void add(const Parts&... parts) {
    if (++count_ > kNamed) return;
    std::ostringstream text;
    (text << ... << parts);
    names_.push_back(text.str());
  }

  /// Ten are named already: a search whose cost grows with the culprits may stop.
  bool full() const { return count_ >= kNamed; }

  /// Throws MeshError "invalid mesh: `what` = count (`required`): …" if there are any. A search
  /// that stopped when full says "at least".
  void throw_if_any(const std::string& what, const std::string& required,
                    bool stopped_when_full = false) const;

 private:
  static constexpr Index kNamed = 10;
  Index count_ = 0;
  std::vector<std::string> names_;
};

/// "(x, y) m" of a point, as it stands in messages.
std::string at(const Point2& point);

}  // namespace floe::mesh
