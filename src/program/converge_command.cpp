#include "program/commands.hpp"
#include "program/exit_code.hpp"

#include <floe/convergence_study.hpp>
#include <floe/io/study_store.hpp>
#include <floe/numeric/blas_check.hpp>

#include <fmt/format.h>

#include <chrono>

namespace floe::program {
namespace {

void tell_groups(const ConvergenceStudy& study, Account& account) {
  account.info("\n   omega  quantity               largest   order  error of    error of  error");
  account.info("   rad/s                                          the mesh   the modes");
  bool settled = true;
  for (const StudiedGroup& group : study.groups) {
    settled = settled && group.order > 0.0;
    account.info(fmt::format("{:8.4g}  {:<18}  {:>10.4g}  {:>6}  {:8.2g}  {:10.2g}  {:.2g}",
                             group.omega, response::name(group.quantity), group.largest,
                             group.order > 0.0 ? fmt::format("{:.2f}", group.order) : "-",
                             group.mesh_error, group.mode_error,
                             group.mesh_error + group.mode_error));
  }
  account.info("");
  if (!settled)
    account.warning(
        "where the order is -, the answers do not settle from mesh to mesh: refine the mesh, or "
        "move points away from corners");
}

}  // namespace

void tell_convergence(const RunOptions& options) {
  // Read the case and claim the output directory before anything is computed
  const auto start = std::chrono::steady_clock::now();
  Account account(options.progress);
  const Case data = read_case_for(options, account);
  use_threads(options.threads, account);
  numeric::require_working_blas();
  const std::filesystem::path output = options.output.empty()
                                           ? options.case_file.stem().string() + ".convergence"
                                           : options.output.string();

  // Solve on every mesh and tell what that gives
  const ConvergenceStudy study =
      io::store_study(output, options.fresh ? io::Existing::kReplace : io::Existing::kRefuse, data,
                      [&](const std::filesystem::path& folder) {
                        return study_convergence(data, folder, account);
                      });
  tell_groups(study, account);
  account.show_warnings();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  account.fact("results", fmt::format("{}/convergence.csv, convergence_summary.csv and the finer "
                                      "meshes",
                                      output.string()));
  account.fact("done", format_duration(elapsed.count()));
}

}  // namespace floe::program
