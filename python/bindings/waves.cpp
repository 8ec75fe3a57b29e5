#include "bindings.hpp"

#include <floe/green/green_function.hpp>
#include <floe/wave/dispersion.hpp>
#include <floe/wave/spectrum.hpp>

#include <limits>

namespace floe::python {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

wave::Water water_of(double depth, double gravity) {
  return {.depth = depth, .density = 1025.0, .gravity = gravity};
}

double wavenumber(double omega, double depth, double gravity) {
  return wave::wavenumber(omega, water_of(depth, gravity));
}

double angular_frequency(double number, double depth, double gravity) {
  return wave::angular_frequency(number, water_of(depth, gravity));
}

double group_velocity(double omega, double depth, double gravity) {
  return wave::group_velocity(omega, water_of(depth, gravity));
}

py::object green_function(const py::array_t<double>& distance, double omega, double depth,
                          double gravity) {
  const green::GreenFunction green(wave::deep_wavenumber(omega, water_of(depth, gravity)), depth);
  return py::vectorize([&green](double r) { return green(r); })(distance);
}

py::object values_of(const wave::Spectrum& spectrum, const py::array_t<double>& omega) {
  return py::vectorize([&spectrum](double w) { return spectrum(w); })(omega);
}

void bind_spectra(py::module_& module) {
  module.def(
      "bretschneider",
      [](const py::array_t<double>& omega, double height, double period) {
        return values_of(wave::Spectrum::bretschneider(height, period), omega);
      },
      py::arg("omega"), py::arg("significant_height"), py::arg("significant_period"),
      "Bretschneider-Mitsuyasu spectrum S(omega) [m² s/rad], one-sided, of H1/3 [m], T1/3 [s].");
  module.def(
      "jonswap",
      [](const py::array_t<double>& omega, double height, double period, double gamma) {
        return values_of(wave::Spectrum::jonswap(height, period, gamma), omega);
      },
      py::arg("omega"), py::arg("significant_height"), py::arg("peak_period"),
      py::arg("gamma") = 3.3,
      "JONSWAP spectrum S(omega) [m² s/rad], one-sided, scaled to Hs = 4 √m0 [m]; gamma = 1 is "
      "Pierson-Moskowitz.");
}

}  // namespace

void bind_waves(py::module_& module) {
  module.def("wavenumber", py::vectorize(wavenumber), py::arg("omega"),
             py::arg("depth") = kInfinite, py::arg("gravity") = 9.81,
             R"(Wavenumber k [rad/m]: k tanh(kh) = omega²/g. Arguments may be arrays.

omega [rad/s], depth h [m] or inf, gravity [m/s²]. Relative error below 4e-16.)");
  module.def("angular_frequency", py::vectorize(angular_frequency), py::arg("wavenumber"),
             py::arg("depth") = kInfinite, py::arg("gravity") = 9.81,
             "Frequency omega [rad/s] of the wave with wavenumber k [rad/m].");
  module.def("group_velocity", py::vectorize(group_velocity), py::arg("omega"),
             py::arg("depth") = kInfinite, py::arg("gravity") = 9.81,
             "Velocity of the energy, d omega / d k [m/s].");
  module.def("green_function", &green_function, py::arg("distance"), py::arg("omega"),
             py::arg("depth") = kInfinite, py::arg("gravity") = 9.81,
             R"(Green function of the free surface [1/m], source and field point on z = 0.

G ~ 2/R near the source, time factor exp(-i omega t). distance R [m]; relative error below 1e-11.)");
  bind_spectra(module);
}

}  // namespace floe::python
