#pragma once

#include <string>
#include <vector>

namespace floe::test {

/// One row of the list of faults that floe must survive: tested by a table of this folder, by tests
/// elsewhere (`Suite, Name`), or not applicable for a reason.
struct Row {
  int number;
  std::string fault;
  std::vector<std::string> elsewhere = {};
  std::string reason = {};
};

/// The list. Numbers 28 and 47 were never given.
inline std::vector<Row> fault_rows() {
  return {
      // Case file and command line
      {1, "case file missing, unreadable, empty"},
      {2, "path is a directory, FIFO, device, socket"},
      {3, "syntax error, duplicate key, bad UTF-8, NUL, deep nesting, random bytes, BOM, CRLF"},
      {4, "file of 5 GB"},
      {5, "unknown or misspelt key or section"},
      {6, "wrong type, wrong unit, integer overflow"},
      {7, "nan, inf, -0.0, 1e400, subnormal in any number"},
      {8, "depth <= 0"},
      {9, "omega = 0, negative, inf; period = 0"},
      {10, "two frequency axes, or none"},
      {11, "frequency list empty, unsorted, with duplicates, 1e7 entries"},
      {12, "very small and very large kh; waves shorter than elements"},
      {13, "E, rho, h, nu out of range; a plate that sinks"},
      {14, "modes: 0, fewer than 3, more than available, not converged",
       {"DryModes, SayHowManyConvergedWhenSomeDidNot"}},
      {15, "heading in radians, or beyond a turn"},
      {16, "--threads 0, negative, 100000, more than the affinity"},
      {17, "mesh path relative, .., spaces, UTF-8, very long, name that starts with -"},
      {18, "LC_NUMERIC with a decimal comma",
       {"Locale, WithADecimalCommaGivesTheSameBytes", "Gmsh, ReadsNumbersInEveryLocale"}},
      // Mesh
      {19, "truncated file, counts that do not fit, trailing junk",
       {"GmshErrors, RefusesEveryTruncation", "GmshErrors, RefusesCountsThatDoNotFit"}},
      {20, "node index 0, negative, unknown; tag gaps up to 2^62"},
      {21, "NaN or Inf coordinate; units in mm"},
      {22, "zero-area, collinear, repeated-node element",
       {"Q8Mesh, RefusesACollinearElement", "Q8Mesh, NamesTenCulpritsAndCountsTheOthers"}},
      {23, "mid-node off its edge, swapped order, negative Jacobian",
       {"Q8Mesh, RefusesAMidSideNodeFarOffItsEdge", "Q8Mesh, RefusesSwappedMidSideNodes"}},
      {24, "element types that are no quadrilateral"},
      {25, "clockwise elements", {"Q8Mesh, TurnsAMirroredMeshAsAWhole"}},
      {26, "duplicate or overlapping elements, overlapping plates",
       {"Q8MeshConformity, RefusesPiecesThatCross",
        "Q8MeshConformity, RefusesPiecesThatOverlapAtACorner"}},
      {27, "mesh not in one plane, or not at z = 0"},
      {29, "holes, T-junctions, unmerged nodes, separate parts",
       {"Q8MeshConformity, RefusesTJunctions", "Q8MeshConformity, AcceptsARingInTheHoleOfAnother"}},
      {30, "too coarse for the shortest wave"},
      {31, "aspect ratio > 20, edge-length jump > 10", {"Preflight, WarnsOfBadShapesAndUnits"}},
      {32, "one element, zero elements, 3 million elements"},
      {33, "wrong extension or dialect, gzip, big-endian binary",
       {"GmshErrors, NamesWhatItFindsInstead", "GmshErrors, NamesBigEndianBinary"}},
      {34, "imported modes or matrices do not match the mesh", {},
       "no modes or matrices can be imported in this version"},
      {35, "far-apart bodies, or two bodies 1 mm apart",
       {"Q8Mesh, AcceptsFloatsOneHundredKilometresApart",
        "Q8MeshConformity, AcceptsPiecesOneMillimetreApart"}},
      // Sea states and data files
      {36, "Hs < 0, Tp = 0, gamma < 1 or > 20, s = 0"},
      {37, "spectrum band misses part of m0"},
      {38, "spectrum with NaN, negative density, unsorted or duplicate frequencies"},
      {39, "direction missing"},
      {40, "scatter table sums to 0, ragged, text", {},
       "no scatter tables can be read in this version"},
      {41, "netCDF input damaged, hangs the reader", {},
       "no netCDF file is read in this version"},
      // Resources and numbers
      {42, "estimate > memory budget", {"Estimate, RefusesBeyondTheBudgetNamingWhatHelps"}},
      {43, "cgroup limit lower than RAM",
       {"MemoryLimits, TakesTheTightestGroupOnTheWayUp", "MemoryBudget, IsTheLeastOfAllBounds"}},
      {44, "allocation fails midway", {"Allocations, MayFailAtAnyCount"}},
      {45, "kill -9 in mid-sweep", {"Resume, AfterAKillAtAnyInstantGivesTheSameBytes"}},
      {46, "GMRES stagnates, breaks down, hits the limit of iterations",
       {"Gmres, ReportsAStagnatingColumn", "Gmres, NamesTheColumnThatDoesNotConverge",
        "Gmres, ReportsWhatIsNotFinite"}},
      {48, "structural resonance with zero damping", {"ModalAmplitudes, RefuseAResonanceWithoutDamping"}},
      {49, "sparse Cholesky: not positive definite", {"DryModes, RefuseAPencilThatIsNotDefinite"}},
      {50, "eigensolver does not converge, spurious or missing modes",
       {"DryModes, SayHowManyConvergedWhenSomeDidNot", "twin_DryModes, OfLanczosAreThoseOfTheDenseSolution"}},
      {51, "NaN or Inf anywhere", {"Finite, NamesThePhaseAndTheFrequency",
        "DirectoryStore, NeverWritesANumberThatIsNotFinite"}},
      {52, "wrong BLAS on this CPU", {"Blas, ThatCannotMultiplyIsNamedAtTheStart"}},
      {53, "illegal instruction: binary on an older CPU", {},
       "the build has no -march flag: baseline x86-64, faster kernels are chosen at run time"},
      {54, "threads 1, 2, 3, 7, more than cores; garbage in OMP_NUM_THREADS",
       {"Determinism, OfEveryMethodForAnyNumberOfThreads"}},
      {55, "tolerance below what can be reached, or above 1"},
      // Disk, files, processes
      {56, "disk full", {"DirectoryStore, KeepsFinishedFrequenciesWhenADiskFills"}},
      {57, "disk free below estimate at start", {}, "the size on disk is not estimated in this version"},
      {58, "output directory read-only, a file, without parent"},
      {59, "output exists from another case",
       {"Run, KeepsAnEarlierResultUnlessFresh", "DirectoryStore, ReplacesItsOwnFilesOnly"}},
      {60, "two runs on one output directory",
       {"Run, WaitsForNobodyInABusyDirectory", "DirectoryStore, HoldsOffASecondRun"}},
      {61, "record truncated, bit flipped, zero-length, from a newer version",
       {"Record, NoticesEveryChangedByte", "Record, NoticesEveryMissingEnd",
        "Record, SaysWhatIsWrong"}},
      {62, "manifest missing or damaged but records fine"},
      {63, "case or mesh edited between run and resume",
       {"Resume, RefusesTheResultsOfAnotherCase"}},
      {64, "clock jumps, negative durations", {},
       "all durations are of the monotonic clock; no result holds a time"},
      {65, "output directory deleted during the run"},
      {66, "stdout closed, broken pipe, no TTY, TERM=dumb",
       {"Run, SurvivesClosedAndBrokenOutput"}},
      {67, "SIGINT, SIGTERM, --max-time",
       {"Run, StopsCleanlyAtASignal", "Resume, GoesOnAfterMaxTime"}},
      {68, "symbolic link as output file",
       {"DirectoryStore, ReplacesASymbolicLinkAndNotItsTarget"}},
      {69, "hostile names in the case",
       {"DirectoryStore, KeepsHostileTitlesOnOneCommentLine", "Report, LetsNoTextOfTheUserOutOfItsData"}},
      {70, "shards merged with overlaps, gaps, different settings", {},
       "no shards can be merged in this version"},
      {71, "records from another CPU level in one sweep", {},
       "bitwise equality holds on one CPU level only; records of another one are accepted"},
      {72, "upgrade of floe between run and resume", {"Record, SaysWhatIsWrong"}},
  };
}

}  // namespace floe::test
