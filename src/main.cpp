#include "program/command_line.hpp"
#include "program/last_words.hpp"

int main(int argc, char** argv) {
  floe::program::install_last_words();
  const int code = floe::program::run_command_line(argc, argv);
  floe::program::end_in_peace();
  return code;
}
