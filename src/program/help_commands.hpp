#pragma once

#include <CLI/CLI.hpp>

#include <functional>

/// Commands that help to begin: they solve nothing and look at no results.
namespace floe::program {

/// `floe init`; what it does goes into `action`.
void add_init(CLI::App& app, std::function<void()>& action);

/// `floe man` and `floe completion`, which print what the parser knows.
void add_documents(CLI::App& app, std::function<void()>& action);

}  // namespace floe::program
