#pragma once

namespace floe::program {

/// Thrown where a run can stop cleanly after SIGINT or SIGTERM.
struct Interrupted {
  int signal = 0;
};

/// From here on SIGINT and SIGTERM ask for a clean stop; a second one leaves at once
/// (within 0.2 s it counts as the same). SIGPIPE and
/// SIGXFSZ are ignored, so that writing reports the error. Standard streams that are closed are
/// opened on /dev/null, so that no result file takes their number.
void prepare_process();

/// Throws Interrupted when a stop was asked for.
void stop_if_asked();

}  // namespace floe::program
