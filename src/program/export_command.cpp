#include "program/commands.hpp"
#include "program/exit_code.hpp"
#include "program/replaceable.hpp"

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
  if (options.format == "paraview") {
    const std::filesystem::path folder =
        options.output.empty() ? options.directory / "paraview" : options.output;
    files = io::write_paraview(run, folder, options.paraview);
    print(fmt::format("{} ({})\n", folder.string(),
                      counted(static_cast<Index>(files.size()), "file")));
    return;
  }
  if (wamit) {
    const std::filesystem::path stem =
        options.output.empty() ? options.directory / "result" : options.output;
    for (const char* suffix : {".1", ".3", ".3fk", ".3sc", ".4", ".hst"})
      require_replaceable(stem.string() + suffix, "file of floe", {"# floe "});
    files = io::write_wamit(run, stem, dofs, options.length);
  } else {
    const char* name = dofs == plate::DofSet::kPlate      ? "result.nc"
                       : dofs == plate::DofSet::kSixRigid ? "result_rigid.nc"
                                                          : "result_all.nc";
    files = {options.output.empty() ? options.directory / name : options.output};
    require_replaceable(files.front(), "netCDF file", {"\x89HDF", "CDF"});
    io::write_netcdf(run, files.front(), dofs);
  }
  for (const std::filesystem::path& file : files) print(file.string() + "\n");
}

}  // namespace floe::program
