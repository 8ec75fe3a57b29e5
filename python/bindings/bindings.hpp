#pragma once

#include <floe/run_results.hpp>

#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

/// The parts of the Python module `floe._core`, and how results become numpy arrays.
namespace floe::python {

namespace py = pybind11;

void bind_errors();
void bind_mesh(py::module_& module);
void bind_waves(py::module_& module);
void bind_plate(py::module_& module);
void bind_run(py::module_& module);

/// Results as a dictionary, whose keys are the fields of floe.Result.
py::dict dictionary_of(const RunResults& results);
py::list sea_list(const Case& data, const std::vector<SeaResult>& seas);
/// modes × nodes × (w, θx, θy) of 3N × modes.
py::array_t<double> shape_array(const MatXd& shape);

/// n × 2 of 2 × n, and back.
py::array_t<double> points_array(const Points2& points);
Points2 points_of(const py::array_t<double, py::array::c_style | py::array::forcecast>& array);

/// A copy of a vector.
template <typename Vector>
py::array_t<typename Vector::Scalar> vector_array(const Vector& values) {
  py::array_t<typename Vector::Scalar> array(values.size());
  std::copy(values.data(), values.data() + values.size(), array.mutable_data());
  return array;
}

/// count × columns × rows of `count` matrices of rows × columns, `get(i)` each: the last index is
/// the matrix's row.
template <typename Scalar, typename Get>
py::array_t<Scalar> stack_transposed(std::size_t count, Index rows, Index columns, Get get) {
  py::array_t<Scalar> array({static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(columns),
                             static_cast<py::ssize_t>(rows)});
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  for (std::size_t i = 0; i < count; ++i)
    Eigen::Map<Matrix>(array.mutable_data() + static_cast<Index>(i) * rows * columns, rows,
                       columns) = get(i);
  return array;
}

}  // namespace floe::python
