#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace floe::program {

/// Adds `floe mesh` and a command below it for each shape; the chosen one puts what it does into
/// `action`, which must outlive `app`.
void add_mesh_commands(CLI::App& app, std::function<void()>& action);

}  // namespace floe::program
