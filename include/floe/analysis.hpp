#pragma once

#include <floe/frequency_report.hpp>
#include <floe/mesh/mesh_file.hpp>
#include <floe/mesh/q8_mesh.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/mesh/shapes.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/given_structure.hpp>
#include <floe/plate/plate_regions.hpp>
#include <floe/response/quantity.hpp>
#include <floe/sea_results.hpp>
#include <floe/wave/water.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// The whole story: a case goes in, results go to a store, stage by stage.
namespace floe {

/// Where a mesh comes from: a shape that floe meshes, or a file.
using MeshSource =
    std::variant<mesh::RectangleOptions, mesh::DiscOptions, mesh::RingOptions, mesh::LShapeOptions,
                 mesh::ModuleArrayOptions, std::filesystem::path>;

/// Makes or reads it, with notices about what was left out or turned.
mesh::MeshFile load_mesh(const MeshSource& source);

/// A named point on the plate or on the water [m].
struct NamedPoint {
  std::string name;
  Point2 position;
  std::string place = {};  ///< where the case file says so, "CASE.toml:12:9: "
};

/// A named straight line on the plate, `count` equidistant stations, both ends included.
struct NamedLine {
  std::string name;
  Point2 from;
  Point2 to;
  int count = 0;
  std::string place = {};  ///< where the case file says so
};

/// A part of the plate with properties of its own.
struct PlateRegion {
  std::string name;                   ///< of a group of elements of the plate's mesh
  plate::PlateProperties properties;  ///< shear correction and loss factor as those of the plate
};

/// What another program has made of the plate, in place of its thickness and material.
struct GivenStructure {
  std::vector<std::pair<std::string, std::filesystem::path>> files;  ///< by their keys
  std::string hash;                                                  ///< of what they hold
  plate::PlateMatrices matrices;                                     ///< K and M, or
  plate::GivenModes modes;                                           ///< modes (then K is empty)
  bool has_modes() const { return modes.shape.size() > 0; }
};

/// A wave for which node fields are written.
struct FieldRequest {
  double omega = 0.0;        ///< one of Case::omega [rad/s]
  double heading_deg = 0.0;  ///< one of Case::heading_deg
};

/// How the fluid's equation is solved: dense LU, or GMRES on a fast operator.
enum class SolverMethod { kAuto, kDense, kLattice, kPfft, kFmm };

/// How plate and fluid are put together: by dry modes, one radiation problem each, or in one
/// coupled equation, one solution a heading.
enum class SolverRoute { kModal, kDirect };

/// "modal", "direct", as case files and run.json have it.
const char* route_name(SolverRoute route);

/// "auto", "dense", "lattice", "pfft", "fmm", as case files and run.json have it.
const char* method_name(SolverMethod method);

/// A part of a sweep: every `count`-th frequency from the `index`-th on, counted from 1. The last
/// part takes the seas.
struct Shard {
  int index = 1;
  int count = 1;
  bool holds(std::size_t place) const {
    return place % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
  }
  bool holds_seas() const { return index == count; }
};

/// Everything that a case file says, resolved to SI units. See docs/conventions.md.
struct Case {
  std::string title;
  std::string text;  ///< the case file as it was written; empty without one
  wave::Water water;
  plate::PlateProperties plate;
  std::vector<PlateRegion> regions;                 ///< parts of the plate that differ
  std::shared_ptr<const GivenStructure> structure;  ///< null: a plate by its properties
  MeshSource mesh;
  std::vector<MeshSource> plate_mesh;  ///< empty, or one: a mesh of its own for the plate
  int mode_count = 30;
  std::vector<double> omega;        ///< ascending, no duplicates [rad/s]
  std::vector<double> heading_deg;  ///< as given, no duplicates [deg]
  SolverMethod method = SolverMethod::kAuto;
  SolverRoute route = SolverRoute::kModal;
  double tolerance = 1e-6;  ///< of the results, relative to the largest
  std::vector<NamedPoint> points;
  std::vector<NamedLine> lines;
  std::vector<NamedPoint> wave_points;
  std::vector<response::Quantity> quantities = {response::Quantity::kDeflection};
  SeaRelations relations;            ///< of quantities in seas
  bool node_spectra = false;         ///< of the deflection at all nodes, in every sea
  std::vector<FieldRequest> fields;  ///< empty: the first heading, at most 10 frequencies
  std::vector<wave::SeaState> seas;  ///< any number
  std::string sea_text;              ///< the seas as the case file has them, without comments
  std::map<std::string, std::filesystem::path> sea_files;  ///< that they name, by key
  SeaGrid sea_grid;
  bool allow_coarse = false;  ///< go on with fewer than 2 nodes a wavelength
  double memory_limit = 0.0;  ///< [byte]; 0: what the machine and its cgroup allow
  double plan_memory = 0.0;   ///< [byte] that methods are planned for; 0: as memory_limit says
  Shard shard;                ///< the part of the sweep that is computed
};

/// The mesh of the plate: its own, or else that of the fluid.
const MeshSource& plate_source(const Case& data);

/// The properties of every element of the plate, from the groups of its mesh. Throws InputError
/// when a region names none of them, or when an element lies in two regions.
plate::PlateRegions plate_regions(const Case& data, Index element_count,
                                  const std::vector<mesh::ElementGroup>& groups);

/// The same once more from the plate's mesh, which is read only where there are regions.
plate::PlateRegions plate_regions(const Case& data);

/// Node field of one wave: nodal deflection and pressure per metre of amplitude.
struct NodeField {
  double omega = 0.0;
  double heading_deg = 0.0;
  VecXcd deflection;  ///< N [m/m]
  VecXcd rotation_x;  ///< N [rad/m]
  VecXcd rotation_y;  ///< N [rad/m]
  VecXcd pressure;    ///< N, total pressure of THEORY (*) [Pa/m]
};

/// All results of one frequency, per metre of wave amplitude, e^{-iωt}, phases relative to the
/// origin. The direct route knows no modes: added mass, damping, forces and amplitudes are empty.
struct FrequencyResult {
  double omega = 0.0;                    ///< [rad/s]
  double wavenumber = 0.0;               ///< k [rad/m]
  MatXd added_mass;                      ///< q × q, mass-normalised dry modes
  MatXd damping;                         ///< q × q
  MatXcd exciting_force;                 ///< q × headings
  MatXcd froude_krylov_force;            ///< q × headings, the incident wave's share of it
  MatXcd amplitudes;                     ///< ξ, q × headings
  MatXcd line_deflection;                ///< stations of all lines in order × headings
  MatXcd point_deflection;               ///< points × headings
  std::vector<MatXcd> point_quantities;  ///< one a quantity of the case: points × headings
  MatXcd wave_elevation;                 ///< wave points × headings
  std::vector<NodeField> fields;
  FrequencyReport report;
};

/// Wall time and peak memory of one stage.
struct StageTime {
  std::string stage;
  double seconds = 0.0;
  double peak_memory = 0.0;  ///< of the process so far [byte]
};

/// Where the library tells what it does; the program decides how it looks.
class Log {
 public:
  virtual ~Log() = default;
  /// A line of the account.
  virtual void info(const std::string& text) = 0;
  /// Something was repaired or left out.
  virtual void notice(const std::string& text) = 0;
  /// Something that may make the results worse.
  virtual void warning(const std::string& text) = 0;
  /// Share of the run's work that is done, 0 … 1, as predicted, and what runs now. What an earlier
  /// run did is no work.
  virtual void progress(double share, const std::string& now) = 0;
  /// Called often within a long solution, from one thread. What it throws drops the solution.
  virtual void pause() {}
};

struct Estimate;

/// Where results go. Called in this order: once `begin`, on the modal route once `modes`, each
/// frequency of the shard by rising ω, once `finish`. With seas, after the frequencies: once
/// `begin_seas`, the transfer functions by rising ω, in between samples and marches, each sea and
/// mean heading as in the case, once `end_seas`.
class Store {
 public:
  virtual ~Store() = default;

  /// What an earlier run of the same case left, asked for after `begin`; what is told is not
  /// computed again, but handed back to the functions below as if it were new.
  virtual std::optional<plate::DryModes> known_modes() { return std::nullopt; }
  virtual std::optional<FrequencyResult> known_frequency(std::size_t) { return std::nullopt; }
  /// All transfer functions of the seas and how they came about, or nothing.
  virtual std::optional<SeaGridReport> known_sea_grid() { return std::nullopt; }
  virtual SeaTransfer known_transfer(std::size_t) { return {}; }
  virtual SeaObservation known_observation() { return {}; }
  /// Seas that were not finished: `known_transfer` up to `next`, and all samples that it names.
  virtual std::optional<SeaMarch> known_sea_march() { return std::nullopt; }
  virtual std::optional<FluidSample> known_sea_sample(int number) {
    (void)number;
    return std::nullopt;
  }

  virtual void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) = 0;
  /// `mesh` is that of the modes: the plate's own, or else the fluid's.
  virtual void modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) = 0;
  /// Also one that could not be solved: its report tells why.
  virtual void frequency(const FrequencyResult& result) = 0;
  virtual void begin_seas(const SeaObservation&, const SeaGridReport& planned) { (void)planned; }
  virtual void sea_transfer(const SeaTransfer&) {}
  /// Where Case::node_spectra asks for it, at every frequency: the spectrum of the deflection at
  /// all nodes [m² s/rad] for one of the results, by its place among them.
  virtual void node_spectrum(std::size_t result, std::size_t frequency, const VecXd& spectrum) {
    (void)result, (void)frequency, (void)spectrum;
  }
  /// What was solved for the seas, numbered from 0; kept until a march that does not name it.
  virtual void sea_sample(int number, const FluidSample& sample) { (void)number, (void)sample; }
  virtual void sea_march(const SeaMarch&) {}
  virtual void sea(const SeaResult&) {}
  virtual void end_seas(const SeaGridReport&) {}
  virtual void finish(const std::vector<StageTime>& times) = 0;
};

/// Runs the case: mesh, dry modes, then for each frequency radiation, coupling and response, then
/// the seas. A frequency that does not converge is tried once more by other means; if that fails
/// too, the store gets its `unsolved_frequency` and the others are solved. Throws MeshError,
/// InputError, DataError (a sea's energy lies beyond the band), BudgetError, ConvergenceError (at
/// once where plate or seas cannot be solved, after `finish` where frequencies could not); what was
/// finished is in the store.
void analyse(const Case& data, Log& log, Store& store);

}  // namespace floe
