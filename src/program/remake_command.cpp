#include "program/commands.hpp"

#include <floe/io/export.hpp>
#include <floe/io/merge.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace floe::program {
namespace {

// "0.4, 0.5, … (12)": the first few, and how many where there are more
std::string list_frequencies(const std::vector<double>& omega) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, omega.size()); ++i)
    text += fmt::format("{}{:.4g}", i > 0 ? ", " : "", omega[i]);
  return omega.size() > kShown ? text + ", …" : text;
}

std::string describe_missing(const io::Exported& exported) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (!exported.unsolved.empty()) add(exported.unsolved);
  if (!exported.missing.empty())
    add(fmt::format("{} of {} frequencies are not solved: {} rad/s", exported.missing.size(),
                    exported.planned, list_frequencies(exported.missing)));
  if (exported.seas_missing) add(text.empty() ? "the seas are not done" : "nor are the seas");
  return text;
}

void tell_files(const std::filesystem::path& directory, const io::Exported& exported) {
  Account account(ProgressStyle::kPlain);
  account.fact("results", fmt::format("{}/ ({})", directory.string(),
                                      counted(static_cast<Index>(exported.files.size()), "file")));
}

}  // namespace

void export_results(const ExportOptions& options) {
  if (options.format.empty())
    remake_products(options.directory);
  else
    export_for_others(options);
}

void remake_products(const std::filesystem::path& directory) {
  const io::Exported exported = io::export_run(directory);
  tell_files(directory, exported);
  if (!exported.complete())
    print(fmt::format("note       {} (floe run --resume goes on)\n", describe_missing(exported)));
  if (exported.node_spectra_missing)
    print("note       node_spectra.nc is not there (floe run --resume makes it)\n");
}

void merge_results(const MergeOptions& options) {
  const io::Exported merged =
      io::merge_runs(options.parts, options.output,
                     options.fresh ? io::Existing::kReplace : io::Existing::kRefuse);
  tell_files(options.output, merged);
  if (!merged.complete())
    throw ConvergenceError(
        fmt::format("{} (the parts that are there are merged; floe run CASE.toml --resume -o {} "
                    "computes the rest)",
                    describe_missing(merged), options.output.string()));
}

}  // namespace floe::program
