#pragma once

#include <floe/analysis.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// `records/manifest.json`: of which case the records of a directory are.
namespace floe::io {

/// The manifest of a run that begins.
nlohmann::ordered_json make_manifest(const Case& data, const std::string& mesh_hash);

/// What a run can do where the manifest is of no use, and what other commands can.
inline const std::string kAdviceToRun =
    " (give --fresh to replace the results, or another directory with -o)";
inline const std::string kAdviceToRead = " (give the directory of a run, or run the case again)";

/// Throws StoreError with the advice when it is missing, damaged, or of a newer floe.
nlohmann::ordered_json read_manifest(const std::filesystem::path& directory,
                                     const std::string& advice = kAdviceToRun);

void write_manifest(const std::filesystem::path& directory, const nlohmann::ordered_json& manifest);

/// What decides a result, as text: two cases with the same have the same records. Title, parts of a
/// sweep and which floe it was are left out.
std::string identity_of(const nlohmann::ordered_json& manifest);

/// "/options/plate/thickness, /mesh_hash": in what two runs differ; "" for the same case. Parts of
/// a sweep are compared too.
std::string differing_keys(const nlohmann::ordered_json& earlier,
                           const nlohmann::ordered_json& later);

/// Files that a run with this manifest may have made, for where its account is lost.
std::vector<std::string> files_of_manifest(const std::filesystem::path& directory);

}  // namespace floe::io
