#include "io/atomic_file.hpp"
#include "io/manifest.hpp"
#include "io/node_spectra_file.hpp"
#include "io/output_directory.hpp"
#include "io/record_names.hpp"
#include "io/record_store.hpp"
#include "io/result_records.hpp"
#include "io/run_json.hpp"

#include <floe/io/merge.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <set>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

struct Part {
  std::filesystem::path directory;
  Json manifest;  // without the shard
  std::vector<std::string> records;
};

std::vector<Part> read_parts(const std::vector<std::filesystem::path>& directories) {
  std::vector<Part> parts;
  for (const std::filesystem::path& directory : directories) {
    Part part{directory, read_manifest(directory, kAdviceToRead), {}};
    part.manifest.erase("shard");
    for (const std::string& name : records_in(directory))
      if (!name.starts_with(kBadRecords)) part.records.push_back(name);
    if (!parts.empty()) {
      const std::string differing = differing_keys(parts.front().manifest, part.manifest);
      FLOE_VALIDATE_AS(StoreError, differing.empty(),
                       directory.string() << " and " << parts.front().directory.string()
                                          << " are of different cases: " << differing
                                          << " differ (give the parts of one case)");
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// What is made with the seas and is in no record
bool has_node_spectra(const Part& part) {
  return part.manifest.at("options").at("output").value("node_spectra", false) &&
         std::filesystem::exists(part.directory / NodeSpectraFile::kName);
}

Record read_record(const Part& part, const std::string& name) {
  Record record = Record::read(part.directory / name);
  FLOE_VALIDATE_AS(StoreError, record.text(kKey) == record_key(identity_of(part.manifest), name),
                   "record " << (part.directory / name).string()
                             << " is not one of its manifest's case (floe run --resume computes it "
                                "again)");
  return record;
}

// Two parts that computed the same must have found the same
void require_equal(const Record& there, const Record& record, const Part& part,
                   const std::string& name) {
  FLOE_VALIDATE_AS(StoreError, there.same_as(record, {kSeconds, kProcessor}),
                   "record " << (part.directory / name).string()
                             << " differs from that of another part (parts must be computed by one "
                                "floe on processors of one kind)");
}

class Merging {
 public:
  Merging(const std::filesystem::path& output, Existing existing, const std::vector<Part>& parts)
      : directory_(output, existing) {
    directory_.clear_earlier_run();
    std::set<std::string> names = {"run.json", kManifest};
    for (const Part& part : parts) {
      names.insert(part.records.begin(), part.records.end());
      if (has_node_spectra(part)) names.insert(NodeSpectraFile::kName);
    }
    files_.assign(names.begin(), names.end());
  }

  void copy(const std::vector<Part>& parts) {
    RunAccount account;
    account.status = "merged, not complete";
    account.files = files_;
    write_file(directory_.path() / "run.json",
               run_json(parts.front().manifest.at("options"), account));
    make_folder(directory_.path() / kRecords);
    write_manifest(directory_.path(), parts.front().manifest);
    std::set<std::string> copied;
    for (const Part& part : parts)
      for (const std::string& name : part.records) {
        const Record record = read_record(part, name);
        if (copied.insert(name).second)
          record.write(directory_.path() / name);
        else
          require_equal(Record::read(directory_.path() / name), record, part, name);
      }
    for (const std::string& name : copied) sync_to_disk(directory_.path() / name);
    sync_to_disk(directory_.path() / kRecords);
    const auto with = std::find_if(parts.begin(), parts.end(), has_node_spectra);
    if (with != parts.end())
      copy_whole_file(with->directory / NodeSpectraFile::kName,
                      directory_.path() / NodeSpectraFile::kName);
  }

  void undo() { directory_.remove(files_); }

 private:
  OutputDirectory directory_;
  std::vector<std::string> files_;
};

}  // namespace

Exported merge_runs(const std::vector<std::filesystem::path>& directories,
                    const std::filesystem::path& output, Existing existing) {
  const std::vector<Part> parts = read_parts(directories);
  {
    Merging merging(output, existing, parts);
    try {
      merging.copy(parts);
    } catch (...) {
      merging.undo();
      throw;
    }
  }
  return export_run(output);
}

}  // namespace floe::io
