#include <floe/fmm/radial_kernel.hpp>
#include <floe/mesh/rectangle.hpp>

// Returns 0 when both libraries are there: a mesh from the engine, a type from the fast sums.
int main() {
  const floe::mesh::Q8Mesh mesh =
      floe::mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 50, .ny = 10});
  const floe::fmm::WaveTerm wave{.wavenumber = 0.1, .coefficient = {0.0, 1.0}};
  return mesh.node_count() == 1621 && wave.wavenumber > 0.0 ? 0 : 1;
}
