#define XXH_INLINE_ALL
#include "io/manifest.hpp"

#include "io/atomic_file.hpp"
#include "io/case_json.hpp"
#include "io/node_spectra_file.hpp"
#include "io/product_names.hpp"
#include "io/products.hpp"
#include "io/record_names.hpp"
#include "io/regular_file.hpp"
#include "io/relation_tables.hpp"
#include "io/sea_tables.hpp"

#include <floe/mesh/mesh_hash.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <xxhash.h>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestManifest = std::uintmax_t{256} << 20;
constexpr std::uintmax_t kLargestInput = std::uintmax_t{1} << 40;
constexpr int kFormat = 1;  // of the manifest
// Raise it when the same case gives other bits than before: earlier records are refused then
constexpr int kSolver = 1;

std::string hash_of_bytes(const std::string& bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

// What the case takes from elsewhere, by content; the fluid's mesh has a hash of its own, and of
// the seas the manifest holds words only
Json input_hashes(const Case& data) {
  Json hashes = Json::object();
  for (const MeshSource& source : data.plate_mesh)
    if (const auto* file = std::get_if<std::filesystem::path>(&source))
      hashes["plate.mesh.file"] = hash_of_bytes(read_regular_file(*file, kLargestInput));
  // NOTE: the mesh's hash does not know its groups
  const plate::PlateRegions regions = plate_regions(data);
  if (regions.count() > 1) hashes["plate.region"] = mesh::hash_of(regions.of_element());
  if (!data.sea_text.empty()) hashes["sea"] = hash_of_bytes(data.sea_text);
  for (const auto& [key, file] : data.sea_files)
    hashes[key] = hash_of_bytes(read_regular_file(file, kLargestInput));
  return hashes;
}

// What may change between a run and its resumption; files count by their content, wherever they are
Json without_harmless(Json manifest) {
  for (const char* key : {"program", "version", "plan_memory", "case_text"}) manifest.erase(key);
  if (!manifest.contains("options") || !manifest["options"].is_object()) return manifest;
  Json& options = manifest["options"];
  for (const char* key : {"title", "allow_coarse"}) options.erase(key);
  for (const char* path : {"/mesh/file", "/plate/mesh/file"})
    if (const Json::json_pointer at(path); options.contains(at)) options[at] = "";
  return manifest;
}

}  // namespace

Json make_manifest(const Case& data, const std::string& mesh_hash) {
  Json manifest = {{"program", "floe"},         {"version", FLOE_VERSION},
                   {"format", kFormat},         {"solver", kSolver},
                   {"mesh_hash", mesh_hash},    {"input_hashes", input_hashes(data)},
                   {"options", case_json(data)}};
  if (data.shard.count > 1)
    manifest["shard"] = {{"index", data.shard.index}, {"count", data.shard.count}};
  manifest["plan_memory"] = plan_budget(data);
  manifest["case_text"] = data.text;
  return manifest;
}

Json read_manifest(const std::filesystem::path& directory, const std::string& advice) {
  const std::filesystem::path path = directory / kManifest;
  Json manifest;
  try {
    manifest = Json::parse(read_regular_file(path, kLargestManifest));
    if (manifest.at("program") != "floe") throw StoreError("");
    const int format = manifest.at("format");
    FLOE_VALIDATE_AS(StoreError, format <= kFormat,
                     path.string() << " has the format version " << format << ", this floe reads "
                                   << kFormat << advice);
    manifest.at("options").at("waves").at("omega");
    manifest.at("mesh_hash").get_ref<const std::string&>();
  } catch (const Json::exception&) {
    throw StoreError(path.string() + " is damaged" + advice);
  } catch (const InputError& error) {
    throw StoreError(std::string(error.what()) + advice);
  }
  return manifest;
}

void write_manifest(const std::filesystem::path& directory, const Json& manifest) {
  write_file(directory / kManifest,
             manifest.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string identity_of(const Json& manifest) {
  Json identity = without_harmless(manifest);
  identity.erase("shard");
  // NOTE: sorted keys, so that order does not matter
  return nlohmann::json(identity).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string differing_keys(const Json& earlier, const Json& later) {
  // NOTE: through text, as one of them was
  const Json a = Json::parse(without_harmless(earlier).dump()),
             b = Json::parse(without_harmless(later).dump());
  std::string differing;
  for (const auto& change : Json::diff(a, b))
    differing += (differing.empty() ? "" : ", ") + change.at("path").get<std::string>();
  return differing;
}

std::vector<std::string> files_of_manifest(const std::filesystem::path& directory) {
  const Json options = read_manifest(directory).at("options");
  std::vector<std::string> files = product_names();
  for (const auto& names :
       {sea_table_names(), relation_table_names(case_from_json(options).relations)})
    files.insert(files.end(), names.begin(), names.end());
  files.insert(files.end(), {"statistics.vtu", NodeSpectraFile::kName, kManifest});
  for (const Json& omega : options.at("waves").at("omega"))
    for (const Json& heading : options.at("waves").at("heading_deg"))
      files.push_back(field_file(omega, heading));
  for (const std::string& record : records_in(directory)) files.push_back(record);
  return files;
}

}  // namespace floe::io
