#pragma once
#include <filesystem>

namespace nipref::data {

// Where the data lies: folders of the data folder, which is the first that exists of the environment variable
// NIPREF_DATA, the source tree this library was built from, and the place of installation; if NIPREF_DATA is
// set, only it is looked at. BadInput if there is no folder "tables" in any of them.

/// The seeds' tables.
[[nodiscard]] std::filesystem::path tables_directory();

/// The example scenes.
[[nodiscard]] std::filesystem::path scenes_directory();

}  // namespace nipref::data
