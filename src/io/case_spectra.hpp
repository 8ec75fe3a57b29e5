#pragma once

#include "io/toml_section.hpp"

#include <floe/wave/spectrum.hpp>
#include <floe/wave/spreading.hpp>

#include <string>
#include <vector>

/// Spectrum and spreading as the sections of seas describe them.
namespace floe::io {

/// The keys that `read_spectrum` and `read_spreading` know.
const std::vector<std::string>& spectrum_keys();
const std::vector<std::string>& spreading_keys();

/// S(ω) under the keys of a section, refused with the place when a key is missing, wrong, or
/// belongs to another kind of spectrum.
wave::Spectrum read_spectrum(const Section& sea);
/// D(θ) likewise.
wave::Spreading read_spreading(const Section& sea);

/// What was read, in words: "jonswap (significant_height = 3, …)", "cos2s s = 10".
std::string spectrum_words(const Section& sea, const wave::Spectrum& spectrum);
std::string spreading_words(const Section& sea);

/// One of a few names under a key; what is not given or unknown is refused with the nearest.
std::string chosen_name(const Section& section, const std::string& key,
                        const std::vector<std::string>& names);

/// Refuses those of the keys `all` that are given but not among `used`: with `key` = `chosen` they
/// would be silently without effect.
void refuse_keys_of_others(const Section& section, const std::string& key,
                           const std::string& chosen, const std::vector<std::string>& all,
                           const std::vector<std::string>& used);

/// What a peak enhancement γ must be.
NumberRule gamma_rule();

}  // namespace floe::io
