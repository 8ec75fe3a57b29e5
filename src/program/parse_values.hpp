#pragma once

#include <floe/analysis.hpp>

#include <string>

/// Values of flags. What is wrong throws UsageError with the flag's name.
namespace floe::program {

/// "16G" in bytes; K, M, G, T are powers of 1024.
double parse_bytes(const std::string& text);

/// "2h" in seconds; s, m, h.
double parse_time(const std::string& text);

/// "3/40", a part of a sweep.
Shard parse_shard(const std::string& text);

}  // namespace floe::program
