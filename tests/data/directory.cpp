#include <nipref/data/directory.hpp>
#include <nipref/data/scene/file.hpp>

#include "support/test.hpp"

using namespace nipref;
namespace fs = std::filesystem;

namespace {

/// NIPREF_DATA for as long as this lives.
class ChosenData {
 public:
  explicit ChosenData(const std::string& folder) {
    if (const char* const before = std::getenv("NIPREF_DATA")) before_ = before;
    setenv("NIPREF_DATA", folder.c_str(), 1);
  }
  ChosenData(const ChosenData&) = delete;
  ChosenData& operator=(const ChosenData&) = delete;
  ~ChosenData() {
    if (before_) {
      setenv("NIPREF_DATA", before_->c_str(), 1);
    } else {
      unsetenv("NIPREF_DATA");
    }
  }

 private:
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("a chosen data folder without tables is refused, not replaced by another") {
  const ChosenData chosen("no-such-folder");
  const auto says = "NIPREF_DATA = no-such-folder: must be a folder with a folder 'tables' in it";
  CHECK_THROWS_WITH_AS((void)data::tables_directory(), says, data::BadInput);
  CHECK_THROWS_WITH_AS((void)data::scenes_directory(), says, data::BadInput);
  CHECK_THROWS_WITH_AS((void)data::example_scene("thick-full-friction"), says, data::BadInput);
}

TEST_CASE("tables and scenes are looked for in the chosen data folder alone") {
  const fs::path folder = fs::temp_directory_path() / ("nipref-data-" + std::to_string(std::rand()));
  fs::create_directories(folder / "tables");
  {
    const ChosenData chosen(folder.string());
    CHECK(data::tables_directory() == folder / "tables");
    CHECK(data::scenes_directory() == folder / "scenes");
    CHECK_THROWS_WITH_AS(
        (void)data::example_scene("thick-full-friction"),
        ("scene = thick-full-friction: must be one of the files in " + (folder / "scenes").string()).c_str(),
        data::BadInput);
  }
  fs::remove_all(folder);
}
