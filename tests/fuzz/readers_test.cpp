#include "targets.hpp"
#include "test_paths.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

// What a fuzzer found and started from, read again, and random changes of it.
namespace floe::fuzz {
namespace {

std::vector<std::string> corpus_of(const std::string& target) {
  std::map<std::string, std::string> files;  // by name: the same order everywhere
  const auto folder = std::filesystem::path(FLOE_SOURCE_DIR) / "tests/fuzz/corpus" / target;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  std::vector<std::string> corpus;
  for (const auto& [name, bytes] : files) corpus.push_back(bytes);
  return corpus;
}

// One of a few small changes: a byte, a piece left out, doubled or taken from another file
std::string changed(std::string bytes, const std::string& other, std::mt19937& random) {
  const auto below = [&](std::size_t limit) { return limit == 0 ? 0 : random() % limit; };
  const std::size_t at = below(bytes.size()),
                    length = below(std::min<std::size_t>(64, bytes.size()));
  switch (random() % 5) {
    case 0:
      if (!bytes.empty()) bytes[at] = static_cast<char>(random());
      break;
    case 1:
      if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
      break;
    case 2:
      bytes.erase(at, length);
      break;
    case 3:
      bytes.insert(at, bytes.substr(at, length));
      break;
    default:
      bytes.insert(at, other.substr(below(other.size()), length));
  }
  return bytes;
}

class Readers : public testing::TestWithParam<Target> {};

TEST_P(Readers, SurviveTheCorpus) {
  const std::vector<std::string> corpus = corpus_of(GetParam().name);
  ASSERT_FALSE(corpus.empty());
  for (const std::string& bytes : corpus) run(GetParam(), bytes);
}

TEST_P(Readers, SurviveRandomChanges) {
  const std::vector<std::string> corpus = corpus_of(GetParam().name);
  ASSERT_FALSE(corpus.empty());
  std::mt19937 random(4);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  long executions = 0;
  while (std::chrono::steady_clock::now() < end) {
    std::string bytes = corpus[random() % corpus.size()];
    const std::size_t changes = 1 + random() % 4;
    for (std::size_t i = 0; i < changes; ++i)
      bytes = changed(std::move(bytes), corpus[random() % corpus.size()], random);
    run(GetParam(), bytes);
    ++executions;
  }
  RecordProperty("executions", std::to_string(executions));
  EXPECT_GT(executions, 100);
}

INSTANTIATE_TEST_SUITE_P(All, Readers, testing::ValuesIn(targets()),
                         [](const testing::TestParamInfo<Target>& target) {
                           return target.param.name;
                         });

}  // namespace
}  // namespace floe::fuzz
