#include "io/case_json.hpp"
#include "io/csv_table.hpp"
#include "io/output_directory.hpp"
#include "io/run_json.hpp"

#include <floe/io/study_store.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <cmath>

namespace floe::io {
namespace {

const std::vector<std::string>& table_names() {
  static const std::vector<std::string> names = {"convergence.csv", "convergence_summary.csv"};
  return names;
}

std::vector<std::string> comments(const Case& data, const ConvergenceStudy& study,
                                  const std::string& what) {
  std::vector<std::string> lines = {what};
  if (!data.title.empty()) lines.push_back(data.title);
  const std::string modes =
      data.route == SolverRoute::kDirect
          ? ", without modes"
          : fmt::format(" with {} modes, the first also with {}", study.modes, study.more_modes);
  lines.push_back(fmt::format("meshes of {}, {} and {} nodes{}", study.nodes.at(0),
                              study.nodes.at(1), study.nodes.at(2), modes));
  return lines;
}

void write_answers(const std::filesystem::path& folder, const Case& data,
                   const ConvergenceStudy& study) {
  CsvTable table(folder / "convergence.csv",
                 comments(data, study,
                          "answers of the case's own mesh and modes, extrapolated to infinitely "
                          "fine elements, and their errors"),
                 {"omega", "heading_deg", "point", "quantity", "re", "im", "abs", "extrapolated_re",
                  "extrapolated_im", "extrapolated_abs", "mesh_error", "mode_error", "error"});
  for (const StudiedAnswer& answer : study.answers) {
    table << answer.omega << answer.heading_deg << answer.point << response::name(answer.quantity)
          << answer.value << answer.extrapolated << answer.mesh_error << answer.mode_error
          << answer.mesh_error + answer.mode_error;
    table.end_row();
  }
  table.commit();
}

void write_summary(const std::filesystem::path& folder, const Case& data,
                   const ConvergenceStudy& study) {
  CsvTable table(
      folder / "convergence_summary.csv",
      comments(data, study,
               "largest error of each quantity, relative to its largest magnitude; order "
               "0: the answers do not settle"),
      {"omega", "quantity", "largest", "order", "mesh_error", "mode_error", "error"});
  for (const StudiedGroup& group : study.groups) {
    table << group.omega << response::name(group.quantity) << group.largest << group.order
          << group.mesh_error << group.mode_error << group.mesh_error + group.mode_error;
    table.end_row();
  }
  table.commit();
}

}  // namespace

ConvergenceStudy store_study(
    const std::filesystem::path& directory, Existing existing, const Case& data,
    const std::function<ConvergenceStudy(const std::filesystem::path&)>& study) {
  // Claim the directory, with an account that lists all that will be in it
  OutputDirectory output(directory, existing);
  if (!std::filesystem::exists(output.path() / "run.json"))
    for (const std::string& name : table_names())
      FLOE_VALIDATE_AS(StoreError, !std::filesystem::exists(output.path() / name),
                       output.path().string()
                           << " holds a file " << name
                           << " of something else (remove it, or give another directory with -o)");
  output.clear_earlier_run();
  RunAccount account;
  account.status = "running";
  account.files = table_names();
  for (const std::string& mesh : study_meshes(data)) account.files.push_back(mesh);
  account.files.emplace_back("run.json");
  write_file(output.path() / "run.json", run_json(case_json(data), account));

  // Compute, and leave nothing behind where that fails
  try {
    ConvergenceStudy result = study(output.path());
    write_answers(output.path(), data, result);
    write_summary(output.path(), data, result);
    account.status = "complete";
    account.nodes = result.nodes.front();
    write_file(output.path() / "run.json", run_json(case_json(data), account));
    return result;
  } catch (...) {
    output.remove(account.files);
    throw;
  }
}

}  // namespace floe::io
