#define XXH_INLINE_ALL
#include "io/case_sections.hpp"
#include "io/matrix_market.hpp"
#include "io/regular_file.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <memory>

namespace floe::io {
namespace {

constexpr std::uintmax_t kLargestMatrixFile = std::uintmax_t{1} << 38;

constexpr NumberRule kPositive(const char* unit) { return {unit, "must be positive", is_positive}; }

// What may differ from region to region. Values beyond the range are likely of another unit
struct MaterialKey {
  const char* name;
  double plate::PlateProperties::*member;
  NumberRule rule;
  double likely_least = -1.0, likely_most = 1.0;
  const char* mistaken = "";
};
const std::vector<MaterialKey>& material_keys() {
  using Properties = plate::PlateProperties;
  static const std::vector<MaterialKey> keys = {
      {"thickness", &Properties::thickness, kPositive("m"), 1e-3, 100.0, "millimetres"},
      {"youngs_modulus", &Properties::youngs_modulus, kPositive("N/m²"), 1e5, 1e13, "GPa or MPa"},
      {"poisson_ratio",
       &Properties::poisson_ratio,
       {"", "must be greater than -1 and less than 0.5",
        [](double x) { return x > -1.0 && x < 0.5; }}},
      {"density", &Properties::density, kPositive("kg/m³"), 5.0, 2e4, "t/m³ or g/cm³"}};
  return keys;
}

void warn_of_units(const Section& section, const plate::PlateProperties& properties) {
  for (const MaterialKey& key : material_keys()) {
    const double value = properties.*key.member;
    const toml::node* const given = section.find(key.name);
    if (!given || (value >= key.likely_least && value <= key.likely_most)) continue;
    section.source().warnings.push_back(
        fmt::format("{}{} = {:g} {} is far from that of any plate (was it meant in {}?)",
                    section.source().place(given->source()), section.full_name(key.name), value,
                    key.rule.unit, key.mistaken));
  }
}

void require_floating(const Section& section, const plate::PlateProperties& properties,
                      const wave::Water& water) {
  const toml::node* const given = section.find("density");
  if (properties.density < water.density) return;
  section.source().refuse(
      given ? given->source() : section.place(),
      fmt::format("invalid {} = {} kg/m³ (must be less than water.density = {} kg/m³, or the plate "
                  "sinks)",
                  section.full_name("density"), properties.density, water.density));
}

// [[plate.region]]: what is not given is that of the plate
void read_regions(const Section& plate, Case& data) {
  const toml::node* const node = plate.find("region");
  if (!node) return;
  const toml::array* const list = node->as_array();
  if (!list || list->empty() || !list->is_array_of_tables())
    plate.source().refuse(node->source(), fmt::format("invalid plate.region = {} (must be tables "
                                                      "[[plate.region]])",
                                                      shown(*node)));
  std::vector<std::string> known = {"name"};
  for (const MaterialKey& key : material_keys()) known.push_back(key.name);
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Section region(*(*list)[i].as_table(), fmt::format("plate.region[{}]", i), plate.source(),
                         known);
    region.require("name", "a region needs the name of a group of the mesh's elements");
    PlateRegion read{region.text_or("name", ""), data.plate};
    for (const PlateRegion& other : data.regions)
      if (other.name == read.name)
        region.source().refuse(
            region.find("name")->source(),
            fmt::format("repeated {} = {} (must differ from those of other regions)",
                        region.full_name("name"), shown(*region.find("name"))));
    for (const MaterialKey& key : material_keys())
      read.properties.*key.member = region.number_or(key.name, key.rule, data.plate.*key.member);
    require_floating(region, read.properties, data.water);
    warn_of_units(region, read.properties);
    data.regions.push_back(std::move(read));
  }
}

// A file of plate.structure, as text; its hash is added to that of the others
std::string read_matrix_file(const Section& section, const std::string& key,
                             const std::filesystem::path& folder, GivenStructure& structure) {
  const std::filesystem::path path = folder / section.text_or(key, "");
  structure.files.emplace_back(key, path);
  try {
    std::string text = read_regular_file(path, kLargestMatrixFile);
    const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
    structure.hash += fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
    return text;
  } catch (const InputError& error) {
    throw MeshError(section.source().place(section.find(key)->source()) +
                    fmt::format("invalid {}: {}", section.full_name(key), error.what()));
  }
}

// { stiffness, mass }, or { modes, omega } and perhaps mass
void read_structure(const Section& plate, const std::filesystem::path& folder, Case& data) {
  for (const char* key :
       {"thickness", "youngs_modulus", "poisson_ratio", "density", "shear_correction", "region"})
    if (const toml::node* const node = plate.find(key))
      plate.source().refuse(
          node->source(),
          fmt::format("unused {} (plate.structure takes its place)", plate.full_name(key)));
  const Section section = plate.table("structure", {"stiffness", "mass", "modes", "omega"});
  const bool modal = section.find("modes") != nullptr;
  if (modal == (section.find("stiffness") != nullptr) ||
      modal != (section.find("omega") != nullptr) || (!modal && !section.find("mass")))
    section.source().refuse(section.place(),
                            "invalid plate.structure (must hold stiffness and mass, or modes and "
                            "omega, mass besides if known)");
  auto structure = std::make_shared<GivenStructure>();
  const auto sparse = [&](const char* key) {
    const std::string text = read_matrix_file(section, key, folder, *structure);
    return parse_sparse_matrix(text, structure->files.back().second.string());
  };
  const auto dense = [&](const char* key) {
    const std::string text = read_matrix_file(section, key, folder, *structure);
    return parse_dense_matrix(text, structure->files.back().second.string());
  };
  if (modal) {
    structure->modes.shape = dense("modes");
    structure->modes.omega = dense("omega").reshaped();
    if (section.find("mass")) structure->modes.mass = sparse("mass");
    data.mode_count =
        static_cast<int>(std::min<Index>(data.mode_count, structure->modes.omega.size()));
  } else {
    structure->matrices = {sparse("stiffness"), sparse("mass")};
  }
  data.structure = std::move(structure);
}

}  // namespace

std::vector<std::string> plate_keys() {
  return {"thickness",   "youngs_modulus", "poisson_ratio", "density",  "shear_correction",
          "loss_factor", "mesh",           "region",        "structure"};
}

void read_plate(const Section& root, const std::filesystem::path& folder, Case& data) {
  const Section plate = root.table("plate", plate_keys());
  const NumberRule correction{"", "must be greater than 0 and at most 1",
                              [](double x) { return x > 0.0 && x <= 1.0; }};
  const NumberRule loss{"", "must be 0 to 1", [](double x) { return x >= 0.0 && x <= 1.0; }};
  auto& p = data.plate;
  p.loss_factor = plate.number_or("loss_factor", loss, p.loss_factor);
  if (plate.find("structure")) return read_structure(plate, folder, data);
  for (const MaterialKey& key : material_keys()) p.*key.member = plate.number(key.name, key.rule);
  p.shear_correction = plate.number_or("shear_correction", correction, p.shear_correction);
  require_floating(plate, p, data.water);
  warn_of_units(plate, p);
  read_regions(plate, data);
}

}  // namespace floe::io
