#include <dlfcn.h>
#include <link.h>

#include <nipref/data/directory.hpp>
#include <nipref/data/internal/common.hpp>

namespace nipref::data {
namespace {

namespace fs = std::filesystem;

bool holds_tables(const fs::path& folder) {
  std::error_code none;
  return fs::is_directory(folder / "tables", none);
}

/// The file of the running program; empty if it cannot be known.
fs::path program() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown);
}

/// The file of the shared library that holds this code; empty if it is in the program itself.
fs::path shared_library() {
  static const char here = 0;
  Dl_info info;
  void* map = nullptr;
  if (dladdr1(&here, &info, &map, RTLD_DL_LINKMAP) == 0 || map == nullptr) return {};
  return static_cast<const link_map*>(map)->l_name;
}

/// The folders in which the data may lie, the preferred one first.
std::vector<fs::path> places() {
  std::vector<fs::path> places;
  if (const fs::path file = program(); !file.empty())
    places.push_back(file.parent_path() / NIPREF_DATA_FROM_PROGRAM);
  if (const fs::path file = shared_library(); !file.empty())
    places.push_back(file.parent_path() / NIPREF_DATA_FROM_LIBRARY);
  places.emplace_back(NIPREF_DATA_INSTALLED);
  places.emplace_back(NIPREF_DATA_SOURCE);
  return places;
}

fs::path data_directory() {
  if (const char* const chosen = std::getenv("NIPREF_DATA")) {
    if (holds_tables(chosen)) return chosen;
    throw BadInput("NIPREF_DATA", chosen, "must be a folder with a folder 'tables' in it");
  }
  for (const fs::path& place : places()) {
    if (holds_tables(place)) return fs::canonical(place);
  }
  throw BadInput(
      "NIPREF_DATA", "(not set)",
      "must be the data folder, no tables were found beside the program or where they were installed");
}

}  // namespace

std::filesystem::path tables_directory() { return data_directory() / "tables"; }

std::filesystem::path golden_directory() { return data_directory() / "golden"; }

std::filesystem::path scenes_directory() { return data_directory() / "scenes"; }

std::filesystem::path statements_directory() { return data_directory() / "statements"; }

std::filesystem::path templates_directory() { return data_directory() / "templates"; }

}  // namespace nipref::data
