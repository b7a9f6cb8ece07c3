#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/table/csv.hpp>

namespace nipref::data {

/// How it is known that a cell must be read otherwise than printed.
enum class ErratumKind {
  identity,  ///< other cells of the same row admit only one number, or only one that differs in one digit
  trend,     ///< weaker: a column that is smooth in every other row is broken by one digit, or other rows or
             ///< the twin column of the same table decide between numbers that the row admits
  replay,  ///< the replay decides between the corrections that the table leaves, with a stated chance of coincidence
  glyph,       ///< punctuation, blanks or a letter in the place of a point, a sign or a digit
  unreadable,  ///< nothing in the table settles it: no value, or the printed one, which is doubtful
};

inline constexpr std::array<std::string_view, 5> erratum_kind_names{"identity", "trend", "replay", "glyph",
                                                                    "unreadable"};

/// One line of errata.csv.
struct Erratum {
  std::string table;    ///< id, e.g. "thesis-VII"
  std::size_t row;      ///< from 1, in the order of the table
  std::string column;   ///< name in the table's own column line
  std::string printed;  ///< must equal the table's cell
  std::string read_as;  ///< plain number (a key may have an exponent); may be empty if kind is unreadable
  ErratumKind kind;
  std::string reason;
  TextPosition position;  ///< in errata.csv
};

/// Reads table,row,column,printed,read_as,kind,reason. Throws BadInput with file, line and column for a
/// malformed file, an unknown kind, a row that is no whole number from 1, an empty reason, an empty read_as
/// though the kind is not unreadable, or two lines for one cell.
[[nodiscard]] std::vector<Erratum> load_errata(const std::filesystem::path& file);

/// One line of known_misses.csv: a cell that no replay reproduces although nothing in its table contradicts it. The
/// cell was examined and stays as printed.
struct KnownMiss {
  std::string table;   ///< id, e.g. "thesis-VII"
  std::size_t row;     ///< from 1, in the order of the table
  std::string column;  ///< name in the table's own column line
  std::string note;    ///< what was found; may be empty
};

/// Reads table,row,column,note. Throws BadInput with file, line and column for a malformed file, a row that is no
/// whole number from 1, or two lines for one cell.
[[nodiscard]] std::vector<KnownMiss> load_known_misses(const std::filesystem::path& file);

}  // namespace nipref::data
