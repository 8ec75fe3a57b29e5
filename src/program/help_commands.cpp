#include "program/help_commands.hpp"

#include "program/commands.hpp"
#include "program/completion.hpp"
#include "program/man_page.hpp"
#include "program/option_checks.hpp"

#include <limits>
#include <memory>

namespace floe::program {

void add_init(CLI::App& app, std::function<void()>& action) {
  constexpr double kTiny = 1e-6, kInfinity = std::numeric_limits<double>::infinity();
  CLI::App& command = *app.add_subcommand("init", "write a commented case file");
  const auto options = std::make_shared<InitOptions>();
  command.add_option("case", options->case_file, "file to write; it must not be there yet")
      ->required()
      ->type_name("CASE.toml");
  CLI::Option* mesh =
      command.add_option("--mesh", options->mesh, "Gmsh mesh of the plate (default: a rectangle)")
          ->type_name("FILE.msh");
  const auto size = [&](const char* name, double& value, const char* about) {
    return command.add_option(name, value, about)
        ->type_name("METRES")
        ->check(between(name, "1e-6 to 1e6", kTiny, 1e6));
  };
  size("--length", options->length, "extent of the rectangle in x (default: 300)")->excludes(mesh);
  size("--width", options->width, "extent of the rectangle in y (default: 60)")->excludes(mesh);
  size("--thickness", options->thickness, "of the plate (default: 2)");
  command.add_option("--depth", options->depth, "of the water, or inf (default: 58.5)")
      ->type_name("METRES")
      ->check(between("--depth", "positive or inf", kTiny, kInfinity));
  command
      .add_option("--sea", options->sea,
                  "a sea: significant height [m] and period [s] (Bretschneider, cos² spreading)")
      ->type_name("HEIGHT PERIOD")
      ->expected(2)
      ->check(between("--sea", "a height in m and a period in s", kTiny, 1000.0));
  command
      .add_option("--heading", options->heading_deg,
                  "where waves travel to, from +x towards +y [deg] (default: 0 45 90)")
      ->type_name("DEGREES")
      ->expected(1, 360)
      ->check(between("--heading", "-360 to 360", -360.0, 360.0));
  command.callback([&action, options] { action = [options] { make_new_case(*options); }; });
}

void add_documents(CLI::App& app, std::function<void()>& action) {
  CLI::App& man = *app.add_subcommand("man", "print the manual page; floe man | man -l -");
  man.callback([&app, &action] {
    action = [&app] { print(man_page(describe_commands(app), FLOE_VERSION)); };
  });
  CLI::App& completion =
      *app.add_subcommand("completion", "print a script that completes commands in a shell");
  const auto shell = std::make_shared<std::string>();
  completion.add_option("shell", *shell, "which shell")
      ->required()
      ->type_name("bash|zsh|fish")
      ->check(one_of("shell", "bash, zsh or fish", [](const std::string& text) {
        return text == "bash" || text == "zsh" || text == "fish";
      }));
  completion.callback([&app, &action, shell] {
    action = [&app, shell] {
      const Command top = describe_commands(app);
      print(*shell == "bash"  ? bash_completion(top)
            : *shell == "zsh" ? zsh_completion(top)
                              : fish_completion(top));
    };
  });
}

}  // namespace floe::program
