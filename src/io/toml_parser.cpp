#define TOML_IMPLEMENTATION
#include "io/toml_parser.hpp"
