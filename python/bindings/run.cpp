#include "bindings.hpp"

#include <floe/io/case_file.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/numeric/blas_threads.hpp>
#include <floe/numeric/error.hpp>

#include <omp.h>
#include <pybind11/stl/filesystem.h>

namespace floe::python {
namespace {

// Lets Python act on Ctrl-C; called without the interpreter's lock
void stop_if_asked() {
  const py::gil_scoped_acquire held;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

// Warnings are kept, progress goes to a callable or nowhere
class CallingLog final : public Log {
 public:
  CallingLog(RunResults& results, const py::object& progress)
      : results_(results), progress_(progress) {}
  void info(const std::string&) override {}
  void notice(const std::string& text) override { results_.notices.push_back(text); }
  void warning(const std::string& text) override { results_.warnings.push_back(text); }
  void progress(double share, const std::string& now) override {
    {
      const py::gil_scoped_acquire held;
      if (!progress_.is_none()) progress_(share, now);
    }
    stop_if_asked();
  }
  void pause() override { stop_if_asked(); }

 private:
  RunResults& results_;         // view
  const py::object& progress_;  // view
};

// Keeps results in memory and, where wanted, in a directory; stops between two units when asked to
class BothStores final : public Store {
 public:
  BothStores(RunResults& results, io::DirectoryStore* directory)
      : memory_(results), directory_(directory) {}

  std::optional<plate::DryModes> known_modes() override {
    return directory_ ? directory_->known_modes() : std::nullopt;
  }
  std::optional<FrequencyResult> known_frequency(std::size_t place) override {
    return directory_ ? directory_->known_frequency(place) : std::nullopt;
  }
  std::optional<SeaGridReport> known_sea_grid() override {
    return directory_ ? directory_->known_sea_grid() : std::nullopt;
  }
  SeaTransfer known_transfer(std::size_t place) override {
    return directory_->known_transfer(place);
  }
  SeaObservation known_observation() override { return directory_->known_observation(); }

  void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) override {
    tell(&Store::begin, data, mesh, plan);
  }
  void modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) override {
    tell(&Store::modes, modes, mesh);
  }
  void frequency(const FrequencyResult& result) override { tell(&Store::frequency, result); }
  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned) override {
    tell(&Store::begin_seas, observation, planned);
  }
  void sea_transfer(const SeaTransfer& transfer) override { tell(&Store::sea_transfer, transfer); }
  // NOTE: a file of its own in the directory; too large to keep in memory
  void node_spectrum(std::size_t result, std::size_t frequency, const VecXd& spectrum) override {
    if (directory_) directory_->node_spectrum(result, frequency, spectrum);
  }
  void sea(const SeaResult& result) override { tell(&Store::sea, result); }
  void end_seas(const SeaGridReport& grid) override { tell(&Store::end_seas, grid); }
  void finish(const std::vector<StageTime>& times) override {
    memory_.finish(times);
    if (directory_) directory_->finish(times);
    finished_ = true;
  }
  bool finished() const { return finished_; }

 private:
  template <typename Call, typename... Given>
  void tell(Call call, const Given&... given) {
    if (directory_) (directory_->*call)(given...);
    (memory_.*call)(given...);
    stop_if_asked();
  }

  MemoryStore memory_;
  io::DirectoryStore* directory_;  // view, null: none
  bool finished_ = false;
};

class KeptThreads {
 public:
  explicit KeptThreads(int threads) : before_(omp_get_max_threads()) {
    if (threads > 0) omp_set_num_threads(threads);
  }
  ~KeptThreads() { omp_set_num_threads(before_); }
  KeptThreads(const KeptThreads&) = delete;
  KeptThreads& operator=(const KeptThreads&) = delete;

 private:
  int before_;
  numeric::KeptBlasThreads blas_;
};

io::Existing existing_of(bool resume, bool fresh) {
  FLOE_VALIDATE(!(resume && fresh), "ambiguous resume and fresh (give one of them)");
  return fresh ? io::Existing::kReplace : resume ? io::Existing::kResume : io::Existing::kRefuse;
}

// What was found out before an exception stays in the directory. Returns what could not be solved
// where the run came to its end all the same
std::string analyse_into(const Case& data, Log& log, RunResults& results,
                         io::DirectoryStore* directory) {
  BothStores stores(results, directory);
  try {
    analyse(data, log, stores);
  } catch (const ConvergenceError& error) {
    if (stores.finished()) return error.what();
    if (directory) directory->stop(error.what());
    throw;
  } catch (const std::exception& error) {
    if (directory) directory->stop(error.what());
    throw;
  }
  return "";
}

py::dict run(const io::CaseFile& file, const std::optional<std::filesystem::path>& output,
             int threads, double memory, bool resume, bool fresh, bool allow_coarse,
             const py::object& progress) {
  RunResults results;
  results.notices = file.notices;
  results.warnings = file.warnings;
  Case data = file.data;
  data.allow_coarse = allow_coarse;
  data.memory_limit = memory;
  std::string failure;
  {
    const py::gil_scoped_release released;
    const KeptThreads kept(threads);
    CallingLog log(results, progress);
    std::optional<io::DirectoryStore> directory;
    if (output) directory.emplace(*output, existing_of(resume, fresh));
    if (directory) data.plan_memory = directory->earlier_plan_memory();
    failure = analyse_into(data, log, results, directory ? &*directory : nullptr);
    if (directory)
      for (const std::string& damaged : directory->damaged_records())
        log.warning(damaged + " (computed again)");
  }
  py::dict fields = dictionary_of(results);
  fields["failure"] = failure;
  return fields;
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<io::CaseFile>(module, "CaseFile", "A case that was read and checked.");
  module.def(
      "read_case", [](const std::filesystem::path& path) { return io::read_case(path); },
      py::arg("path"), "Reads a case file.");
  module.def(
      "read_case_text",
      [](const std::string& text, const std::string& name, const std::filesystem::path& folder) {
        return io::read_case_text(text, name, folder);
      },
      py::arg("text"), py::arg("name"), py::arg("folder"), "Reads a case from its text.");
  module.def("run", &run, py::arg("case"), py::arg("output"), py::arg("threads"), py::arg("memory"),
             py::arg("resume"), py::arg("fresh"), py::arg("allow_coarse"), py::arg("progress"),
             "The fields of floe.Result, and `failure`: what could not be solved, or \"\".");
  module.def(
      "load",
      [](const std::filesystem::path& directory) {
        return dictionary_of(io::StoredRun(directory).results());
      },
      py::arg("directory"), "The fields of floe.Result, of a stored run.");
}

}  // namespace floe::python
