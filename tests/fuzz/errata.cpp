#include <fstream>

#include <nipref/data/table/index.hpp>
#include <nipref/data/table/known_misses.hpp>

#include "reading.hpp"

using namespace nipref;

/// A folder with one of the tables and what is given as its errata: each run has one of its own, which is its working
/// folder.
void read_given(const std::string& text, const GivenFile&) {
  static const std::string table = "thesis-VIII.csv", errata = "errata.csv";
  static const bool is_there = std::filesystem::copy_file(data::tables_directory() / table, table,
                                                          std::filesystem::copy_options::overwrite_existing);
  if (!is_there) std::abort();
  std::ofstream(errata, std::ios::binary) << text;
  take_or_refuse([&] { static_cast<void>(data::summarize(data::load_table(table))); });
  take_or_refuse([&] { static_cast<void>(data::load_known_misses(errata)); });
}
