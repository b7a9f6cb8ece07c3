#include <regex>

#include "support/paths.hpp"
#include "support/scratch_folder.hpp"
#include "support/test.hpp"

namespace fs = std::filesystem;

namespace {

/// The README's lines that call the program, without what is said of them.
std::vector<std::string> commands() {
  std::ifstream readme(fs::path(source_directory()) / "README.md");
  std::vector<std::string> found;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("    nipref ")) found.push_back(line.substr(11, line.find(" #") - 11));
  }
  return found;
}

}  // namespace

TEST_CASE("every command of the README does what it says, with status 0") {
  const ScratchFolder folder;
  for (const char* const name : {"mine.so", "old.so"})
    fs::copy_file(plugin_file("readme"), folder.file(name));
  folder.write("results.csv", "# quantity: I2\nalpha,value\n0.5,1.5707963267948966\n");
  const std::string start = "cd '" + folder.path().string() + "' && '" + program() + "' ";
  const std::vector<std::string> all = commands();
  CHECK(all.size() >= 15);
  for (const std::string& command : all) {
    CAPTURE(command);
    CHECK(std::system((start + command + " >log 2>&1").c_str()) == 0);
  }
}
