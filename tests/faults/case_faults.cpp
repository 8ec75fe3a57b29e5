#include "fault.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <random>

// Case file and command line: rows 1 … 18
namespace floe::test {
namespace {

constexpr const char* kRun = "run case.toml --allow-coarse";

void make_socket(const TestFolder& folder) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = (folder.path() / "socket").string();
  path.copy(address.sun_path, sizeof(address.sun_path) - 1);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
  ::close(descriptor);
}

std::string random_bytes(std::size_t count) {
  std::mt19937 random(3);
  std::string bytes(count, '\0');
  for (char& c : bytes) c = static_cast<char>(random() & 0xff);
  return bytes;
}

std::string with_windows_ends() {
  std::string text;
  for (const char c : kCaseText) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return text;
}

std::string with_depth(const std::string& depth) { return with("58.5", depth); }
std::string with_waves(const std::string& axis) { return with("omega = [0.4, 0.5]", axis); }

std::string dotted(const std::string& begin, const std::string& part, int count) {
  std::string text = begin;
  for (int i = 0; i < count; ++i) text += part;
  return text + " = 1\n" + kCaseText;
}

std::string long_list(int count) {
  std::string list = "omega = [0.4";
  for (int i = 1; i < count; ++i) list += ",1";
  return list + "]";
}

// Rows 1 to 4: what is no readable text
std::vector<Fault> unreadable() {
  return {
      {1, "MissingFile", 3, "none.toml: cannot read: No such file or directory", "",
       "run none.toml"},
      {1, "EmptyFile", 3, "case.toml: the file is empty (must hold a case)", "\n \n"},
      {1, "FileBelowAFile", 3, "case.toml/a.toml: cannot read: Not a directory", kCaseText,
       "run case.toml/a.toml"},
      {2, "Directory", 3, "not a regular file (it is a directory)", kCaseText, "run ."},
      {2, "Fifo", 3, "pipe: not a regular file", kCaseText, "run pipe",
       [](const TestFolder& folder) { ::mkfifo((folder.path() / "pipe").c_str(), 0600); }},
      {2, "Device", 3, "/dev/zero: not a regular file", kCaseText, "run /dev/zero"},
      {2, "Socket", 3, "socket: not a regular file", kCaseText, "run socket", make_socket},
      {3, "SyntaxError", 3, "case.toml:2:9: not valid TOML", with_depth("= 5")},
      {3, "DuplicateKey", 3, "case.toml:3:9: not valid TOML", with_depth("58.5\ndepth = 3")},
      {3, "DuplicateSection", 3, "not valid TOML", kCaseText + "[water]\n"},
      {3, "BadUtf8", 3, "case.toml:1:9: not valid TOML", "title = \"\xff\xfe\"\n" + kCaseText},
      {3, "NulByte", 3, "not valid TOML",
       "title = \"a" + std::string(1, '\0') + "\"\n" + kCaseText},
      {3, "NulInTableName", 3, "case.toml:13:3: not valid TOML: error while parsing key",
       kCaseText + "[[" + std::string(3, '\0') + "-]\n"},
      {3, "SignInSectionName", 3, "case.toml:13:2: not valid TOML: error while parsing key",
       kCaseText + "[$plate]\n"},
      {3, "ThreeBrackets", 3, "case.toml:13:3: not valid TOML: error while parsing key",
       kCaseText + "[[[sea]]]\n"},
      {3, "SectionNameOnTheNextLine", 3, "case.toml:13:2: not valid TOML", kCaseText + "[\nsea]\n"},
      {3, "BraceInAnArray", 3, "case.toml:15:2: not valid TOML: error while parsing value",
       kCaseText + "[output]\nx = [40, \n }]\n"},
      {3, "QuoteWithinAWord", 3, "case.toml:2:12: not valid TOML: error while parsing date",
       with_depth("[ 1-0\"\xef\xbb\xbb]")},
      {3, "LetterBehindABackslash", 3, "case.toml:1:12: not valid TOML: error while parsing string",
       "title = \"a\\\xef\xbf\xbf\"\n" + kCaseText},
      {3, "LetterAsValue", 3, "case.toml:2:9: not valid TOML: error while parsing value",
       with_depth("\xc3\xa9")},
      {3, "SectionNameInThreeQuotes", 3, "not valid TOML: error while parsing string",
       kCaseText + "[\"\"\" \\\n   \xef\xbb\xbd '[sea"},
      {3, "LetterInSectionName", 3, "case.toml:13:2: not valid TOML: error while parsing key",
       kCaseText + "[\xc3\xa9]\n"},
      {3, "LettersInQuotesAndComments", 0, "\xc3\xa9\xe3\x81\x82",
       "title = \"\xc3\xa9\xe3\x81\x82\" # \xe3\x81\x82 \"\n" + kCaseText},
      {3, "DeepNesting", 3, "not valid TOML", "a = " + std::string(20'000, '[')},
      {3, "DeepTables", 3, "not valid TOML",
       [] {
         std::string text = "a = ";
         for (int i = 0; i < 20'000; ++i) text += "{a=";
         return text;
       }()},
      {3, "LongDottedKey", 3, "case.toml:1:1: invalid key of more than 100 parts",
       dotted("a", ".a", 7'000'000)},
      {3, "LongQuotedKey", 3, "case.toml:1:1: invalid key of more than 100 parts",
       dotted("'='", ".\"=\\\"\"", 1'000'000)},
      {3, "LongKeyBehindFiveQuotes", 3, "case.toml:1:1: invalid key of more than 100 parts",
       dotted("x = { a = \"\"\"b\"\"\"\"\", b", ".b", 3'000'000)},
      {3, "LongSectionName", 3, "case.toml:1:1: invalid key of more than 100 parts",
       dotted("[a", ".a", 3'000'000)},
      {3, "DotsInTextsAndComments", 0, "37 nodes",
       "title = \"" + std::string(200, '.') + "\"  # " + std::string(200, '.') + "\n" + kCaseText},
      {3, "RandomBytes", 3, "not valid TOML", random_bytes(3 << 20)},
      {3, "ByteOrderMark", 0, "37 nodes", "\xef\xbb\xbf" + kCaseText},
      {3, "WindowsLineEnds", 0, "37 nodes", with_windows_ends()},
      {4, "FiveGigabytes", 3, "invalid file size = 5368709120 bytes (must be at most 16777216)",
       kCaseText, "run case.toml",
       [](const TestFolder& folder) {
         std::filesystem::resize_file(folder.path() / "case.toml", std::uintmax_t{5} << 30);
       }},
  };
}

// Rows 5 to 8: keys and numbers
std::vector<Fault> wrong_values() {
  return {
      {5, "MisspeltKey", 3, "case.toml:2:1: unknown key water.dpeth (did you mean water.depth?)",
       with("depth", "dpeth")},
      {5, "MisspeltSection", 3, "case.toml:1:2: unknown section wter (did you mean water?)",
       with("[water]", "[wter]")},
      {5, "ForeignKey", 3, "unknown key plate.colour (known are ",
       with("thickness", "colour = 1\nthickness")},
      {6, "TextForNumber", 3, "invalid water.depth = \"58,5\" (must be a number in m)",
       with_depth("\"58,5\"")},
      {6, "TextWithUnit", 3, "invalid water.depth = \"58.5 m\" (must be a number in m)",
       with_depth("\"58.5 m\"")},
      {6, "IntegerOverflow", 3, "not valid TOML", with("nx = 4", "nx = 99999999999999999999")},
      {6, "IntegerBeyondInt", 3, "invalid mesh.rectangle.nx = 4294967300",
       with("nx = 4", "nx = 4294967300")},
      {6, "DateForNumber", 3, "invalid water.depth = a date or time", with_depth("2020-01-01")},
      {7, "NanDepth", 3, "invalid water.depth = nan m", with_depth("nan")},
      {7, "InfThickness", 3, "invalid plate.thickness = inf m",
       with("thickness = 2.0", "thickness = inf")},
      {7, "MinusZeroDepth", 3, "invalid water.depth = -0 m", with_depth("-0.0")},
      {7, "MinusZeroLoss", 0, "37 nodes", with("thickness", "loss_factor = -0.0\nthickness")},
      {7, "TooLargeExponent", 3, "case.toml:2:", with_depth("1e400")},
      {7, "SubnormalDensity", 3, "invalid plate.density = 1e-310 kg/m³",
       with("density = 256.25", "density = 1e-310")},
      {7, "NanInPoint", 3, "invalid output.points.P[0] = nan m",
       kCaseText + "[output]\npoints = { P = [nan, 0] }\n"},
      {7, "FarWavePoint", 0, "results", kCaseText + "[output]\nwave_points = { far = [1e9, 0] }\n",
       kRun},
      {7, "PointOffThePlate", 3,
       "case.toml:14:16: invalid point P = [0, 31] m (must lie on a plate",
       kCaseText + "[output]\npoints = { P = [0, 31] }\n"},
      {7, "LineOffThePlate", 3, "case.toml:14:15: invalid point 3 of line c = [151, 0] m",
       kCaseText + "[output]\nlines = { c = { from = [0, 0], to = [151, 0], count = 3 } }\n"},
      {7, "NanHeading", 3, "invalid waves.heading_deg[1] = nan °", with("[0, 30]", "[0, nan]")},
      {7, "InfYoungsModulus", 3, "invalid plate.youngs_modulus = inf",
       with("youngs_modulus = 1.19e10", "youngs_modulus = inf")},
      {8, "NegativeDepth", 3, "case.toml:2:9: invalid water.depth = -3 m (must be positive or inf)",
       with_depth("-3")},
      {8, "ZeroDepth", 3, "(must be positive or inf)", with_depth("0")},
      {8, "FilmOfWater", 3, "invalid water.depth = 1e-300 m (must be at least 0.001 or inf)",
       with_depth("1e-300")},
      {8, "WavesOfMillimetres", 3, "(must be at least 0.1, even with --allow-coarse",
       with_depth("0.001"), "run case.toml --allow-coarse"},
      {8, "DeeperThanAnySea", 0, "results", with_depth("1e300"), kRun},
      {8, "InfiniteDepth", 0, "results", with_depth("inf"), kRun},
  };
}

// Rows 9 to 15: waves, plate, modes, headings
std::vector<Fault> wrong_physics() {
  std::vector<Fault> faults = {
      {10, "TwoAxes", 3, "ambiguous waves.period beside waves.omega (must be exactly one of",
       with_waves("omega = [0.4]\nperiod = [9]")},
      {10, "NoAxis", 3, "missing waves (must hold one of omega", with_waves("")},
      {11, "EmptyList", 3, "invalid waves.omega = [] (must not be empty)",
       with_waves("omega = []")},
      {11, "Unsorted", 0, "waves.omega sorted", with_waves("omega = [0.5, 0.4]")},
      {11, "Duplicates", 0, "waves.omega: 1 given twice dropped",
       with_waves("omega = [0.4, 0.5, 0.4]")},
      {11, "TenMillionByCount", 6, "invalid waves.omega.count = 10000000 (must be at most 100000)",
       with_waves("omega = { from = 0.2, to = 0.5, count = 10000000 }")},
      {11, "TooManyInAList", 6, "invalid waves.omega = a list of 100001",
       with_waves(long_list(100'001))},
      {12, "ShallowKh", 0, "results", with_depth("0.02"), kRun},
      {12, "WavesShorterThanElements", 3,
       "invalid mesh resolution = ", with_waves("omega = [30.0]")},
      {12, "WavesShorterThanElementsAllowed", 3, "even with --allow-coarse",
       with_waves("omega = [1000.0]"), kRun},
      {13, "PoissonOneHalf", 3, "invalid plate.poisson_ratio = 0.5", with("0.13", "0.5")},
      {13, "PoissonBelowMinusOne", 3, "invalid plate.poisson_ratio = -1", with("0.13", "-1")},
      {13, "ZeroThickness", 3, "invalid plate.thickness = 0 m",
       with("thickness = 2.0", "thickness = 0")},
      {13, "NegativeModulus", 3, "invalid plate.youngs_modulus = -1 N/m²",
       with("youngs_modulus = 1.19e10", "youngs_modulus = -1")},
      {13, "SinkingPlate", 3, "invalid plate.density = 2000 kg/m³ (must be less than water.density",
       with("256.25", "2000")},
      {13, "NoStiffness", 3, "invalid plate bending rigidity = 0 N m",
       with("thickness = 2.0", "thickness = 1e-300"), "run case.toml"},
      {14, "NoModes", 3, "invalid modes.count = 0", kCaseText + "[modes]\ncount = 0\n"},
      {14, "TwoModes", 3, "invalid modes.count = 2", kCaseText + "[modes]\ncount = 2\n"},
      {14, "MoreModesThanTheMeshHas", 3, "invalid modes.count = 56 (must be 3 to 55 for this mesh",
       kCaseText + "[modes]\ncount = 56\n"},
      {15, "HeadingBeyondATurn", 3, "invalid waves.heading_deg[0] = 361 °",
       with("[0, 30]", "[361]")},
      {13, "YoungsModulusInGigapascal", 0,
       "plate.youngs_modulus = 11.9 N/m² is far from that of any plate (was it meant in GPa or "
       "MPa?)",
       with("1.19e10", "11.9"), "check case.toml --allow-coarse"},
      {13, "DensityInTonnes", 0, "plate.density = 0.25625 kg/m³ is far from",
       with("256.25", "0.25625")},
      {13, "ThicknessInMillimetres", 0, "thick plate: thickness = 2000 m, shorter side = 60 m",
       with("thickness = 2.0", "thickness = 2000.0")},
      {15, "HeadingGivenTwiceAFullTurnApart", 0, "waves.heading_deg: 2 given twice dropped",
       with("[0, 30]", "[0, 30, 360, -330]")},
      {15, "HeadingInRadians", 0, "look like radians (did you mean degrees?)",
       with("[0, 30]", "[0, 0.7854]")},
  };
  for (const auto& [axis, unit] :
       {std::pair{"omega", "rad/s"}, std::pair{"period", "s"}, std::pair{"freq", "Hz"},
        std::pair{"wavenumber", "rad/m"}, std::pair{"wavelength", "m"}})
    for (const char* value : {"0", "-1", "inf", "nan"})
      faults.push_back(
          {9, fmt::format("{}{}", axis, std::string(value) == "-1" ? "Negative" : value), 3,
           fmt::format("invalid waves.{}[0] = {} {} (must be positive)", axis, value, unit),
           with_waves(fmt::format("{} = [{}]", axis, value))});
  return faults;
}

// Rows 16 to 18: threads, paths, locales
std::vector<Fault> wrong_surroundings() {
  const std::string deep = [] {
    std::string path;
    for (int i = 0; i < 15; ++i) path.append(200, 'd').append("/");
    return path;
  }();
  const auto in = [](const std::string& path, const std::string& mesh) {
    return [=](const TestFolder& folder) {
      std::filesystem::create_directories(folder.path() / path);
      folder.write(path + "case.toml", mesh.empty() ? kCaseText : with_mesh_file(mesh));
    };
  };
  const auto mesh_above = [=](const TestFolder& folder) {
    in("a b/ü/", "../../plate ö.msh")(folder);
    run_floe(folder, "mesh rectangle --length 300 --width 60 --nx 4 --ny 2 -o 'plate ö.msh'");
  };
  return {
      {16, "NoThreads", 2, "invalid --threads = 0 (must be 1 to 1024)", kCaseText,
       "run case.toml --threads 0"},
      {16, "NegativeThreads", 2, "invalid --threads = -3", kCaseText, "run case.toml --threads -3"},
      {16,
       "ThreadsThatTheSystemDoesNotGive",
       6,
       "cannot start 2 threads, the system gives 1",
       kCaseText,
       "run case.toml --threads 2",
       {},
       "ulimit -s 2000000; ulimit -v 1500000;"},
      {16, "TooManyThreads", 2, "invalid --threads = 100000", kCaseText,
       "run case.toml --threads 100000"},
      {16,
       "MoreThreadsThanAllowed",
       0,
       "2 threads asked for, the process may use 1 processor",
       kCaseText,
       "run case.toml --threads 2",
       {},
       "taskset -c 0"},
      {17, "SpacesAndLettersAndParents", 0, "37 nodes", "", "check 'a b/ü/case.toml'", mesh_above},
      {17, "LongPath", 0, "37 nodes", "", "check " + deep + "case.toml", in(deep, "")},
      {17, "PathOfFiveThousandBytes", 3, "cannot read: File name too long", "",
       "check " + deep + deep + "case.toml"},
      {17, "NameWithADash", 0, "37 nodes", "", "check -- -case.toml",
       [](const TestFolder& folder) { folder.write("-case.toml", kCaseText); }},
      {17, "NameOfMeshWithADash", 4, "invalid mesh.file = \"-none.msh\" (cannot read: No such file",
       with_mesh_file("-none.msh")},
  };
}

}  // namespace

std::vector<Fault> case_faults() {
  std::vector<Fault> all = unreadable();
  for (const auto& part : {wrong_values(), wrong_physics(), wrong_surroundings()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace floe::test
