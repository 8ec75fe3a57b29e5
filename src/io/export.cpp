#include "io/output_directory.hpp"
#include "io/product_names.hpp"
#include "io/products.hpp"
#include "io/record_names.hpp"

#include <floe/io/export.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/unsolved_frequency.hpp>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

// The account of the run itself, with what it alone can know
RunAccount account_of(const StoredRun& run, const mesh::Q8Mesh& mesh) {
  const std::string& text = run.account_text();
  const Json told = text.empty() ? Json::object() : Json::parse(text);
  RunAccount account = describe_run(run.data(), mesh, run.plan());
  account.threads = run.threads();
  account.stages = run.stages();
  account.seconds_before = run.seconds_before();
  account.status = run.status();
  account.peak_memory = told.value("peak_memory", 0.0);
  account.files = told.value("files", std::vector<std::string>());
  return account;
}

std::string status_of(const StoredRun& run, const Exported& exported) {
  if (exported.complete()) return "complete";
  if (exported.missing.empty() && !exported.seas_missing) return kFailed;
  return run.status() == "running" ? "stopped without notice" : run.status();
}

}  // namespace

Exported export_run(const std::filesystem::path& directory) {
  // Lock the run, and read whatever is damaged before anything is written
  static_cast<void>(StoredRun(directory));
  OutputDirectory output(directory, Existing::kResume);
  output.clear_leftovers();
  const StoredRun run(directory);
  const Case& data = run.data();
  const mesh::Q8Mesh mesh = run.fluid_mesh();
  const bool modal = data.route == SolverRoute::kModal;
  const std::optional<plate::DryModes> modes = modal ? std::optional(run.modes()) : std::nullopt;
  const std::vector<SeaResult> seas = run.finished_seas() ? run.seas() : std::vector<SeaResult>();
  RunAccount account = account_of(run, mesh);

  Exported exported;
  for (std::size_t i = 0; i < data.omega.size(); ++i) {
    if (!data.shard.holds(i)) continue;
    ++exported.planned;
    if (run.has_frequency(i))
      static_cast<void>(run.frequency(i));
    else if (run.failure(i).empty())
      exported.missing.push_back(data.omega[i]);
  }
  exported.seas_missing = run.wants_seas() && !run.finished_seas();
  const bool spectra = std::filesystem::exists(directory / NodeSpectraFile::kName);
  exported.node_spectra_missing = data.node_spectra && !seas.empty() && !spectra;

  // Make everything anew
  Products products(directory, Json::parse(run.manifest_text()).at("options"), data, mesh,
                    std::move(account));
  products.list(product_names(data.route));
  products.list(records_in(directory));
  products.list({kManifest});
  if (data.node_spectra && spectra) products.list({NodeSpectraFile::kName});
  if (modes) products.modes(*modes);
  for (std::size_t i = 0; i < data.omega.size(); ++i)
    if (const auto tried = run.tried_frequency(i, modes ? modes->count() : 0))
      products.frequency(*tried);
  exported.unsolved = describe_unsolved(products.account.frequencies);
  if (const std::optional<SeaGridReport> grid = run.finished_seas()) {
    for (const SeaResult& sea : seas) products.sea(sea);
    products.end_seas(*grid);
  }
  products.end(status_of(run, exported));
  exported.files = products.account.files;
  return exported;
}

}  // namespace floe::io
