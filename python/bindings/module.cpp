#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of floe; use the package `floe`.";
  module.attr("__version__") = FLOE_VERSION;
  floe::python::bind_errors();
  floe::python::bind_mesh(module);
  floe::python::bind_waves(module);
  floe::python::bind_plate(module);
  floe::python::bind_run(module);
}
