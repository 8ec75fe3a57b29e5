#include "fault.hpp"

// Memory, threads, numbers: rows 42 … 55
namespace floe::test {
namespace {

std::string with_solver(const std::string& line) { return kCaseText + "[solver]\n" + line + "\n"; }

}  // namespace

std::vector<Fault> resource_faults() {
  const std::string large = with("nx = 4, ny = 2", "nx = 100, ny = 40");
  const std::string run = "run case.toml";
  return {
      {42, "MoreThanTheMemoryAllowed", 6, "(must be at most 210 MB; ", large,
       run + " --memory 200M"},
      {42, "MoreThanTheMemoryAllowedInACheck", 6, "invalid memory need = ", large,
       "check case.toml --memory 200M"},
      {42,
       "MoreThanTheProcessMayMap",
       6,
       "invalid memory need = ",
       with("nx = 4, ny = 2", "nx = 400, ny = 100"),
       run,
       {},
       "ulimit -v 1000000;"},
      {42,
       "LessThanTheLinearAlgebraMaps",
       6,
       "invalid address space = ",
       kCaseText,
       run + " --allow-coarse --threads 1",
       {},
       "OMP_NUM_THREADS=1; ulimit -v 200000;"},
      {42, "MemoryWithoutNumber", 2, "invalid --memory = much", kCaseText, run + " --memory much"},
      {54, "GarbageInThreadVariable", 0, "results", kCaseText, run, {}, "OMP_NUM_THREADS=many"},
      {54, "GarbageInBlasVariable", 0, "results", kCaseText, run, {}, "OPENBLAS_NUM_THREADS=-7"},
      {54,
       "NestedThreads",
       0,
       "results",
       kCaseText,
       run,
       {},
       "OMP_MAX_ACTIVE_LEVELS=4 OMP_NUM_THREADS=3,3"},
      {54, "FarMoreThreadsThanProcessors", 0, "1000 threads asked for", kCaseText,
       run + " --threads 1000"},
      {55, "ToleranceBelowWhatIsReached", 3,
       "invalid solver.tolerance = 1e-16 (must be 1e-9 to 1e-1)", with_solver("tolerance = 1e-16")},
      {55, "ToleranceAboveOne", 3, "invalid solver.tolerance = 2", with_solver("tolerance = 2")},
      {55, "NoTolerance", 3, "invalid solver.tolerance = 0", with_solver("tolerance = 0")},
      {55, "NanTolerance", 3, "invalid solver.tolerance = nan", with_solver("tolerance = nan")},
      {55, "UnknownMethod", 3, "invalid solver.method = \"magic\"",
       with_solver("method = \"magic\"")},
  };
}

}  // namespace floe::test
