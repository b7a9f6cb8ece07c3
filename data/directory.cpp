#include <cstdlib>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/directory.hpp>

namespace nipref::data {
namespace {

bool holds_tables(const std::filesystem::path& folder) {
  return std::filesystem::is_directory(folder / "tables");
}

std::filesystem::path data_directory() {
  if (const char* const chosen = std::getenv("NIPREF_DATA")) {
    if (holds_tables(chosen)) return chosen;
    throw BadInput("NIPREF_DATA", chosen, "must be a folder with a folder 'tables' in it");
  }
  for (const char* const place : {NIPREF_DATA_DIR, NIPREF_DATA_INSTALL_DIR}) {
    if (holds_tables(place)) return place;
  }
  throw BadInput("NIPREF_DATA", "(not set)",
                 "must be the data folder, the tables were not found where they were built or installed");
}

}  // namespace

std::filesystem::path tables_directory() { return data_directory() / "tables"; }

std::filesystem::path scenes_directory() { return data_directory() / "scenes"; }

}  // namespace nipref::data
