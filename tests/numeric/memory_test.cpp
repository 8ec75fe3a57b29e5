#include "test_case.hpp"

#include <floe/numeric/memory.hpp>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>

namespace floe::numeric {
namespace {

TEST(MemoryLimits, TakesTheTightestGroupOnTheWayUp) {
  const test::TestFolder root;
  std::filesystem::create_directories(root.path() / "proc/self");
  std::filesystem::create_directories(root.path() / "sys/fs/cgroup/job/step");
  root.write("proc/self/cgroup", "1:cpu:/old\n0::/job/step\n");
  root.write("proc/meminfo", "MemTotal: 100 kB\nMemFree: 5 kB\nMemAvailable:   80 kB\n");
  root.write("sys/fs/cgroup/job/memory.max", "12345\n");
  root.write("sys/fs/cgroup/job/step/memory.max", "max\n");
  const MemoryLimits limits = memory_limits(root.path());
  EXPECT_EQ(limits.control_group, 12345.0);
  EXPECT_EQ(limits.available, 80.0 * 1024.0);
}

TEST(MemoryLimits, AreUnboundedWhereNothingIsSaid) {
  const test::TestFolder root;
  const MemoryLimits limits = memory_limits(root.path());
  EXPECT_TRUE(std::isinf(limits.control_group));
  EXPECT_TRUE(std::isinf(limits.available));
}

TEST(MemoryLimits, SeeTheAddressSpaceLimit) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const rlimit limited{rlim_t{1} << 46, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
  EXPECT_EQ(memory_limits().address_space, std::pow(2.0, 46));
  setrlimit(RLIMIT_AS, &before);
}

TEST(MemoryBudget, IsTheLeastOfAllBounds) {
  const MemoryLimits limits{.control_group = 500.0, .address_space = 700.0, .available = 1000.0};
  EXPECT_EQ(memory_budget(0.0, limits), 500.0);
  EXPECT_EQ(memory_budget(300.0, limits), 300.0);
  EXPECT_EQ(memory_budget(0.0, {.control_group = 2e3, .address_space = 2e3, .available = 1e3}),
            800.0);
}

TEST(PeakMemory, GrowsWithWhatIsTouched) {
  const double before = peak_memory();
  std::string block(std::size_t{1} << 28, 'x');
  EXPECT_GE(peak_memory(), before + 0.5 * static_cast<double>(block.size()));
}

}  // namespace
}  // namespace floe::numeric
