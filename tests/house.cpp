#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

// The arrows of the house: ref -> data, fast -> data, verify -> all three.

namespace fs = std::filesystem;

namespace {

const std::map<std::string, std::set<std::string>> allowed{
    {"data", {"data"}},
    {"ref", {"ref", "data"}},
    {"fast", {"fast", "data"}},
    {"verify", {"verify", "ref", "fast", "data"}},
};

std::string read(const fs::path& file) {
  std::ifstream stream(file);
  REQUIRE(stream);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Rooms whose headers a file includes.
std::set<std::string> rooms_included(const fs::path& file) {
  static const std::regex include(R"re(#\s*include\s*<nipref/(data|ref|fast|verify)/)re");
  const std::string text = read(file);
  std::set<std::string> rooms;
  for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
    rooms.insert((*it)[1]);
  return rooms;
}

}  // namespace

TEST_CASE("no room includes another against the arrows; ref and fast know nothing of each other") {
  int files = 0;
  for (const auto& [room, may_include] : allowed) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(NIPREF_SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      ++files;
      for (const std::string& included : rooms_included(entry.path())) {
        CAPTURE(entry.path().filename().string());
        CAPTURE(included);
        CHECK(may_include.count(included) == 1);
      }
    }
  }
  CHECK(files > 50);
}

TEST_CASE("the arrows are seen: verify does include every other room") {
  std::set<std::string> rooms;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(NIPREF_SOURCE_DIR) / "verify")) {
    if (entry.is_regular_file()) rooms.merge(rooms_included(entry.path()));
  }
  CHECK(rooms == std::set<std::string>{"data", "ref", "fast", "verify"});
}

TEST_CASE("no room includes what another keeps internal") {
  static const std::regex include(
      R"re(#\s*include\s*<nipref/(data|ref|fast|verify)/\S*(internal|arithmetic|generator)/)re");
  for (const auto& [room, unused] : allowed) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(NIPREF_SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      const std::string text = read(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
        CAPTURE(entry.path().filename().string());
        CHECK((*it)[1] == room);
      }
    }
  }
}

TEST_CASE("the top level holds what the design names and nothing else") {
  const std::set<std::string> named{"CMakeLists.txt", "README.md", "data",  "ref",
                                    "fast",           "verify",    "tests", "build"};
  for (const auto& entry : fs::directory_iterator(NIPREF_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    CHECK((name.front() == '.' || named.count(name) == 1));
  }
}

TEST_CASE("the example of the README is the one that is built as a test") {
  const std::string example = read(fs::path(NIPREF_SOURCE_DIR) / "tests/consumer/main.cpp");
  CHECK(read(fs::path(NIPREF_SOURCE_DIR) / "README.md").find("```cpp\n" + example + "```") !=
        std::string::npos);
}
