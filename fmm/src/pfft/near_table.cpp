#include "pfft/near_table.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace floe::fmm::pfft {
namespace {

constexpr int kSamples = 40;    // pairs of positions a pair of cells
constexpr double kPull = 1e-8;  // relative to what far pairs see of a value

// A sequence of points that fills the unit cube of four dimensions evenly
double sample(int number, int dimension) {
  constexpr double kShare[] = {0.8566748838545029, 0.7338918566271260, 0.6287067210378087,
                               0.5385972572236101};
  return std::fmod(0.5 + (number + 1) * kShare[dimension], 1.0);
}

// Offset numbers in one octant: pairs 0 ≤ j ≤ i
int octant(int i, int j) {
  const int a = std::max(std::abs(i), std::abs(j)), b = std::min(std::abs(i), std::abs(j));
  return a * (a + 1) / 2 + b;
}

struct OctantTable {
  std::vector<double> value;  // by octant number
  std::vector<int> unknown;   // number of the free value, or -1
  int unknowns = 0;
};

OctantTable kernel_octant(double spacing, double free_radius, int reach,
                          const RadialKernel& kernel) {
  OctantTable table;
  std::vector<double> distance;
  for (int i = 0; i <= reach; ++i)
    for (int j = 0; j <= i; ++j) {
      distance.push_back(spacing * std::max(0.5 * free_radius, std::hypot(i, j)));
      table.unknown.push_back(std::hypot(i, j) < free_radius ? table.unknowns++ : -1);
    }
  std::vector<Complex> value(distance.size());
  kernel.evaluate(distance, value);
  for (const Complex& v : value) table.value.push_back(v.real());
  return table;
}

// Weight of each offset along one axis, for stencils at cells `shift` apart:
// product[u + stencil - 1] belongs to offset shift + u
void correlate(int w, double target, double source, double* product) {
  const double first = 0.5 * w - 1.0;  // of the positions within a stencil
  std::vector<double> at_target(static_cast<std::size_t>(w)), at_source(at_target);
  stencil_weights(first + target, w, at_target.data());
  stencil_weights(first + source, w, at_source.data());
  std::fill_n(product, 2 * w - 1, 0.0);
  for (int a = 0; a < w; ++a)
    for (int b = 0; b < w; ++b)
      product[b - a + w - 1] +=
          at_target[static_cast<std::size_t>(a)] * at_source[static_cast<std::size_t>(b)];
}

}  // namespace

void fit_near_table(const Grid& grid, const NearShape& near, const RadialKernel& kernel,
                    std::vector<Complex>& table) {
  const int w = grid.stencil, reach = fitted_reach(w, near.radius);
  const double free_radius = near.radius + 0.5;
  OctantTable octant_table = kernel_octant(grid.spacing, free_radius, reach + w, kernel);

  // One equation a sampled pair: the grid's value with free table values = the kernel
  std::vector<std::pair<int, int>> cells;
  for (int dx = 0; dx <= reach; ++dx)
    for (int dy = 0; dy <= dx; ++dy)
      if (dy > near.radius || dx > near.half_width[static_cast<std::size_t>(dy)])
        cells.emplace_back(dx, dy);
  const auto rows = static_cast<Index>(cells.size()) * kSamples;
  MatXd matrix = MatXd::Zero(rows + octant_table.unknowns, octant_table.unknowns);
  VecXd right(rows + octant_table.unknowns);
  std::vector<double> along_x(static_cast<std::size_t>(2 * w - 1)), along_y(along_x), distance(1);
  std::vector<Complex> value(1);
  for (Index row = 0; row < rows; ++row) {
    const auto& [dx, dy] = cells[static_cast<std::size_t>(row / kSamples)];
    const int s = static_cast<int>(row);
    const double tx = sample(s, 0), ty = sample(s, 1), sx = sample(s, 2), sy = sample(s, 3);
    correlate(w, tx, sx, along_x.data());
    correlate(w, ty, sy, along_y.data());
    distance[0] = grid.spacing * std::hypot(dx + sx - tx, dy + sy - ty);
    kernel.evaluate(distance, value);
    right[row] = value[0].real();
    for (int v = 0; v < 2 * w - 1; ++v)
      for (int u = 0; u < 2 * w - 1; ++u) {
        const auto k = static_cast<std::size_t>(octant(dx + u - w + 1, dy + v - w + 1));
        const double factor =
            along_x[static_cast<std::size_t>(u)] * along_y[static_cast<std::size_t>(v)];
        if (octant_table.unknown[k] >= 0)
          matrix(row, octant_table.unknown[k]) += factor;
        else
          right[row] -= factor * octant_table.value[k];
      }
  }

  // NOTE: values that far pairs hardly see could become anything, and near values would lose digits
  // in cancellation; so they are pulled softly towards the kernel at half the near radius or beyond
  const double pull = kPull * std::sqrt(static_cast<double>(rows));
  for (std::size_t k = 0; k < octant_table.unknown.size(); ++k) {
    const Index free = octant_table.unknown[k];
    if (free < 0) continue;
    matrix(rows + free, free) = pull;
    right[rows + free] = pull * octant_table.value[k];
  }
  const Eigen::HouseholderQR<MatXd> factors(matrix);
  const VecXd real = factors.solve(right);

  for (Index j = 0; j < std::min<Index>(grid.ny, near.radius + 2); ++j)
    for (Index i = 0; i < std::min<Index>(grid.nx, near.radius + 2); ++i) {
      const int free =
          octant_table
              .unknown[static_cast<std::size_t>(octant(static_cast<int>(i), static_cast<int>(j)))];
      if (free >= 0) table[static_cast<std::size_t>(i + grid.nx * j)].real(real[free]);
    }
}

}  // namespace floe::fmm::pfft
