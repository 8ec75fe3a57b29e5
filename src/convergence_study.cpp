#include <floe/convergence_study.hpp>
#include <floe/mesh/gmsh.hpp>
#include <floe/mesh/refine.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace floe {
namespace {

constexpr int kMeshes = 3;
constexpr double kLargestOrder = 4.0;
// No mesh is told from another below this
constexpr double kTolerance = 1e-8;

// Keeps the answers at the points
class AnswerStore final : public Store {
 public:
  void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate&) override {
    data_ = data;
    nodes = mesh.node_count();
  }
  void modes(const plate::DryModes&, const mesh::Q8Mesh&) override {}
  void frequency(const FrequencyResult& result) override {
    for (std::size_t q = 0; q < data_.quantities.size(); ++q)
      values.push_back(result.point_quantities[q]);
  }
  void finish(const std::vector<StageTime>&) override {}

  Index nodes = 0;
  std::vector<MatXcd> values;  // frequencies, then quantities: points × headings

 private:
  Case data_;
};

// Passes everything on but warnings, which would be told four times, and the share done of a whole
class PartOfLog final : public Log {
 public:
  PartOfLog(Log& whole, int part, int parts) : whole_(whole), part_(part), parts_(parts) {}
  void info(const std::string& text) override { whole_.info(text); }
  void notice(const std::string& text) override {
    if (part_ == 0) whole_.notice(text);
  }
  void warning(const std::string& text) override {
    if (part_ == 0) whole_.warning(text);
  }
  void progress(double share, const std::string& now) override {
    whole_.progress((part_ + share) / parts_, now);
  }
  void pause() override { whole_.pause(); }

 private:
  Log& whole_;  // view
  int part_;
  int parts_;
};

std::string refined_name(const std::string& before, int level) {
  return fmt::format("{}refined_{}.msh", before, level);
}

// The groups that are regions of the plate; where each element has become four
std::vector<mesh::ElementGroup> groups_of_regions(const Case& data,
                                                  std::vector<mesh::ElementGroup> groups) {
  std::erase_if(groups, [&](const mesh::ElementGroup& group) {
    return std::none_of(data.regions.begin(), data.regions.end(),
                        [&](const PlateRegion& region) { return region.name == group.name; });
  });
  return groups;
}

void refine_groups(std::vector<mesh::ElementGroup>& groups) {
  for (mesh::ElementGroup& group : groups) {
    std::vector<Index> finer;
    for (const Index element : group.elements)
      for (Index part = 0; part < 4; ++part) finer.push_back(4 * element + part);
    group.elements = std::move(finer);
  }
}

// Writes the finer meshes of a source; the first is the source itself
std::vector<MeshSource> refined_sources(const Case& data, const MeshSource& source,
                                        const std::filesystem::path& folder,
                                        const std::string& before) {
  std::vector<MeshSource> sources = {source};
  mesh::MeshFile file = load_mesh(source);
  std::vector<mesh::ElementGroup> groups = groups_of_regions(data, std::move(file.groups));
  for (int level = 1; level < kMeshes; ++level) {
    file.mesh = mesh::refine(file.mesh);
    refine_groups(groups);
    sources.emplace_back(folder / refined_name(before, level));
    mesh::write_gmsh(std::get<std::filesystem::path>(sources.back()), file.mesh, groups);
  }
  return sources;
}

// What is studied of a case: no lines, wave points, seas and fields
Case studied_case(const Case& data) {
  Case study = data;
  study.lines.clear();
  study.wave_points.clear();
  study.seas.clear();
  study.sea_grid = {};
  study.tolerance = std::min(data.tolerance, kTolerance);
  study.allow_coarse = true;
  study.fields = {{.omega = 0.0, .heading_deg = 0.0}};  // no wave has this frequency
  return study;
}

AnswerStore solve(const Case& data, Log& log, int part) {
  AnswerStore store;
  PartOfLog told(log, part, kMeshes + 1);
  analyse(data, told, store);
  const std::string modes = data.route == SolverRoute::kModal
                                ? fmt::format(" and {} modes", data.mode_count)
                                : ", without modes";
  log.info(fmt::format("solved with {} nodes{}", store.nodes, modes));
  return store;
}

// Twice as many, or all that the dry plate can have
int more_modes(const Case& data) {
  const Index nodes = load_mesh(plate_source(data)).mesh.node_count();
  return static_cast<int>(std::min<Index>(2 * data.mode_count, 3 * nodes / 2));
}

double largest_difference(const Eigen::Ref<const VecXcd>& a, const Eigen::Ref<const VecXcd>& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

// Answers of one frequency and quantity on every mesh, points run faster than headings
MatXcd answers_on_meshes(const std::vector<AnswerStore>& runs, std::size_t at) {
  MatXcd answers(runs.front().values[at].size(), kMeshes);
  for (int level = 0; level < kMeshes; ++level)
    answers.col(level) = runs[static_cast<std::size_t>(level)].values[at].reshaped();
  return answers;
}

void add_group(const Case& data, std::size_t i, std::size_t q, const MatXcd& answers,
               const Eigen::Ref<const VecXcd>& more_modes, ConvergenceStudy& study) {
  const Extrapolation fine = extrapolate(answers);
  const VecXcd own = answers.col(0);
  StudiedGroup group{.omega = data.omega[i],
                     .quantity = data.quantities[q],
                     .largest = own.cwiseAbs().maxCoeff(),
                     .order = fine.order};
  const double scale = group.largest > 0.0 ? group.largest : 1.0;
  group.mesh_error = largest_difference(own, fine.value) / scale;
  group.mode_error = largest_difference(own, more_modes) / scale;
  study.groups.push_back(group);
  for (std::size_t b = 0, row = 0; b < data.heading_deg.size(); ++b)
    for (const NamedPoint& point : data.points) {
      const auto at = static_cast<Index>(row++);
      study.answers.push_back({.omega = data.omega[i],
                               .heading_deg = data.heading_deg[b],
                               .point = point.name,
                               .quantity = data.quantities[q],
                               .value = own[at],
                               .extrapolated = fine.value[at],
                               .mesh_error = std::abs(own[at] - fine.value[at]),
                               .mode_error = std::abs(own[at] - more_modes[at])});
    }
}

}  // namespace

Extrapolation extrapolate(const Eigen::Ref<const MatXcd>& answers) {
  FLOE_EXPECT(answers.cols() == kMeshes);
  const double coarse = (answers.col(0) - answers.col(1)).norm();
  const double fine = (answers.col(1) - answers.col(2)).norm();
  if (fine == 0.0) return {kLargestOrder, answers.col(2)};
  if (!(coarse > std::sqrt(2.0) * fine)) return {0.0, answers.col(2)};
  const double order = std::min(std::log2(coarse / fine), kLargestOrder);
  return {order, answers.col(2) + (answers.col(2) - answers.col(1)) / (std::exp2(order) - 1.0)};
}

std::vector<std::string> study_meshes(const Case& data) {
  std::vector<std::string> names;
  for (int level = 1; level < kMeshes; ++level) names.push_back(refined_name("", level));
  for (int level = 1; level < kMeshes && !data.plate_mesh.empty(); ++level)
    names.push_back(refined_name("plate_", level));
  return names;
}

ConvergenceStudy study_convergence(const Case& data, const std::filesystem::path& folder,
                                   Log& log) {
  FLOE_VALIDATE(!data.points.empty(),
                "missing output.points (floe converge tells the error of what is asked for at "
                "points)");
  FLOE_VALIDATE(!data.structure,
                "invalid plate.structure (must be a plate by its properties: floe converge makes "
                "finer meshes, which the matrices or modes of another program do not know)");
  Case study = studied_case(data);

  // Make the finer meshes
  const std::vector<MeshSource> meshes = refined_sources(data, data.mesh, folder, "");
  std::vector<MeshSource> plates;
  if (!data.plate_mesh.empty())
    plates = refined_sources(data, data.plate_mesh.front(), folder, "plate_");

  // Solve on each, then with more modes
  std::vector<AnswerStore> runs;
  for (int level = 0; level < kMeshes; ++level) {
    study.mesh = meshes[static_cast<std::size_t>(level)];
    if (!plates.empty()) study.plate_mesh = {plates[static_cast<std::size_t>(level)]};
    runs.push_back(solve(study, log, level));
  }
  const bool modal = data.route == SolverRoute::kModal;
  if (modal) study.mode_count = more_modes(data);
  study.mesh = data.mesh;
  study.plate_mesh = data.plate_mesh;
  const AnswerStore more = modal ? solve(study, log, kMeshes) : runs.front();

  // Compare
  ConvergenceStudy result{.nodes = {},
                          .modes = data.mode_count,
                          .more_modes = study.mode_count,
                          .answers = {},
                          .groups = {}};
  for (const AnswerStore& run : runs) result.nodes.push_back(run.nodes);
  for (std::size_t i = 0, at = 0; i < data.omega.size(); ++i)
    for (std::size_t q = 0; q < data.quantities.size(); ++q, ++at)
      add_group(data, i, q, answers_on_meshes(runs, at), more.values[at].reshaped(), result);
  return result;
}

}  // namespace floe
