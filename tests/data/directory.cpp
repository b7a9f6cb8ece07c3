#include <nipref/data/directory.hpp>
#include <nipref/data/scene/file.hpp>

#include "support/scratch.hpp"

using namespace nipref;

TEST_CASE("a chosen data folder without tables is refused, not replaced by another") {
  const Environment chosen("NIPREF_DATA", "no-such-folder");
  const auto says = "NIPREF_DATA = no-such-folder: must be a folder with a folder 'tables' in it";
  CHECK_THROWS_WITH_AS((void)data::tables_directory(), says, data::BadInput);
  CHECK_THROWS_WITH_AS((void)data::scenes_directory(), says, data::BadInput);
  CHECK_THROWS_WITH_AS((void)data::example_scene("thick-full-friction"), says, data::BadInput);
}

TEST_CASE("tables and scenes are looked for in the chosen data folder alone") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.file("tables"));
  const Environment chosen("NIPREF_DATA", folder.path());
  CHECK(data::tables_directory() == folder.file("tables"));
  CHECK(data::scenes_directory() == folder.file("scenes"));
  CHECK_REFUSED(data::example_scene("thick-full-friction"),
                "scene = thick-full-friction: must be one of the files in " + folder.file("scenes").string());
}
