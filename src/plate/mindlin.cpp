#include "plate/adjacency.hpp"
#include "plate/assembly.hpp"
#include "plate/element.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace floe::plate {
namespace {

void validate(const PlateProperties& properties) {
  const auto is_positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  FLOE_VALIDATE(is_positive(properties.thickness),
                "invalid plate thickness = " << properties.thickness << " m (must be positive)");
  FLOE_VALIDATE(is_positive(properties.youngs_modulus),
                "invalid plate youngs_modulus = " << properties.youngs_modulus
                                                  << " N/m^2 (must be positive)");
  FLOE_VALIDATE(is_positive(properties.density),
                "invalid plate density = " << properties.density << " kg/m^3 (must be positive)");
  FLOE_VALIDATE(properties.poisson_ratio > -1.0 && properties.poisson_ratio <= 0.5,
                "invalid plate poisson_ratio = " << properties.poisson_ratio
                                                 << " (must be above -1, at most 0.5)");
  FLOE_VALIDATE(
      is_positive(properties.shear_correction),
      "invalid plate shear_correction = " << properties.shear_correction << " (must be positive)");

  // Each number may pass and their product may still be none
  FLOE_VALIDATE(
      std::isnormal(properties.bending_rigidity()) && std::isnormal(properties.surface_mass()),
      "invalid plate bending rigidity = "
          << properties.bending_rigidity() << " N m and mass = " << properties.surface_mass()
          << " kg/m^2 (must be positive and finite: are thickness, stiffness and density "
             "in SI units?)");
}

// Mass per area of w, θx and θy
std::array<double, 3> inertia_of(const PlateProperties& properties) {
  const double rotary = properties.surface_mass() * std::pow(properties.thickness, 2) / 12.0;
  return {properties.surface_mass(), rotary, rotary};
}

// A matrix whose column 3j + c has, for every neighbour i of node j, the rows 3i … 3i + 2
// (`dense_blocks`) or the row 3i + c alone; all zero
SparseMatrix make_pattern(const IndexLists& neighbours, bool dense_blocks) {
  const Index node_count = static_cast<Index>(neighbours.begin.size()) - 1;
  const Index height = dense_blocks ? 3 : 1;
  SparseMatrix matrix(3 * node_count, 3 * node_count);
  const Index entries = 3 * height * neighbours.begin.back();
  matrix.resizeNonZeros(entries);
  matrix.outerIndexPtr()[3 * node_count] = entries;
  std::fill_n(matrix.valuePtr(), entries, 0.0);
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < node_count; ++j) {
    const Index first = neighbours.begin[j], degree = neighbours.begin[j + 1] - first;
    for (Index c = 0; c < 3; ++c) {
      const Index start = height * (3 * first + c * degree);
      matrix.outerIndexPtr()[3 * j + c] = start;
      for (Index k = 0; k < degree; ++k)
        for (Index r = 0; r < height; ++r)
          matrix.innerIndexPtr()[start + height * k + r] =
              3 * neighbours.value[first + k] + (dense_blocks ? r : c);
    }
  }
  return matrix;
}

// Adds one element; `elements` of one colour may be added at the same time
void add_element(const IndexLists& neighbours, const Eigen::Matrix<Index, 8, 1>& node,
                 const ElementMatrix& stiffness, const Eigen::Matrix<double, 8, 8>& products,
                 const std::array<double, 3>& inertia, PlateMatrices& plate) {
  for (int b = 0; b < 8; ++b) {
    const Index first = neighbours.begin[node[b]];
    const Index degree = neighbours.begin[node[b] + 1] - first;
    const auto list = neighbours.value.begin() + first;
    for (int a = 0; a < 8; ++a) {
      const Index k = std::lower_bound(list, list + degree, node[a]) - list;
      for (int c = 0; c < 3; ++c) {
        double* const column = plate.stiffness.valuePtr() + 3 * (3 * first + c * degree + k);
        for (int r = 0; r < 3; ++r) column[r] += stiffness(3 * a + r, 3 * b + c);
        plate.mass.valuePtr()[3 * first + c * degree + k] += inertia[c] * products(a, b);
      }
    }
  }
}

}  // namespace

PlateMatrices assemble(const Points2& nodes, const mesh::Connectivity& elements,
                       const PlateRegions& regions) {
  std::vector<std::array<double, 3>> inertia;
  for (int region = 0; region < regions.count(); ++region) {
    validate(regions[region]);
    inertia.push_back(inertia_of(regions[region]));
  }
  const IndexLists neighbours = neighbours_of_nodes(nodes.cols(), elements);
  const IndexLists colors = color_elements(nodes.cols(), elements);
  PlateMatrices plate{make_pattern(neighbours, true), make_pattern(neighbours, false)};

  for (std::size_t color = 0; color + 1 < colors.begin.size(); ++color) {
#pragma omp parallel for schedule(static)
    for (Index k = colors.begin[color]; k < colors.begin[color + 1]; ++k) {
      const Index element = colors.value[k];
      const Eigen::Matrix<Index, 8, 1> node = elements.col(element);
      ElementNodes points;
      for (int a = 0; a < 8; ++a) points.col(a) = nodes.col(node[a]);
      add_element(neighbours, node, element_stiffness(points, regions.of(element)),
                  element_shape_products(points), inertia[regions.region(element)], plate);
    }
  }
  return plate;
}

PlateMatrices assemble_plate(const mesh::Q8Mesh& mesh, const PlateRegions& regions) {
  return assemble(mesh.nodes(), mesh.elements(), regions);
}

}  // namespace floe::plate
