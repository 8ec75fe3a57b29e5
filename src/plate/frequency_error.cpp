#include "plate/frequency_error.hpp"

#include "plate/nodal_average.hpp"
#include "plate/piece_modes.hpp"
#include "plate/recovery.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace floe::plate {
namespace {

// A bending wave of wavenumber k on square elements of side h is too fast by (kh)⁴ times this:
// measured on plates, within a tenth for kh < 0.7 and a quarter for kh < 1.3
constexpr double kDispersion = 1.0 / 480.0;
constexpr Index kColumns = 16;

// The elements of a region with no side on the edge of the plate; all, where there are none such
std::vector<Index> inner_elements(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                                  int region) {
  std::vector<int> elements_at(mesh.node_count(), 0);
  for (const Index node : mesh.elements().reshaped()) ++elements_at[node];
  std::vector<Index> all, inner;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    if (regions.region(e) != region) continue;
    all.push_back(e);
    bool is_inner = true;
    for (int side = 4; side < 8; ++side)
      is_inner = is_inner && elements_at[mesh.elements()(side, e)] == 2;
    if (is_inner) inner.push_back(e);
  }
  return inner.empty() ? all : inner;
}

// Mean over the area of m/D times the longest side to the fourth [s²]
double mean_dispersion(const mesh::Q8Mesh& mesh, const PlateRegions& regions) {
  double area = 0.0, sum = 0.0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes nodes = mesh.element_nodes(e);
    double longest = 0.0;
    for (int a = 0; a < 4; ++a)
      longest = std::max(longest, (nodes.col(a) - nodes.col((a + 1) % 4)).norm());
    const double part = evaluate_element(nodes, 0.0, 0.0).jacobian;
    area += part;
    sum += part * std::pow(longest, 4) * regions.of(e).surface_mass() /
           regions.of(e).bending_rigidity();
  }
  return sum / area;
}

// Twice the strain energy of the difference between the section forces at the Gauss points of an
// element and their nodal averages, one a column, and the element's area
struct Jump {
  Eigen::RowVectorXd energy;
  double area;
};
Jump element_jump(const ElementNodes& nodes, const PlateProperties& properties,
                  const MatXd& unknowns, const MatXd& averaged) {
  const Eigen::Matrix<double, 2, 8>& corner = mesh::q8_parametric_nodes();
  const Eigen::Matrix3d compliance = bending_law(properties).inverse();
  MatXd difference = -(gauss_force_matrix(nodes, properties) * unknowns);
  Jump jump{Eigen::RowVectorXd::Zero(unknowns.cols()), 0.0};
  for (int g = 0; g < 4; ++g) {
    const ElementPointValues point =
        evaluate_element(nodes, corner(0, g) / std::sqrt(3.0), corner(1, g) / std::sqrt(3.0));
    for (int a = 0; a < 8; ++a)
      difference.middleRows<kSectionForces>(kSectionForces * g) +=
          point.shape[a] * averaged.middleRows<kSectionForces>(kSectionForces * a);
    const MatXd moment = difference.middleRows<3>(kSectionForces * g);
    const MatXd shear = difference.middleRows<2>(kSectionForces * g + kShearForceX);
    jump.energy += point.jacobian * (moment.cwiseProduct(compliance * moment).colwise().sum() +
                                     shear.colwise().squaredNorm() / shear_law(properties));
    jump.area += point.jacobian;
  }
  return jump;
}

// Twice the strain energy of the jumps in a region (between regions moments may jump), as that of
// its inner elements tells
VecXd jump_energies(const mesh::Q8Mesh& mesh, const PlateRegions& regions, int region,
                    const Eigen::Ref<const MatXd>& shape) {
  const std::vector<Index> elements = inner_elements(mesh, regions, region);
  if (elements.empty()) return VecXd::Zero(shape.cols());
  const PlateProperties& properties = regions[region];
  const NodalAverage average(mesh, elements);
  const double region_area = region_areas(mesh.nodes(), mesh.elements(), regions)[region];
  VecXd energy(shape.cols());
  for (Index first = 0; first < shape.cols(); first += kColumns) {
    const Index columns = std::min(kColumns, shape.cols() - first);
    const MatXd part = shape.middleCols(first, columns);
    const MatXd averaged = average(part, kUnknownsPerNode, kSectionForces, [&](Index e) {
      return nodal_force_matrix(mesh.element_nodes(e), properties);
    });
    std::vector<Jump> jump(elements.size());
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < elements.size(); ++k)
      jump[k] = element_jump(mesh.element_nodes(elements[k]), properties,
                             average.gather(part, kUnknownsPerNode, elements[k]),
                             average.gather(averaged, kSectionForces, elements[k]));
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(columns);
    double area = 0.0;
    for (const Jump& j : jump) {
      sum += j.energy;
      area += j.area;
    }
    energy.segment(first, columns) = (region_area / area) * sum.transpose();
  }
  return energy;
}

}  // namespace

VecXd estimate_frequency_errors(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                                const Eigen::Ref<const VecXd>& omega,
                                const Eigen::Ref<const MatXd>& shape) {
  VecXd energy = VecXd::Zero(omega.size());
  for (int region = 0; region < regions.count(); ++region)
    energy += jump_energies(mesh, regions, region, shape);
  const double dispersion = mean_dispersion(mesh, regions);
  VecXd error = VecXd::Zero(omega.size());
  for (Index i = 0; i < omega.size(); ++i) {
    if (omega[i] == 0.0) continue;
    const double eigenvalue = omega[i] * omega[i];
    error[i] = kDispersion * dispersion * eigenvalue + 0.5 * energy[i] / eigenvalue;
  }
  return error;
}

}  // namespace floe::plate
