#pragma once

namespace floe::program {

/// Thrown where a run can stop cleanly after SIGINT, SIGTERM or SIGHUP.
struct Interrupted {
  int signal = 0;
};

/// Thrown where a run can stop cleanly after --max-time, or after SIGUSR1, with which a batch
/// system says that the time is nearly over.
struct TimeUp {
  const char* by = "--max-time";
};

/// From here on SIGINT, SIGTERM, SIGHUP (unless it was ignored, as by nohup) and SIGUSR1 ask for a
/// clean stop and say so on standard error; a second one leaves at once (within 0.2 s it counts as
/// the same). SIGPIPE and SIGXFSZ are ignored, so that writing reports the error. Standard streams
/// that are closed are opened on /dev/null, so that no result file takes their number.
void prepare_process();

/// From here on `seconds` are left; later calls to stop_if_asked throw TimeUp.
void limit_time(double seconds);

/// Throws Interrupted when a stop was asked for, TimeUp when the time is over; `patience` seconds
/// later.
void stop_if_asked(double patience = 0.0);

}  // namespace floe::program
