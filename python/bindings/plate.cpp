#include "bindings.hpp"

#include <floe/numeric/blas_threads.hpp>
#include <floe/plate/dry_modes.hpp>

namespace floe::python {
namespace {

// omega, shape (modes × nodes × 3), number of rigid modes, estimated error of the frequencies
py::tuple dry_modes(const mesh::Q8Mesh& mesh, double thickness, double youngs_modulus,
                    double poisson_ratio, double density, double shear_correction, int count) {
  const plate::PlateProperties properties{.thickness = thickness,
                                          .youngs_modulus = youngs_modulus,
                                          .poisson_ratio = poisson_ratio,
                                          .density = density,
                                          .shear_correction = shear_correction,
                                          .loss_factor = 0.0};
  const plate::DryModes modes = [&] {
    const py::gil_scoped_release released;
    const numeric::KeptBlasThreads kept;
    return plate::dry_modes(mesh, properties, {.count = count});
  }();
  return py::make_tuple(vector_array(modes.omega), shape_array(modes.shape), modes.rigid_count,
                        modes.estimated_frequency_error);
}

}  // namespace

void bind_plate(py::module_& module) {
  module.def("dry_modes", &dry_modes, py::arg("mesh"), py::arg("thickness"),
             py::arg("youngs_modulus"), py::arg("poisson_ratio"), py::arg("density"),
             py::arg("shear_correction"), py::arg("count"), "The parts of floe.DryModes.");
}

}  // namespace floe::python
