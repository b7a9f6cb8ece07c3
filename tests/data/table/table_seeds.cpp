#include <nipref/data/table/index.hpp>

#include "support/paths.hpp"
#include "support/unfolded.hpp"

// The cells are text of the seed itself: each cell is looked for between the words before and after its table.

using namespace nipref::data;

namespace {

bool continues_a_word(std::string_view text, std::size_t position) {
  return position < text.size() && std::isalnum(static_cast<unsigned char>(text[position])) != 0;
}

/// The number of times that `cell` stands in `text` as a whole, with no letter or digit beside it.
std::size_t occurrences(std::string_view text, std::string_view cell) {
  std::size_t count = 0;
  for (std::size_t at = text.find(cell); at != text.npos; at = text.find(cell, at + 1)) {
    const bool starts = at == 0 || !continues_a_word(text, at - 1);
    if (starts && !continues_a_word(text, at + cell.size())) ++count;
  }
  return count;
}

/// The seed's text between the marks of a table. Both marks must be there exactly once, in order.
std::string_view between_marks(std::string_view seed, const Table& table) {
  const std::string after = unfolded(table.after);
  const std::string before = unfolded(table.before);
  for (const auto& mark : {after, before}) {
    CAPTURE(mark);
    REQUIRE(seed.find(mark) != seed.npos);
    REQUIRE(seed.find(mark) == seed.rfind(mark));
  }
  const std::size_t start = seed.find(after) + after.size();
  const std::size_t end = seed.find(before);
  REQUIRE(start < end);
  return seed.substr(start, end - start);
}

}  // namespace

TEST_CASE("every cell stands in its seed, at least as often as in its table") {
  const std::filesystem::path seeds = seeds_directory();
  if (!std::filesystem::is_directory(seeds)) {
    MESSAGE("skipped: the folder of the seeds is not there: ", seeds.string());
    return;
  }
  std::size_t cells = 0;
  for (const auto& id : table_ids()) {
    const Table table = load_table_by_id(id);
    const std::string seed = unfolded(text_of_file(seeds / table.source));
    const std::string_view text = between_marks(seed, table);
    std::map<std::string, std::size_t> wanted;
    for (const auto& row : table.rows) {
      for (const auto& cell : row) {
        if (!cell.is_printed()) continue;
        ++wanted[cell.printed];
        ++cells;
      }
    }
    for (const auto& [cell, count] : wanted) {
      CAPTURE(id, cell);
      CHECK(occurrences(text, cell) >= count);
    }
  }
  MESSAGE("cells found in the seeds, row labels included: ", cells);
}
