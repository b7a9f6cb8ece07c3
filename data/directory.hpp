#pragma once
#include <filesystem>

namespace nipref::data {

// The data folder and its subfolders. The data folder is the first of these that has a subfolder "tables":
// 1. the value of the environment variable NIPREF_DATA; if it is set, no other place is tried;
// 2. share/nipref beside the running program (its bin/../share/nipref), or beside the shared library that holds this
//    code, so that an installed package may be moved;
// 3. the place of installation that was chosen when this was built;
// 4. the source tree from which it was built.
// Throws BadInput naming NIPREF_DATA if there is none.

/// The seeds' tables.
[[nodiscard]] std::filesystem::path tables_directory();

/// The golden values.
[[nodiscard]] std::filesystem::path golden_directory();

/// The example scenes.
[[nodiscard]] std::filesystem::path scenes_directory();

/// The statements of the seeds.
[[nodiscard]] std::filesystem::path statements_directory();

/// Templates of pages, texts and drawings.
[[nodiscard]] std::filesystem::path templates_directory();

}  // namespace nipref::data
