#include "program/commands.hpp"
#include "program/exit_code.hpp"
#include "program/replaceable.hpp"

#include <floe/io/report.hpp>

#include <fmt/format.h>

namespace floe::program {

void make_report(const ReportOptions& options) {
  if (!io::report_available())
    throw UsageError("this floe was built without its report (configure with -DFLOE_REPORT=ON)");
  const io::StoredRun run(options.directory);
  const std::filesystem::path output =
      options.output.empty() ? options.directory / "report.html" : options.output;
  require_replaceable(output, "report", {"<!doctype html", "<!DOCTYPE html"});
  io::write_report(run, output);
  print(fmt::format("{}: open it in a browser ({:.1f} MB, no network needed)\n", output.string(),
                    static_cast<double>(std::filesystem::file_size(output)) / 1e6));
}

}  // namespace floe::program
