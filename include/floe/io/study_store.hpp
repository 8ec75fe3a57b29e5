#pragma once

#include <floe/convergence_study.hpp>
#include <floe/io/directory_store.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace floe::io {

/// Results of `floe converge` in one directory: `convergence.csv` (one line an answer),
/// `convergence_summary.csv` (one line a frequency and quantity), the finer meshes, `run.json`.
/// `study` computes them, given the directory for the meshes; the directory is claimed before and
/// left as it was when it throws. Throws as DirectoryStore.
ConvergenceStudy store_study(
    const std::filesystem::path& directory, Existing existing, const Case& data,
    const std::function<ConvergenceStudy(const std::filesystem::path&)>& study);

}  // namespace floe::io
