#include "io/atomic_file.hpp"
#include "io/case_json.hpp"
#include "io/manifest.hpp"
#include "io/output_directory.hpp"
#include "io/products.hpp"
#include "io/record_names.hpp"
#include "io/record_store.hpp"
#include "io/result_records.hpp"

#include <floe/disk_estimate.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <optional>

namespace floe::io {

class DirectoryStore::Impl {
 public:
  Impl(const std::filesystem::path& path, Existing existing)
      : directory(path, existing, "--resume to go on with it, --fresh to replace it"),
        resume_(existing == Existing::kResume) {}

  void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan);
  void modes(const plate::DryModes& dry, const mesh::Q8Mesh& mesh);
  void frequency(const FrequencyResult& result);
  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned);
  void sea_sample(int number, const FluidSample& sample);
  void sea_march(const SeaMarch& march);
  void sea_transfer(const SeaTransfer& transfer);
  void node_spectrum(std::size_t result, std::size_t frequency, const VecXd& spectrum) {
    products->node_spectrum(result, frequency, spectrum);
  }
  void sea(const SeaResult& result);
  void end_seas(const SeaGridReport& grid);
  void finish(const std::vector<StageTime>& times);
  void stop(const std::string& status);

  double earlier_plan_memory() const;
  bool knows_transfers(std::size_t count);
  std::optional<SeaMarch> known_march();

  OutputDirectory directory;
  std::optional<RecordStore> records;  // from `begin` on
  std::optional<Products> products;    // likewise
  const std::vector<std::string> nothing;

 private:
  void claim(const nlohmann::ordered_json& manifest, double needed);
  std::size_t place_of(double omega) const;
  void drop_samples(const std::vector<int>& kept);
  void end(const std::string& status);

  bool resume_, finished_ = false;
  Case data_;
  const mesh::Q8Mesh* mesh_ = nullptr;    // view, until the end
  std::size_t transfers_ = 0, seas_ = 0;  // stored so far
};

void DirectoryStore::Impl::begin(const Case& given, const mesh::Q8Mesh& mesh,
                                 const Estimate& plan) {
  data_ = given;
  mesh_ = &mesh;
  RunAccount account = describe_run(given, mesh, plan);
  const nlohmann::ordered_json manifest = make_manifest(given, account.mesh_hash);
  claim(manifest, estimate_disk(given, mesh));
  if (resume_) account.seconds_before = seconds_of_run(directory.path() / "run.json");

  // The account first, so that every file of the run is listed before it is there
  std::vector<std::string>& files = account.files;
  files.insert(files.end(), {kManifest, kFluidMesh, kModeMesh});
  if (data_.route == SolverRoute::kModal) files.push_back(kModes);
  for (std::size_t i = 0; i < data_.omega.size(); ++i)
    if (data_.shard.holds(i)) files.push_back(numbered_record("frequency", i));
  const std::vector<std::string> earlier = records_in(directory.path());
  for (const std::string& name : earlier)
    if (std::find(files.begin(), files.end(), name) == files.end()) files.push_back(name);
  products.emplace(directory.path(), case_json(given), given, mesh, std::move(account));
  make_folder(directory.path() / kRecords);
  write_manifest(directory.path(), manifest);
  records.emplace(directory.path(), identity_of(manifest),
                  resume_ ? Earlier::kUse : Earlier::kIgnore);
  if (!records->knows(kFluidMesh)) records->store(kFluidMesh, record_of(mesh));
}

// Takes over or clears away what is there, once nothing speaks against it
void DirectoryStore::Impl::claim(const nlohmann::ordered_json& manifest, double needed) {
  resume_ = resume_ && std::filesystem::exists(directory.path() / kManifest);
  const std::string differing =
      resume_ ? differing_keys(read_manifest(directory.path()), manifest) : "";
  FLOE_VALIDATE_AS(StoreError, differing.empty(),
                   directory.path().string()
                       << " holds results of another case: " << differing
                       << " differ (give --fresh to replace them, or another directory with -o)");
  require_disk(needed, directory.free_space() + directory.record_size(), directory.path().string());
  if (resume_)
    directory.clear_leftovers();
  else
    directory.clear_earlier_run();
}

void DirectoryStore::Impl::modes(const plate::DryModes& dry, const mesh::Q8Mesh& mode_mesh) {
  records->store(kModes, record_of(dry));
  if (&mode_mesh != mesh_ && !records->knows(kModeMesh))
    records->store(kModeMesh, record_of(mode_mesh));
  products->modes(dry);
}

std::size_t DirectoryStore::Impl::place_of(double omega) const {
  const auto at = std::find(data_.omega.begin(), data_.omega.end(), omega);
  return static_cast<std::size_t>(at - data_.omega.begin());
}

// The record first: what was solved is kept even where a table cannot be
void DirectoryStore::Impl::frequency(const FrequencyResult& result) {
  const std::size_t place = place_of(result.omega);
  const std::string failure = numbered_record("failure", place);
  if (result.report.failure.empty()) {
    records->store(numbered_record("frequency", place), record_of(result));
    records->remove({failure});  // of an earlier run
    products->unlist({failure});
  } else {
    products->list({failure});
    records->replace(failure, record_of_failure(result.report));
  }
  products->frequency(result);
}

void DirectoryStore::Impl::begin_seas(const SeaObservation& observation,
                                      const SeaGridReport& planned) {
  std::vector<std::string> names = {kObservation, kSeaGrid, kSeaMarch};
  for (std::size_t i = 0; i < planned.omega.size(); ++i)
    names.push_back(numbered_record("transfer", i));
  for (std::size_t s = 0, i = 0; s < data_.seas.size(); ++s)
    for (std::size_t m = 0; m < data_.seas[s].mean_heading_deg.size(); ++m, ++i)
      names.push_back(numbered_record("sea", i));
  products->list(names);
  products->begin_seas(data_.seas, planned.omega);
  records->store(kObservation, record_of(observation, planned));
}

void DirectoryStore::Impl::sea_sample(int number, const FluidSample& sample) {
  const std::string name = numbered_record("sample", static_cast<std::size_t>(number));
  products->list({name});
  records->store(name, record_of(sample));
}

// What the march no longer needs goes once its new state is on the disk
void DirectoryStore::Impl::sea_march(const SeaMarch& march) {
  records->sync();
  records->replace(kSeaMarch, record_of(march));
  records->sync();
  drop_samples(march.samples);
}

void DirectoryStore::Impl::drop_samples(const std::vector<int>& kept) {
  std::vector<std::string> dropped;
  for (const std::string& name : records_in(directory.path())) {
    if (!name.starts_with(kRecords + "/sample_")) continue;
    const bool needed = std::any_of(kept.begin(), kept.end(), [&](int number) {
      return numbered_record("sample", static_cast<std::size_t>(number)) == name;
    });
    if (!needed) dropped.push_back(name);
  }
  records->remove(dropped);
  products->unlist(dropped);
}

void DirectoryStore::Impl::sea_transfer(const SeaTransfer& transfer) {
  records->store(numbered_record("transfer", transfers_++), record_of(transfer));
}

void DirectoryStore::Impl::sea(const SeaResult& result) {
  records->store(numbered_record("sea", seas_++), record_of(result));
  products->sea(result);
}

void DirectoryStore::Impl::end_seas(const SeaGridReport& grid) {
  records->store(kSeaGrid, record_of(grid));
  records->sync();
  records->remove({kSeaMarch});
  products->unlist({kSeaMarch});
  drop_samples({});
  products->end_seas(grid);
}

double DirectoryStore::Impl::earlier_plan_memory() const {
  if (!resume_ || !std::filesystem::exists(directory.path() / kManifest)) return 0.0;
  return read_manifest(directory.path()).value("plan_memory", 0.0);
}

bool DirectoryStore::Impl::knows_transfers(std::size_t count) {
  bool all = records->known(kObservation, observation_from).has_value();
  for (std::size_t i = 0; all && i < count; ++i)
    all = records->known(numbered_record("transfer", i), transfer_from).has_value();
  return all;
}

std::optional<SeaMarch> DirectoryStore::Impl::known_march() {
  std::optional<SeaMarch> march = records->known(kSeaMarch, march_from);
  if (!march || !knows_transfers(march->next)) return std::nullopt;
  for (const int number : march->samples)
    if (!records->known(numbered_record("sample", static_cast<std::size_t>(number)), sample_from))
      return std::nullopt;
  return march;
}

void DirectoryStore::Impl::finish(const std::vector<StageTime>& times) {
  products->account.stages = times;
  end(products->unsolved() > 0 ? kFailed : "complete");
  finished_ = true;
}

void DirectoryStore::Impl::stop(const std::string& status) {
  mesh_ = nullptr;
  if (!products || finished_) return;
  if (records && (resume_ || !products->account.frequencies.empty())) {
    end(status);
    return;
  }
  const std::vector<std::string> files = products->account.files;
  products.reset();
  if (!resume_) directory.remove(files);
}

void DirectoryStore::Impl::end(const std::string& status) {
  mesh_ = nullptr;
  records->sync();
  products->list(records->set_aside_files());
  products->end(status);
}

DirectoryStore::DirectoryStore(const std::filesystem::path& directory, Existing existing)
    : impl_(std::make_unique<Impl>(directory, existing)) {}

DirectoryStore::~DirectoryStore() = default;

std::optional<plate::DryModes> DirectoryStore::known_modes() {
  return impl_->records->known(kModes, modes_from);
}

std::optional<FrequencyResult> DirectoryStore::known_frequency(std::size_t place) {
  return impl_->records->known(numbered_record("frequency", place), frequency_from);
}

std::optional<SeaGridReport> DirectoryStore::known_sea_grid() {
  std::optional<SeaGridReport> grid = impl_->records->known(kSeaGrid, finished_grid_from);
  if (grid && !impl_->knows_transfers(grid->omega.size())) return std::nullopt;
  return grid;
}

SeaTransfer DirectoryStore::known_transfer(std::size_t place) {
  return transfer_from(Record::read(directory() / numbered_record("transfer", place)));
}

SeaObservation DirectoryStore::known_observation() {
  return observation_from(Record::read(directory() / kObservation));
}

std::optional<SeaMarch> DirectoryStore::known_sea_march() { return impl_->known_march(); }

std::optional<FluidSample> DirectoryStore::known_sea_sample(int number) {
  return impl_->records->known(numbered_record("sample", static_cast<std::size_t>(number)),
                               sample_from);
}

double DirectoryStore::earlier_plan_memory() const { return impl_->earlier_plan_memory(); }

bool DirectoryStore::locks() const { return impl_->directory.locks(); }

const std::vector<std::string>& DirectoryStore::damaged_records() const {
  return impl_->records ? impl_->records->damaged() : impl_->nothing;
}

const std::vector<SelfCheck>& DirectoryStore::checks() const {
  static const std::vector<SelfCheck> none;
  return impl_->products ? impl_->products->account.checks : none;
}

void DirectoryStore::begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) {
  impl_->begin(data, mesh, plan);
}

void DirectoryStore::modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) {
  impl_->modes(modes, mesh);
}

void DirectoryStore::frequency(const FrequencyResult& result) { impl_->frequency(result); }

void DirectoryStore::begin_seas(const SeaObservation& observation, const SeaGridReport& planned) {
  impl_->begin_seas(observation, planned);
}

void DirectoryStore::sea_sample(int number, const FluidSample& sample) {
  impl_->sea_sample(number, sample);
}

void DirectoryStore::sea_march(const SeaMarch& march) { impl_->sea_march(march); }

void DirectoryStore::sea_transfer(const SeaTransfer& transfer) { impl_->sea_transfer(transfer); }

void DirectoryStore::node_spectrum(std::size_t result, std::size_t frequency,
                                   const VecXd& spectrum) {
  impl_->node_spectrum(result, frequency, spectrum);
}

void DirectoryStore::sea(const SeaResult& result) { impl_->sea(result); }

void DirectoryStore::end_seas(const SeaGridReport& grid) { impl_->end_seas(grid); }

void DirectoryStore::finish(const std::vector<StageTime>& times) { impl_->finish(times); }

void DirectoryStore::stop(const std::string& status) { impl_->stop(status); }

const std::vector<std::string>& DirectoryStore::files() const {
  return impl_->products ? impl_->products->account.files : impl_->nothing;
}

const std::filesystem::path& DirectoryStore::directory() const { return impl_->directory.path(); }

}  // namespace floe::io
