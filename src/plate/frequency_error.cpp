#include "plate/frequency_error.hpp"

#include "plate/nodal_average.hpp"
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

// The elements with no side on the edge of the plate; all, where there are no such elements
std::vector<Index> inner_elements(const mesh::Q8Mesh& mesh) {
  std::vector<int> elements_at(mesh.node_count(), 0);
  for (const Index node : mesh.elements().reshaped()) ++elements_at[node];
  std::vector<Index> inner;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    bool is_inner = true;
    for (int side = 4; side < 8; ++side)
      is_inner = is_inner && elements_at[mesh.elements()(side, e)] == 2;
    if (is_inner) inner.push_back(e);
  }
  return inner.empty() ? all_elements(mesh) : inner;
}

// Mean over the area of the longest side to the fourth [m⁴]
double mean_fourth_power_of_side(const mesh::Q8Mesh& mesh) {
  double area = 0.0, sum = 0.0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes nodes = mesh.element_nodes(e);
    double longest = 0.0;
    for (int a = 0; a < 4; ++a)
      longest = std::max(longest, (nodes.col(a) - nodes.col((a + 1) % 4)).norm());
    const double part = evaluate_element(nodes, 0.0, 0.0).jacobian;
    area += part;
    sum += part * std::pow(longest, 4);
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

// Twice the strain energy of the jumps over the whole plate, as that of the inner elements tells
VecXd jump_energies(const mesh::Q8Mesh& mesh, const PlateProperties& properties,
                    const Eigen::Ref<const MatXd>& shape) {
  const std::vector<Index> elements = inner_elements(mesh);
  const NodalAverage average(mesh, elements);
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
    energy.segment(first, columns) = (mesh.area() / area) * sum.transpose();
  }
  return energy;
}

}  // namespace

VecXd estimate_frequency_errors(const mesh::Q8Mesh& mesh, const PlateProperties& properties,
                                const Eigen::Ref<const VecXd>& omega,
                                const Eigen::Ref<const MatXd>& shape) {
  const VecXd energy = jump_energies(mesh, properties, shape);
  const double side = mean_fourth_power_of_side(mesh);
  VecXd error = VecXd::Zero(omega.size());
  for (Index i = 0; i < omega.size(); ++i) {
    if (omega[i] == 0.0) continue;
    const double eigenvalue = omega[i] * omega[i];
    const double fourth_power_of_wavenumber =
        properties.surface_mass() * eigenvalue / properties.bending_rigidity();
    error[i] = kDispersion * fourth_power_of_wavenumber * side + 0.5 * energy[i] / eigenvalue;
  }
  return error;
}

}  // namespace floe::plate
