#pragma once

namespace floe::program {

/// From here on the program does not end without a line and one of its exit codes, whatever ends
/// it: an exception that cannot reach `main`, such as memory that is missing in the midst of
/// threads; a fault of memory or arithmetic; a library that calls exit(), as HDF5 does when an
/// allocation fails. What was stored is on the disk.
void install_last_words();

/// The program is about to end of itself.
void end_in_peace();

}  // namespace floe::program
