#include "program/commands.hpp"
#include "program/exit_code.hpp"

#include <floe/io/interchange.hpp>

#include <fmt/format.h>

namespace floe::program {

void export_for_others(const ExportOptions& options) {
  const io::StoredRun run(options.directory);
  const bool wamit = options.format == "wamit";
  const plate::DofSet dofs = options.all_dofs              ? plate::DofSet::kSixAndElastic
                             : options.rigid_only || wamit ? plate::DofSet::kSixRigid
                                                           : plate::DofSet::kPlate;
  std::vector<std::filesystem::path> files;
  if (wamit) {
    const std::filesystem::path stem =
        options.output.empty() ? options.directory / "result" : options.output;
    files = io::write_wamit(run, stem, dofs, options.length);
  } else {
    const char* name = dofs == plate::DofSet::kPlate      ? "result.nc"
                       : dofs == plate::DofSet::kSixRigid ? "result_rigid.nc"
                                                          : "result_all.nc";
    files = {options.output.empty() ? options.directory / name : options.output};
    io::write_netcdf(run, files.front(), dofs);
  }
  for (const std::filesystem::path& file : files) print(file.string() + "\n");
}

}  // namespace floe::program
