#include "bindings.hpp"

#include <floe/mesh/gmsh.hpp>
#include <floe/mesh/mesh_file.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <pybind11/stl/filesystem.h>

namespace floe::python {

using PointTable = py::array_t<double, py::array::c_style | py::array::forcecast>;
using IndexTable = py::array_t<Index, py::array::c_style | py::array::forcecast>;

py::array_t<double> points_array(const Points2& points) {
  py::array_t<double> array({points.cols(), Index{2}});
  std::copy(points.data(), points.data() + points.size(), array.mutable_data());
  return array;
}

Points2 points_of(const PointTable& array) {
  FLOE_VALIDATE(array.ndim() == 2 && array.shape(1) == 2, "invalid points (must be n × 2)");
  return Eigen::Map<const Points2>(array.data(), 2, array.shape(0));
}

namespace {

mesh::Q8Mesh mesh_of(const PointTable& nodes, const IndexTable& elements) {
  FLOE_VALIDATE_AS(MeshError, nodes.ndim() == 2 && nodes.shape(1) == 2,
                   "invalid nodes (must be an array of n × 2)");
  FLOE_VALIDATE_AS(MeshError, elements.ndim() == 2 && elements.shape(1) == 8,
                   "invalid elements (must be an array of n × 8)");
  return {points_of(nodes),
          Eigen::Map<const mesh::Connectivity>(elements.data(), 8, elements.shape(0))};
}

py::array_t<Index> element_array(const mesh::Q8Mesh& mesh) {
  py::array_t<Index> array({mesh.element_count(), Index{8}});
  std::copy(mesh.elements().data(), mesh.elements().data() + mesh.elements().size(),
            array.mutable_data());
  return array;
}

std::string describe(const mesh::Q8Mesh& mesh) {
  return "<floe.Mesh: " + std::to_string(mesh.node_count()) + " nodes, " +
         std::to_string(mesh.element_count()) + " elements, " + std::to_string(mesh.piece_count()) +
         (mesh.piece_count() == 1 ? " piece>" : " pieces>");
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<mesh::Q8Mesh>(module, "Mesh",
                           R"(A plane mesh of 8-node quadrilaterals on z = 0, checked, immutable.

Mesh(nodes, elements) takes positions [m], n × 2, and node numbers from 0, n × 8: four corners, then
the four mid-side nodes, around the element. Raises floe.MeshError naming what cannot be used.)")
      .def(py::init(&mesh_of), py::arg("nodes"), py::arg("elements"))
      .def_property_readonly(
          "nodes", [](const mesh::Q8Mesh& self) { return points_array(self.nodes()); },
          "Positions of the nodes [m], n × 2.")
      .def_property_readonly("elements", &element_array,
                             "Node numbers of the elements, n × 8, from 0.")
      .def_property_readonly("area", &mesh::Q8Mesh::area, "Area [m²].")
      .def_property_readonly("pieces", &mesh::Q8Mesh::piece_count,
                             "Number of plates that do not touch.")
      .def(
          "write",
          [](const mesh::Q8Mesh& self, const std::filesystem::path& path) {
            mesh::write_gmsh(path, self);
          },
          py::arg("path"), "Writes a Gmsh file (.msh 4.1) for `mesh.file` of a case.")
      .def("__repr__", &describe);

  module.def(
      "rectangle",
      [](double length, double width, int nx, int ny, double grading) {
        return mesh::make_rectangle(
            {.length = length, .width = width, .nx = nx, .ny = ny, .grading = grading});
      },
      py::arg("length"), py::arg("width"), py::arg("nx"), py::arg("ny"), py::arg("grading") = 1.0,
      R"(Mesh of a rectangle centred on the origin, length in x and width in y [m].

nx, ny: elements along x and y. grading: longest over shortest edge, 1 to 100; edges shrink towards
the sides.)");
  module.def(
      "read_mesh", [](const std::filesystem::path& path) { return mesh::read_mesh(path).mesh; },
      py::arg("path"),
      "Reads a mesh of quadrilaterals: Gmsh and the other formats of `mesh.file`.");
}

}  // namespace floe::python
