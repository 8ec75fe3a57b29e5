#include "fault.hpp"

// Files and processes: rows 56 … 72
namespace floe::test {
namespace {

const std::string kSeaWithAPath = R"([sea_grid]
omega = { from = 0.4, to = 0.8 }
[[sea]]
name = "../../x"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 10.0
spreading = "none"
mean_heading_deg = [0]
allow_truncation = true
)";

// A finished run in case.out, of the case as it lies there
void run_before(const TestFolder& folder) { run_floe(folder, "run case.toml"); }

std::function<void(const TestFolder&)> run_of(const std::string& text) {
  return [text](const TestFolder& folder) {
    const std::string now = folder.read("case.toml");
    folder.write("case.toml", text);
    run_floe(folder, "run case.toml");
    folder.write("case.toml", now);
  };
}

void flip(const TestFolder& folder, const std::string& name) {
  std::string bytes = folder.read(name);
  if (bytes.empty()) return;
  bytes[bytes.size() / 2] ^= 1;
  folder.write(name, bytes);
}

}  // namespace

std::vector<Fault> disk_faults() {
  const std::string run = "run case.toml", resume = "run case.toml --resume";
  return {
      {56, "FilesMayNotGrow", 7, "File too large", kCaseText, run, {}, "ulimit -f 2;"},
      {58, "OutputIsAFile", 7, "cannot write to file: ", kCaseText, run + " -o file",
       [](const TestFolder& folder) { folder.write("file", ""); }},
      {58, "OutputBelowAFile", 7, "cannot write to file/out: ", kCaseText, run + " -o file/out",
       [](const TestFolder& folder) { folder.write("file", ""); }},
      {58, "OutputWithoutParent", 7, "cannot write to none/out: ", kCaseText, run + " -o none/out"},
      {58, "OutputInProc", 7, "cannot write to /proc/floe.out: ", kCaseText,
       run + " -o /proc/floe.out"},
      {58, "NoOutputName", 2, "invalid -o = ", kCaseText, run + " -o ''"},
      {59, "ResultsOfTheSameCase", 9, "--fresh", kCaseText, run, run_before},
      {59, "ReportOverAnotherFile", 9,
       "case.toml is there already and is no report (give another name with -o, or remove it)",
       kCaseText, "report case.out -o case.toml", run_before},
      {59, "NetcdfOverAnotherFile", 9, "case.toml is there already and is no netCDF file",
       kCaseText, "export case.out --format netcdf -o case.toml", run_before},
      {59, "WamitOverAnotherFile", 9, "case.1 is there already and is no file of floe", kCaseText,
       "export case.out --format wamit --length 300 -o case",
       [](const TestFolder& folder) {
         run_before(folder);
         folder.write("case.1", "mine");
       }},
      {59, "MeshOverAnotherFile", 9, "case.toml is there already and is no Gmsh mesh", kCaseText,
       "mesh rectangle --length 10 --width 10 --nx 2 --ny 2 -o case.toml"},
      {59, "ResultsOfAnotherCase", 9, "--fresh", kCaseText, run,
       run_of(with("thickness = 2.0", "thickness = 3.0"))},
      {59, "FilesOfTheSameNames", 9, "", kCaseText, run,
       [](const TestFolder& folder) {
         std::filesystem::create_directory(folder.path() / "case.out");
         folder.write("case.out/rao_points.csv", "mine");
       }},
      {61, "RecordWithAFlippedBit", 0,
       "is damaged (moved to records/bad/frequency_00001.rec), computed again", kCaseText, resume,
       [](const TestFolder& folder) {
         run_before(folder);
         flip(folder, "case.out/records/frequency_00001.rec");
       }},
      {61, "RecordWithoutBytes", 0, ", computed again", kCaseText, resume,
       [](const TestFolder& folder) {
         run_before(folder);
         folder.write("case.out/records/frequency_00001.rec", "");
       }},
      {61, "RecordCutShort", 0, ", computed again", kCaseText, resume,
       [](const TestFolder& folder) {
         run_before(folder);
         const std::string name = "case.out/records/frequency_00001.rec";
         folder.write(name, folder.read(name).substr(0, 200));
       }},
      {62, "ManifestGone", 9, "--fresh", kCaseText, resume,
       [](const TestFolder& folder) {
         run_before(folder);
         std::filesystem::remove(folder.path() / "case.out/records/manifest.json");
       }},
      {62, "ManifestCutShort", 9, "--fresh", kCaseText, resume,
       [](const TestFolder& folder) {
         run_before(folder);
         const std::string name = "case.out/records/manifest.json";
         folder.write(name, folder.read(name).substr(0, 100));
       }},
      {62, "RecordsGone", 9, "--fresh", kCaseText, resume,
       [](const TestFolder& folder) {
         run_before(folder);
         std::filesystem::remove_all(folder.path() / "case.out/records");
       }},
      {63, "CaseEditedBeforeResume", 9, "/options/plate/thickness", kCaseText, resume,
       run_of(with("thickness = 2.0", "thickness = 3.0"))},
      {66, "ClosedOutput", 0, "", kCaseText, run + " >&-"},
      {66, "FullOutput", 0, "", kCaseText, run + " >/dev/full"},
      {66, "ClosedOutputAndErrors", 0, "", kCaseText, run + " >&- 2>&-"},
      {66, "ErrorsNowhere", 3, "", with("58.5", "-3"), run + " 2>&-"},
      {66, "DumbTerminal", 0, "results", kCaseText, run, {}, "TERM=dumb NO_COLOR=1 COLUMNS=20"},
      {68, "LinkAsResult", 9, "", kCaseText, run,
       [](const TestFolder& folder) {
         std::filesystem::create_directory(folder.path() / "case.out");
         folder.write("target", "mine");
         std::filesystem::create_symlink("../target", folder.path() / "case.out/rao_points.csv");
       }},
      {69, "MarkupInTitle", 0, "results", "title = \"<script>alert(1)</script>\"\n" + kCaseText,
       run},
      {69, "NewlineInTitle", 3, "invalid title = ", "title = \"a\\nb\"\n" + kCaseText},
      {69, "PathAsPointName", 0, "results",
       kCaseText + "[output]\npoints = { \"../x\" = [0, 0] }\n", run},
      {69, "PathAsSeaName", 0, "results", kCaseText + kSeaWithAPath, run + " --allow-coarse"},
      {69, "FormulaAsPointName", 3, "invalid name in output.points",
       kCaseText + "[output]\npoints = { \"=cmd()\" = [0, 0] }\n"},
      {69, "CommaInPointName", 3, "invalid name in output.points",
       kCaseText + "[output]\npoints = { \"a,b\" = [0, 0] }\n"},
  };
}

}  // namespace floe::test
