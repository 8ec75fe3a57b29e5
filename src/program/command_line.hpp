#pragma once

namespace floe::program {

/// The program: reads the command line, runs the command, tells errors as
/// `floe: error: what = value unit (what is required)` and returns the exit code.
int run_command_line(int argc, char** argv);

}  // namespace floe::program
