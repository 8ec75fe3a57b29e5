#include "io/vtu.hpp"

#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <span>

namespace floe::io {
namespace {

static_assert(std::endian::native == std::endian::little, "VTU files are written little-endian");

constexpr std::size_t kBlock = 1u << 18;
constexpr int kQuadraticQuad = 23;

void append_number(std::string& bytes, std::uint64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Number of blocks, block size, size of the last partial block (0: it is full), compressed sizes,
// then the compressed blocks
std::string compressed(std::span<const std::byte> data) {
  std::string sizes, blocks;
  for (std::size_t at = 0; at < data.size(); at += kBlock) {
    const std::size_t length = std::min(kBlock, data.size() - at);
    uLongf room = compressBound(static_cast<uLong>(length));
    std::string block(room, '\0');
    const int status = compress2(reinterpret_cast<Bytef*>(block.data()), &room,
                                 reinterpret_cast<const Bytef*>(data.data() + at),
                                 static_cast<uLong>(length), Z_DEFAULT_COMPRESSION);
    if (status != Z_OK) throw std::bad_alloc();
    append_number(sizes, room);
    blocks.append(block, 0, room);
  }
  std::string header;
  append_number(header, (data.size() + kBlock - 1) / kBlock);
  append_number(header, kBlock);
  append_number(header, data.size() % kBlock);
  return header + sizes + blocks;
}

// The XML part and the appended data grow side by side
class VtuDocument {
 public:
  template <typename Number>
  void add(const std::string& name, const char* type, int components,
           const std::vector<Number>& values) {
    xml_ += fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, appended_.size());
    appended_ += compressed(std::as_bytes(std::span(values)));
  }
  void line(const std::string& text) { xml_ += text + "\n"; }
  std::string text() const {
    return xml_ + "  <AppendedData encoding=\"raw\">\n_" + appended_ +
           "\n  </AppendedData>\n</VTKFile>\n";
  }

 private:
  std::string xml_, appended_;
};

void require_finite(const NodeField& field, const std::filesystem::path& path) {
  const bool finite = field.deflection.allFinite() && field.rotation_x.allFinite() &&
                      field.rotation_y.allFinite() && field.pressure.allFinite();
  FLOE_VALIDATE_AS(ConvergenceError, finite,
                   "invalid node field of " << path.filename().string() << " at omega = "
                                            << field.omega << " rad/s (must be finite)");
}

template <typename Function>
void add_scalars(VtuDocument& document, const std::string& name, const VecXcd& values,
                 Function part) {
  std::vector<double> numbers(static_cast<std::size_t>(values.size()));
  for (Index i = 0; i < values.size(); ++i) numbers[static_cast<std::size_t>(i)] = part(values[i]);
  document.add(name, "Float64", 1, numbers);
}

void add_parts(VtuDocument& document, const std::string& name, const VecXcd& values) {
  add_scalars(document, name + "_re", values, [](const Complex& z) { return z.real(); });
  add_scalars(document, name + "_im", values, [](const Complex& z) { return z.imag(); });
}

void add_point_data(VtuDocument& document, const NodeField& field) {
  document.line("      <PointData Scalars=\"w_abs\">");
  add_parts(document, "w", field.deflection);
  add_scalars(document, "w_abs", field.deflection, [](const Complex& z) { return std::abs(z); });
  add_scalars(document, "w_phase", field.deflection, [](const Complex& z) { return std::arg(z); });
  add_parts(document, "rotation_x", field.rotation_x);
  add_parts(document, "rotation_y", field.rotation_y);
  add_parts(document, "p", field.pressure);
  document.line("      </PointData>");
}

void add_mesh(VtuDocument& document, const mesh::Q8Mesh& mesh) {
  std::vector<double> points;
  for (Index n = 0; n < mesh.node_count(); ++n)
    points.insert(points.end(), {mesh.nodes()(0, n), mesh.nodes()(1, n), 0.0});
  document.line("      <Points>");
  document.add("Points", "Float64", 3, points);
  document.line("      </Points>");

  std::vector<std::int64_t> connectivity, offsets;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    for (int a = 0; a < 8; ++a) connectivity.push_back(mesh.elements()(a, e));
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  document.line("      <Cells>");
  document.add("connectivity", "Int64", 1, connectivity);
  document.add("offsets", "Int64", 1, offsets);
  document.add("types", "UInt8", 1,
               std::vector<std::uint8_t>(offsets.size(), std::uint8_t{kQuadraticQuad}));
  document.line("      </Cells>");
}

constexpr const char* kFileAttributes =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
    "compressor=\"vtkZLibDataCompressor\"";

using Described = std::vector<std::pair<std::string, double>>;

void add_described(VtuDocument& document, const Described& described) {
  document.line("    <FieldData>");
  for (const auto& [name, value] : described)
    document.line(
        fmt::format("      <DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" "
                    "format=\"ascii\">{}</DataArray>",
                    name, shortest(value)));
  document.line("    </FieldData>");
}

// A whole grid: what describes it, the point data and the mesh
template <typename PointData>
void write_grid(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
                const Described& described, PointData add_data) {
  VtuDocument document;
  document.line("<?xml version=\"1.0\"?>");
  document.line(fmt::format("<VTKFile type=\"UnstructuredGrid\" {}>", kFileAttributes));
  document.line("  <UnstructuredGrid>");
  add_described(document, described);
  document.line(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
                            mesh.node_count(), mesh.element_count()));
  add_data(document);
  add_mesh(document, mesh);
  document.line("    </Piece>");
  document.line("  </UnstructuredGrid>");
  write_file(path, document.text());
}

// A name as an attribute of XML
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else if (c == '>')
      text += "&gt;";
    else
      text += c;
  }
  return text;
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
               const NodeField& field) {
  require_finite(field, path);
  write_grid(path, mesh, {{"omega", field.omega}, {"heading_deg", field.heading_deg}},
             [&](VtuDocument& document) { add_point_data(document, field); });
}

void write_phase_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
                     const NodeField& field, double phase) {
  require_finite(field, path);
  const Complex turn = std::polar(1.0, -phase);
  const auto now = [turn](const Complex& z) { return (z * turn).real(); };
  std::vector<double> displacement;
  for (const Complex& w : field.deflection)
    displacement.insert(displacement.end(), {0.0, 0.0, now(w)});
  write_grid(path, mesh,
             {{"omega", field.omega}, {"heading_deg", field.heading_deg}, {"phase", phase}},
             [&](VtuDocument& document) {
               document.line("      <PointData Scalars=\"w\" Vectors=\"displacement\">");
               add_scalars(document, "w", field.deflection, now);
               document.add("displacement", "Float64", 3, displacement);
               add_scalars(document, "p", field.pressure, now);
               document.line("      </PointData>");
             });
}

Points2 PointGrid::points() const {
  Points2 positions(2, columns * rows);
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i)
      positions.col(j * columns + i) =
          origin + step * Point2(static_cast<double>(i), static_cast<double>(j));
  return positions;
}

void write_surface_vti(const std::filesystem::path& path, const PointGrid& grid,
                       const VecXcd& elevation, const std::vector<std::uint8_t>& on_plate,
                       double omega, double heading_deg) {
  FLOE_VALIDATE_AS(ConvergenceError, elevation.allFinite(),
                   "invalid elevation of " << path.filename().string() << " at omega = " << omega
                                           << " rad/s (must be finite)");
  const std::string extent = fmt::format("0 {} 0 {} 0 0", grid.columns - 1, grid.rows - 1);
  VtuDocument document;
  document.line("<?xml version=\"1.0\"?>");
  document.line(fmt::format("<VTKFile type=\"ImageData\" {}>", kFileAttributes));
  document.line(
      fmt::format("  <ImageData WholeExtent=\"{}\" Origin=\"{} {} 0\" Spacing=\"{} {} 1\">", extent,
                  shortest(grid.origin.x()), shortest(grid.origin.y()), shortest(grid.step),
                  shortest(grid.step)));
  add_described(document, {{"omega", omega}, {"heading_deg", heading_deg}});
  document.line(fmt::format("    <Piece Extent=\"{}\">", extent));
  document.line("      <PointData Scalars=\"zeta_abs\">");
  add_parts(document, "zeta", elevation);
  add_scalars(document, "zeta_abs", elevation, [](const Complex& z) { return std::abs(z); });
  add_scalars(document, "zeta_phase", elevation, [](const Complex& z) { return std::arg(z); });
  document.add("on_plate", "UInt8", 1, on_plate);
  document.line("      </PointData>");
  document.line("    </Piece>");
  document.line("  </ImageData>");
  write_file(path, document.text());
}

void write_statistics_vtu(const std::filesystem::path& path, const mesh::Q8Mesh& mesh,
                          const std::vector<SeaResult>& results) {
  write_grid(path, mesh, {}, [&](VtuDocument& document) {
    document.line("      <PointData>");
    for (const SeaResult& result : results) {
      const std::string name = escaped(result.sea) + "_" + shortest(result.mean_heading_deg);
      const Index nodes = result.node_moments.rows();
      std::vector<double> deviation, period;
      for (Index i = 0; i < nodes; ++i) {
        const double m0 = result.node_moments(i, 0), m2 = result.node_moments(i, 2);
        deviation.push_back(std::sqrt(m0));
        period.push_back(m2 > 0.0 ? 2.0 * std::numbers::pi * std::sqrt(m0 / m2) : 0.0);
      }
      FLOE_VALIDATE_AS(ConvergenceError, result.node_moments.allFinite(),
                       "invalid deviations of sea " << result.sea << " (must be finite)");
      document.add("std_w_" + name, "Float64", 1, deviation);
      document.add("period_w_" + name, "Float64", 1, period);
    }
    document.line("      </PointData>");
  });
}

void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const PvdEntry& entry : entries)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"{}\" file=\"{}\"/>\n",
                        shortest(entry.omega), entry.heading, entry.file);
  write_file(path, text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace floe::io
