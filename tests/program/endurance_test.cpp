#include "floe_program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// Long sweeps in little memory.
namespace floe {
namespace {

using test::run_floe;
using test::TestFolder;

// While frequencies are solved; afterwards result.nc is made in memory, 2 kB a frequency here
double peak_memory_of(const TestFolder& folder, int frequencies) {
  folder.write("sweep.toml", test::with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = " +
                                                          std::to_string(frequencies) + " }") +
                                 "[modes]\ncount = 8\n[output]\npoints = { P5 = [0, 0] }\n"
                                 "fields = [{ omega = 0.2, heading_deg = 0 }]\n");
  const test::ProgramResult result =
      run_floe(folder, "run sweep.toml --fresh --memory 300M --threads 1", "ulimit -v 1500000;");
  EXPECT_EQ(result.code, 0) << result.error;
  const auto run = nlohmann::json::parse(folder.read("sweep.out/run.json"));
  EXPECT_EQ(run.at("frequencies").size(), static_cast<std::size_t>(frequencies));
  return run.at("stages").back().at("peak_memory");
}

// What grows with a frequency is a line of the account: 4 kB allowed for each
TEST(EnduranceLong, FiveHundredFrequenciesTakeNoMoreMemoryThanTwenty) {
  const TestFolder folder;
  const double few = peak_memory_of(folder, 20), many = peak_memory_of(folder, 500);
  RecordProperty("peak_20", std::to_string(few));
  RecordProperty("peak_500", std::to_string(many));
  EXPECT_LT(many, few + 480.0 * 4096.0);
}

}  // namespace
}  // namespace floe
