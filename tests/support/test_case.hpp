#pragma once

#include <filesystem>
#include <fstream>
#include <string>

/// A case as text, and a folder of its own for each test.
namespace floe::test {

/// A complete case of eight lines of sections; `[waves]` starts in line 10.
inline const std::string kCaseText = R"([water]
depth = 58.5
[plate]
thickness = 2.0
youngs_modulus = 1.19e10
poisson_ratio = 0.13
density = 256.25
[mesh]
rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }
[waves]
omega = [0.4, 0.5]
heading_deg = [0, 30]
)";

/// A text with the first `from` replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) return "no such text: " + from;
  return text.replace(at, from.size(), to);
}

/// The case with the first `from` replaced by `to`.
inline std::string with(const std::string& from, const std::string& to) {
  return replaced(kCaseText, from, to);
}

/// A folder that is made for a test and removed after it.
class TestFolder {
 public:
  TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "floe_test_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a test folder");
    path_ = name;
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path path_;
};

}  // namespace floe::test
