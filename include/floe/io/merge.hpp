#pragma once

#include <floe/io/directory_store.hpp>
#include <floe/io/export.hpp>

#include <filesystem>
#include <vector>

namespace floe::io {

/// Puts the parts of a sweep (`floe run --shard`) together: copies their records to `output` and
/// makes the products. Parts may overlap where they are equal. Throws StoreError when parts are of
/// different cases, a record is damaged, or overlapping records differ, and as DirectoryStore;
/// nothing is left in `output` then.
Exported merge_runs(const std::vector<std::filesystem::path>& parts,
                    const std::filesystem::path& output, Existing existing);

}  // namespace floe::io
