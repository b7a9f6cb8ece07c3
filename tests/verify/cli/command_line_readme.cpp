#include <regex>

#include "support/paths.hpp"
#include "support/run_nipref.hpp"
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

/// A folder that holds what the commands read; gone with it.
class Folder {
 public:
  Folder() {
    fs::create_directories(path_);
    fs::copy_file(plugin_file("readme"), path_ / "mine.so", fs::copy_options::overwrite_existing);
    fs::copy_file(plugin_file("readme"), path_ / "old.so", fs::copy_options::overwrite_existing);
    std::ofstream(path_ / "results.csv") << "# quantity: I2\nalpha,value\n0.5,1.5707963267948966\n";
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }

  [[nodiscard]] int run(const std::string& command) const {
    return std::system(
        ("cd '" + path_.string() + "' && '" + program() + "' " + command + " >log 2>&1").c_str());
  }

 private:
  fs::path path_ = fs::temp_directory_path() / ("nipref-readme-" + std::to_string(getpid()));
};

}  // namespace

TEST_CASE("every command of the README does what it says, with status 0") {
  const Folder folder;
  const std::vector<std::string> all = commands();
  CHECK(all.size() >= 15);
  for (const std::string& command : all) {
    CAPTURE(command);
    CHECK(folder.run(command) == 0);
  }
}
