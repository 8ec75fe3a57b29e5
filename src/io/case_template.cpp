#include "io/atomic_file.hpp"

#include <floe/io/case_template.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

namespace floe::io {
namespace {

// A TOML string of any text
std::string quoted(const std::string& text) {
  std::string toml = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      toml += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      toml += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      toml += c;
  }
  return toml + "\"";
}

// A TOML number without the noise of rounding: "58.5", "300", "inf"
std::string number(double value) { return fmt::format("{:.12g}", value == 0.0 ? 0.0 : value); }

std::string numbers(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(number(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

constexpr const char* kHead =
    R"(# A case of floe. SI units; degrees only in keys that end in _deg. A line that begins with # says
# what may be added, with the default that holds without it. docs/howto/case_file.md tells more.
)";

std::string water_and_plate(const CaseTemplate& wanted) {
  return fmt::format(R"(
[water]
depth = {}  # m; or inf
density = 1025.0  # kg/m³
# gravity = 9.81  # m/s²

# EDIT: these are the values of a plate in Li et al. (2014); put in those of yours. A hollow plate
# goes in as a solid one of the same bending rigidity E t³/12(1 - ν²) and the same mass per area.
[plate]
thickness = {}  # m
youngs_modulus = 1.19e10  # N/m²
poisson_ratio = 0.13
density = 256.25  # kg/m³, of the solid plate; below that of the water
# shear_correction = 0.8333333333333334
# loss_factor = 0.0  # structural damping, 0 to 1: E(1 - iη)
# mesh = {{ rectangle = {{ length = 300.0, width = 60.0, nx = 20, ny = 4 }} }}  # a mesh of its own
# region = [{{ name = "hangar", thickness = 3.0 }}]  # a group of the mesh with other properties
# structure = {{ stiffness = "K.mtx", mass = "M.mtx" }}  # of another program, instead of all these
)",
                     number(wanted.depth), number(wanted.thickness));
}

std::string mesh(const CaseTemplate& wanted) {
  if (!wanted.mesh_file.empty())
    return fmt::format(R"(
# Gmsh .msh of quadrilaterals in the plane z = 0, in metres; the path is relative to this file
[mesh]
file = {}
# or a rectangle about the origin: rectangle = {{ length = 300.0, width = 60.0, nx = 50, ny = 10 }}
)",
                       quoted(wanted.mesh_file));
  const mesh::RectangleOptions& r = wanted.rectangle;
  return fmt::format(R"(
# About the origin, length along x; nx × ny elements. Nodes lie half an element edge apart: give the
# shortest wave 4 nodes or more (floe check tells)
[mesh]
rectangle = {{ length = {}, width = {}, nx = {}, ny = {} }}  # grading = 1.0
# or any outline: file = "plate.msh"; or a disc, ring, lshape or modules as by floe mesh
)",
                     number(r.length), number(r.width), r.nx, r.ny);
}

std::string waves(const CaseTemplate& wanted) {
  return fmt::format(R"(
{}count = {}  # dry modes, the three rigid ones of every plate included

# Regular waves. Instead of omega: period (s), freq (Hz), wavenumber (rad/m) or wavelength (m)
[waves]
omega = {{ from = {}, to = {}, count = 20 }}  # rad/s; or a list [0.42, 0.72]
heading_deg = {}  # where the waves travel to, from +x towards +y

# [solver]
# method = "auto"  # dense, lattice, pfft, fmm
# route = "modal"
# tolerance = 1e-6  # of the results, 1e-9 to 1e-1
)",
                     wanted.mode_count == 30 ? "# [modes]\n# " : "[modes]\n", wanted.mode_count,
                     number(wanted.omega_from), number(wanted.omega_to),
                     numbers(wanted.heading_deg));
}

std::string sea(const CaseTemplate& wanted) {
  const SeaTemplate sea = wanted.sea.value_or(SeaTemplate{2.0, 6.3});
  const std::string text = fmt::format(R"(
[[sea]]  # any number of them
name = "design"
spectrum = "bretschneider"  # or jonswap, pierson-moskowitz (peak_period), table, measured
significant_height = {}  # m, mean of the highest third
significant_period = {}  # s, of the highest third
spreading = "cos2"  # or cosn (n), cos2s (s), wrapped-normal (std_deg), none
mean_heading_deg = {}
# duration = 10800  # s, of the storm, for its largest value
# allow_truncation = false  # go on with more than 5 % of the energy beyond the frequencies

# [sea_grid]  # frequencies for the seas; chosen by the program
# omega = {{ from = 0.4, to = 3.0 }}
# tolerance = 1e-3
)",
                                       number(sea.significant_height),
                                       number(sea.significant_period), numbers(wanted.heading_deg));
  if (wanted.sea) return text;
  std::string comment = "\n# A sea state: take away the #\n";
  for (std::size_t at = 1; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    comment += (line.empty() || line[0] == '#' ? line : "# " + line) + "\n";
    at = end + 1;
  }
  return comment;
}

std::string output(const CaseTemplate& wanted) {
  std::vector<std::string> points;
  for (const NamedPoint& point : wanted.points)
    points.push_back(fmt::format("{} = [{}, {}]", point.name, number(point.position.x()),
                                 number(point.position.y())));
  const double end = wanted.mesh_file.empty() ? wanted.rectangle.length / 2.0 : 150.0;
  const std::string line =
      fmt::format("lines = {{ centreline = {{ from = [{}, 0], to = [{}, 0], count = 61 }} }}",
                  number(-end), number(end));
  return fmt::format(R"(
[output]
points = {{ {} }}
{}
# wave_points = {{ lee = [200.0, 0.0] }}  # elevation of the water, anywhere
# quantities at the points; also velocity, acceleration, slope_x, twisting_moment, shear_force_x,
# surface_stress_x, pressure, relative_elevation, and those along y
quantities = ["deflection", "bending_moment_x", "bending_moment_y"]
# fields = [{{ omega = 0.42, heading_deg = 0 }}]  # waves whose node fields are written for ParaView
# in every sea: two quantities at once, several as one, the spectrum at every node
# cross_spectra = [["P1", "deflection", "P2", "deflection"]]
# combinations = {{ twist = {{ terms = [["P1", "deflection", 1.0], ["P2", "deflection", -1.0]] }} }}
# node_spectra = false
)",
                     fmt::join(points, ", "), wanted.mesh_file.empty() ? line : "# " + line);
}

}  // namespace

std::string case_text(const CaseTemplate& wanted) {
  return kHead + fmt::format("title = {}\n", quoted(wanted.title)) + water_and_plate(wanted) +
         mesh(wanted) + waves(wanted) + sea(wanted) + output(wanted);
}

void write_new_case(const std::filesystem::path& path, const CaseTemplate& wanted) {
  FLOE_VALIDATE_AS(StoreError, !std::filesystem::exists(std::filesystem::symlink_status(path)),
                   path.string() << ": is there already (floe init overwrites nothing)");
  write_file(path, case_text(wanted));
}

}  // namespace floe::io
