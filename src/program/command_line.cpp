#include "program/command_line.hpp"

#include "program/account.hpp"
#include "program/commands.hpp"
#include "program/exit_code.hpp"
#include "program/help_commands.hpp"
#include "program/mesh_command_line.hpp"
#include "program/option_checks.hpp"
#include "program/parse_errors.hpp"
#include "program/parse_values.hpp"
#include "program/signals.hpp"

#include <floe/io/case_file.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <sstream>

namespace floe::program {
namespace {

constexpr const char* kAbout =
    "floe: hydroelastic response of very large floating structures in waves.";
constexpr const char* kExamples = R"(
Examples:
  floe init plate.toml --mesh plate.msh --sea 2 6.3   a commented case file for a mesh and a sea
  floe check cases/table1.toml            what a run would need; solves nothing
  floe converge cases/table1.toml         how good the answers are on that mesh
  floe run cases/table1.toml              results go to table1.out/
  floe run plate.toml -o out --threads 8  another folder, eight threads
  floe run plate.toml --resume            go on after a stop, a kill or a power cut
  floe status plate.out                   how far it is
  floe report table1.out                  one page to look at: table1.out/report.html
  floe stats table1_seas.out --sea storm.toml   other seas, without solving again
  floe export table1.out --format netcdf --rigid-only   six motions, for other programs
  floe mesh rectangle --length 300 --width 60 --nx 50 --ny 10 -o plate.msh

Exit codes: 0 done, 2 command line, 3 case file, 4 mesh, 5 sea states, 6 memory, 7 files, 8 not converged,
  9 results there already, 10 folder in use, 75 stopped by --max-time,
  130/143 by a signal, 1 a fault of floe.)";

// What the parser fills in
struct Choice {
  RunOptions run;
  StatsOptions stats;
  ReportOptions report;
  StatusOptions status;
  ExportOptions exported;
  MergeOptions merge;
  std::string memory, max_time;
  std::function<void()> action;  // what the chosen command does
};

void add_case_flags(CLI::App& command, Choice& choice) {
  command.add_option("case", choice.run.case_file, "case file")->required()->type_name("CASE.toml");
  command.add_option("--threads", choice.run.threads, "threads to use, 1 … 1024")
      ->type_name("N")
      ->check(one_of("--threads", "1 to 1024", [](const std::string& text) {
        int value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        return error == std::errc() && end == text.data() + text.size() && value >= 1 &&
               value <= 1024;
      }));
  command
      .add_option("--memory", choice.memory,
                  "memory to stay below and to plan for, like 16G (else 12G are planned for)")
      ->type_name("BYTES");
  command.add_flag("--allow-coarse", choice.run.allow_coarse,
                   "go on with fewer than 2 nodes per wavelength");
}

void add_run(CLI::App& app, Choice& choice) {
  CLI::App& command = *app.add_subcommand("run", "run a case and store its results");
  add_case_flags(command, choice);
  const std::map<std::string, ProgressStyle> styles = {{"auto", ProgressStyle::kAuto},
                                                       {"plain", ProgressStyle::kPlain},
                                                       {"json", ProgressStyle::kJson},
                                                       {"none", ProgressStyle::kNone}};
  command.add_option("-o", choice.run.output, "result folder (default: the case's name + .out)")
      ->type_name("DIR")
      ->check(one_of("-o", "the name of a folder",
                     [](const std::string& text) { return !text.empty(); }));
  CLI::Option* fresh =
      command.add_flag("--fresh", choice.run.fresh, "replace the results of an earlier run");
  command
      .add_flag("--resume", choice.run.resume,
                "go on with an earlier run of the same case; what it finished is not solved again")
      ->excludes(fresh);
  command.add_option("--max-time", choice.max_time, "stop cleanly after this time, like 12h")
      ->type_name("TIME");
  command
      .add_option_function<std::string>(
          "--shard", [&choice](const std::string& text) { choice.run.shard = parse_shard(text); },
          "run part I of N: every N-th frequency; floe merge puts the parts together")
      ->type_name("I/N");
  command
      .add_option_function<std::string>(
          "--progress",
          [&choice, styles](const std::string& name) { choice.run.progress = styles.at(name); },
          "how progress is shown")
      ->type_name("auto|plain|json|none")
      ->check(one_of("--progress", "auto, plain, json or none",
                     [styles](const std::string& name) { return styles.contains(name); }));
  command.callback([&choice] { choice.action = [&choice] { run_case(choice.run); }; });
}

void add_check(CLI::App& app, Choice& choice) {
  CLI::App& command =
      *app.add_subcommand("check", "tell sizes, resolution, memory and time; solve nothing");
  add_case_flags(command, choice);
  command.callback([&choice] { choice.action = [&choice] { check_case(choice.run); }; });
}

void add_converge(CLI::App& app, Choice& choice) {
  CLI::App& command = *app.add_subcommand(
      "converge", "solve on finer meshes and with more modes; tell the error of the answers");
  add_case_flags(command, choice);
  command
      .add_option("-o", choice.run.output,
                  "result folder (default: the case's name + .convergence)")
      ->type_name("DIR");
  command.add_flag("--fresh", choice.run.fresh, "replace the results of an earlier study");
  command.callback([&choice] { choice.action = [&choice] { tell_convergence(choice.run); }; });
}

void add_stats(CLI::App& app, Choice& choice) {
  CLI::App& command = *app.add_subcommand(
      "stats", "statistics of new sea states from a run's transfer functions; solve nothing");
  command.add_option("directory", choice.stats.directory, "results of a run with seas")
      ->required()
      ->type_name("DIR");
  command.add_option("--sea", choice.stats.sea_file, "file with [[sea]] sections")
      ->required()
      ->type_name("SEA.toml");
  command
      .add_option("-o", choice.stats.output, "result folder (default: the sea file's name + .out)")
      ->type_name("DIR");
  command.add_flag("--fresh", choice.stats.fresh, "replace the results of an earlier run");
  command.callback([&choice] { choice.action = [&choice] { tell_statistics(choice.stats); }; });
}

void add_report(CLI::App& app, Choice& choice) {
  CLI::App& command =
      *app.add_subcommand("report", "write one HTML page that shows the results of a run");
  command.add_option("directory", choice.report.directory, "results of a run")
      ->required()
      ->type_name("DIR");
  command.add_option("-o", choice.report.output, "file to write (default: report.html in DIR)")
      ->type_name("FILE.html");
  command.callback([&choice] { choice.action = [&choice] { make_report(choice.report); }; });
}

void add_status(CLI::App& app, Choice& choice) {
  CLI::App& command = *app.add_subcommand(
      "status", "tell how far a run is and what is left; may be asked while it works");
  command.add_option("directory", choice.status.directory, "results of a run")
      ->required()
      ->type_name("DIR");
  command.add_flag("--json", choice.status.json, "as an object for programs");
  command.callback([&choice] { choice.action = [&choice] { tell_status(choice.status); }; });
}

void add_export(CLI::App& app, Choice& choice) {
  CLI::App& command = *app.add_subcommand(
      "export",
      "make all tables and fields of a run anew from its records, or files of other programs; "
      "solve nothing");
  ExportOptions& options = choice.exported;
  command.add_option("directory", options.directory, "results of a run")
      ->required()
      ->type_name("DIR");
  CLI::Option* format =
      command
          .add_option("--format", options.format,
                      "netcdf (as capytaine's), wamit or paraview: files of that kind only")
          ->type_name("netcdf|wamit|paraview")
          ->check(one_of("--format", "netcdf, wamit or paraview", [](const std::string& text) {
            return text == "netcdf" || text == "wamit" || text == "paraview";
          }));
  CLI::Option* rigid = command.add_flag("--rigid-only", options.rigid_only,
                                        "surge to yaw of each plate, no elastic modes");
  rigid->needs(format);
  command
      .add_flag("--all-dofs", options.all_dofs, "surge to yaw of each plate, then elastic modes")
      ->excludes(rigid)
      ->needs(format);
  command
      .add_option("--length", options.length, "length of WAMIT's normalisation [m] (default: 1)")
      ->needs(format)
      ->type_name("L");
  command
      .add_option("--phases", options.paraview.phases,
                  "paraview: moments of one period (default: 24)")
      ->needs(format)
      ->type_name("N");
  command
      .add_option("--margin", options.paraview.margin,
                  "paraview: width of the water around the plate [m] (default: 0)")
      ->needs(format)
      ->type_name("M");
  command
      .add_option("--step", options.paraview.step,
                  "paraview: distance of points of the water [m] (default: no water)")
      ->needs(format)
      ->type_name("M");
  command.add_option("-o", options.output, "file to write; for wamit without its suffix")
      ->needs(format)
      ->type_name("FILE");
  command.callback([&choice] { choice.action = [&choice] { export_results(choice.exported); }; });
}

void add_merge(CLI::App& app, Choice& choice) {
  CLI::App& command =
      *app.add_subcommand("merge", "put the parts of a sweep that ran with --shard together");
  command.add_option("directories", choice.merge.parts, "results of the parts")
      ->required()
      ->type_name("DIR");
  command.add_option("-o", choice.merge.output, "result folder")->required()->type_name("DIR");
  command.add_flag("--fresh", choice.merge.fresh, "replace the results that are there");
  command.callback([&choice] { choice.action = [&choice] { merge_results(choice.merge); }; });
}

// A first word that is no command gets the nearest one named
void refuse_unknown_command(const std::string& command, const CLI::App& app) {
  std::vector<std::string> known;
  for (const CLI::App* word : app.get_subcommands({})) known.push_back(word->get_name());
  if (command.empty() || command[0] == '-' ||
      std::find(known.begin(), known.end(), command) != known.end())
    return;
  const std::string nearest = io::nearest_name(command, known);
  throw UsageError(fmt::format(
      "unknown command {} ({})", command,
      nearest.empty() ? fmt::format("known are {}; floe --help tells more", fmt::join(known, ", "))
                      : "did you mean " + nearest + "?"));
}

int parse_and_run(int argc, char** argv) {
  Choice choice;
  CLI::App app(kAbout, "floe");
  app.set_version_flag("--version", "floe " FLOE_VERSION);
  app.require_subcommand(1);
  add_run(app, choice);
  add_check(app, choice);
  add_converge(app, choice);
  add_stats(app, choice);
  add_report(app, choice);
  add_status(app, choice);
  add_export(app, choice);
  add_merge(app, choice);
  add_mesh_commands(app, choice.action);
  add_init(app, choice.action);
  add_documents(app, choice.action);
  app.footer(kExamples);
  refuse_unknown_command(argc > 1 ? argv[1] : "", app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help, --version
    std::ostringstream text;
    app.exit(help, text, text);
    print(text.str());
    return kDone;
  } catch (const CLI::ParseError& error) {
    throw UsageError(explain(error, app));
  }
  if (!choice.max_time.empty()) choice.run.max_time = parse_time(choice.max_time);
  if (!choice.memory.empty()) choice.run.memory = parse_bytes(choice.memory);
  choice.action();
  return kDone;
}

// Programs that read the account as JSON get the error the same way
bool speaks_json(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") return false;
    if (word == "--progress=json") return true;
    if (word == "--progress" && i + 1 < argc && std::string(argv[i + 1]) == "json") return true;
  }
  return false;
}

}  // namespace

int run_command_line(int argc, char** argv) {
  try {
    prepare_process();
    return parse_and_run(argc, argv);
  } catch (...) {
    const Failure failure = describe(std::current_exception());
    if (speaks_json(argc, argv)) print_error_event(failure.code, failure.text);
    print_error(fmt::format("floe: error: {}\n", failure.text));
    return failure.code;
  }
}

}  // namespace floe::program
