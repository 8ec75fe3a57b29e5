#include <floe/io/case_file.hpp>
#include <floe/numeric/types.hpp>

#include <algorithm>

namespace floe::io {
namespace {

// Edit distance with swaps of neighbours (optimal string alignment)
int edit_distance(const std::string& a, const std::string& b) {
  const Index rows = static_cast<Index>(a.size()), columns = static_cast<Index>(b.size());
  Eigen::MatrixXi cost(rows + 1, columns + 1);
  for (Index i = 0; i <= rows; ++i) cost(i, 0) = static_cast<int>(i);
  for (Index j = 0; j <= columns; ++j) cost(0, j) = static_cast<int>(j);
  for (Index i = 1; i <= rows; ++i)
    for (Index j = 1; j <= columns; ++j) {
      const int replace = cost(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost(i, j) = std::min({replace, cost(i - 1, j) + 1, cost(i, j - 1) + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost(i, j) = std::min(cost(i, j), cost(i - 2, j - 2) + 1);
    }
  return cost(rows, columns);
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 64;
  if (name.size() > kLongest) return "";
  std::string nearest;
  int least = 0;
  for (const std::string& candidate : known) {
    const int distance = edit_distance(name, candidate);
    const int allowed = std::max<int>(1, static_cast<int>(candidate.size() + 2) / 3);
    if (distance > allowed || (!nearest.empty() && distance >= least)) continue;
    nearest = candidate;
    least = distance;
  }
  return nearest;
}

}  // namespace floe::io
