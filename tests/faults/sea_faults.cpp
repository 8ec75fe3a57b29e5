#include "fault.hpp"

// Sea states: rows 36 … 41
namespace floe::test {
namespace {

const std::string kSea = R"([sea_grid]
omega = { from = 0.4, to = 0.8 }
[[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 10.0
spreading = "cos2"
mean_heading_deg = [0]
allow_truncation = true
)";

// The case with a sea, `from` in it replaced by `to`
std::string sea(const std::string& from, const std::string& to) {
  std::string text = kSea;
  return kCaseText + text.replace(text.find(from), from.size(), to);
}

}  // namespace

std::vector<Fault> sea_faults() {
  const std::string run = "run case.toml --allow-coarse";
  const std::string jonswap = "spectrum = \"jonswap\"\npeak_period = 10.0\ngamma = ";
  const std::string old =
      "spectrum = \"bretschneider\"\nsignificant_height = 2.0\n"
      "significant_period = 10.0\n";
  const auto peaked = [&](const std::string& gamma) {
    return sea(old, jonswap + gamma + "\nsignificant_height = 2.0\n");
  };
  const auto table = [&](const std::string& omega, const std::string& density) {
    return sea(old, "spectrum = \"table\"\nomega = " + omega + "\ndensity = " + density + "\n");
  };
  return {
      {36, "NegativeHeight", 5, "invalid sea[0].significant_height = -2 m (must be positive)",
       sea("height = 2.0", "height = -2.0")},
      {36, "NoHeight", 5, "invalid sea[0].significant_height = 0 m",
       sea("height = 2.0", "height = 0")},
      {36, "NoPeriod", 5, "invalid sea[0].significant_period = 0 s",
       sea("period = 10.0", "period = 0")},
      {36, "GammaBelowOne", 5, "invalid sea[0].gamma = 0.9 (must be 1 to 20)", peaked("0.9")},
      {36, "GammaAboveTwenty", 5, "invalid sea[0].gamma = 21", peaked("21")},
      {36, "GammaNan", 5, "invalid sea[0].gamma = nan", peaked("nan")},
      {36, "NoSpreading", 5, "invalid sea[0].s = 0",
       sea("spreading = \"cos2\"", "spreading = \"cos2s\"\ns = 0")},
      {36, "UnknownSpectrum", 5, "did you mean bretschneider?",
       sea("bretschneider", "bretshneider")},
      {15, "SeaHeadingInRadians", 0, "sea[0].mean_heading_deg = [1.5708] look like radians",
       sea("mean_heading_deg = [0]", "mean_heading_deg = [1.5708]")},
      {37, "BandMissesTheSea", 5, "(at most 5 %; widen sea_grid.omega",
       sea("allow_truncation = true\n", ""), run},
      {37, "BandMissesTheSeaInACheck", 5, "(at most 5 %; widen sea_grid.omega",
       sea("allow_truncation = true\n", "")},
      {37, "BandThatTheMeshDoesNotResolve", 3, "rad/s, where the mesh has 0.",
       sea("to = 0.8", "to = 3.0"), "run case.toml"},
      {37, "FewModesForTheSea", 0, "seas up to 0.8 rad/s: few modes: modes.count = 6, about",
       kCaseText + kSea + "[modes]\ncount = 6\n", run},
      {37, "PressuresInTheSeaOnACoarseMesh", 0, "seas: pressures at the points are known to ",
       kCaseText + kSea + "[output]\npoints = { P = [0, 0] }\nquantities = [\"pressure\"]\n", run},
      {37, "BandMissesTheSeaAllowed", 0, "of its m0 lie outside", kCaseText + kSea, run},
      {38, "NanDensity", 5, "invalid sea[0].density[1] = nan", table("[0.4, 0.5]", "[1, nan]")},
      {38, "NegativeDensity", 5, "invalid sea[0].density[1] = -1", table("[0.4, 0.5]", "[1, -1]")},
      {38, "UnsortedFrequencies", 5, "must be greater than the one before",
       table("[0.5, 0.4]", "[1, 1]")},
      {38, "DuplicateFrequencies", 5, "must be greater than the one before",
       table("[0.4, 0.4]", "[1, 1]")},
      {38, "NoEnergy", 5, "(must hold energy)", table("[0.4, 0.5]", "[0, 0]")},
      {38, "RaggedTable", 5, "must be as long as omega, 3", table("[0.4, 0.5, 0.6]", "[1, 1]")},
      {39, "NoHeading", 5, "missing sea[0].mean_heading_deg", sea("mean_heading_deg = [0]\n", "")},
  };
}

}  // namespace floe::test
