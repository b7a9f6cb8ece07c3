#include <nipref/data/table/csv.hpp>
#include <nipref/data/table/table.hpp>

#include "support/scratch.hpp"
#include "support/table_rows.hpp"

// The reader of the tables: numbers with their rounding intervals, and malformed files.

using namespace nipref::data;

namespace {

const std::string header =
    "# title: T\n# source: S\n# after: A\n# before: B\n# parameter: B = 2 in; thickness\n"
    "# key: W; lbf/in; load\n# column: L; 1e3; in; length\n";

/// The message with which the file is refused, without the folder's name.
std::string refusal(const auto& load, const std::filesystem::path& file) {
  const std::string message = refusal_of([&] { return load(file); });
  return message.substr(message.rfind('/') + 1);
}

std::string refusal_of_table(const std::string& table, const std::string& errata = "") {
  const ScratchFolder folder;
  if (!errata.empty()) folder.write("errata.csv", "table,row,column,printed,read_as,kind,reason\n" + errata);
  return refusal(load_table, folder.write("t.csv", table));
}

}  // namespace

TEST_CASE("a printed number stands for all values that round to it") {
  const auto number = read_printed_number("57.9", 3);
  REQUIRE(number);
  CHECK(number->value == 0.0579);
  CHECK(number->rounding.lower == 0.05785);
  CHECK(number->rounding.upper == 0.05795);
}

TEST_CASE("trailing zeros narrow the rounding interval, signs mirror it") {
  for (const char* const digits : {"0", "7", "100", "0.0", "999.95", "10.000", "1907", "0.3527"}) {
    for (const int scale : {-2, 0, 3, 6}) {
      CAPTURE(digits, scale);
      const std::string text = digits;
      const bool has_point = text.find('.') != text.npos;
      const auto number = read_printed_number(text, scale);
      const auto finer = read_printed_number(text + (has_point ? "0" : ".0"), scale);
      const auto negative = read_printed_number("-" + text, scale);
      REQUIRE((number && finer && negative));
      const double width = number->rounding.upper - number->rounding.lower;
      const double unit =
          std::pow(10.0, -static_cast<double>(has_point ? text.size() - text.find('.') - 1 : 0) - scale);
      CHECK(width == doctest::Approx(unit).epsilon(1e-9));
      CHECK(finer->rounding.upper - finer->rounding.lower == doctest::Approx(unit / 10).epsilon(1e-9));
      CHECK(finer->value == number->value);
      CHECK(negative->rounding.lower == -number->rounding.upper);
      CHECK(negative->rounding.upper == -number->rounding.lower);
      CHECK(number->rounding.lower < number->value);
      CHECK(number->value < number->rounding.upper);
    }
  }
}

TEST_CASE("a lost digit stands for all digits") {
  const auto number = read_printed_number("118?", 0);
  REQUIRE(number);
  CHECK(number->rounding.lower == 1179.5);
  CHECK(number->rounding.upper == 1189.5);
  CHECK(number->value == 1184.5);
  const auto negative = read_printed_number("-2.?4", 1);
  REQUIRE(negative);
  CHECK(negative->rounding.lower == -0.2945);
  CHECK(negative->rounding.upper == -0.2035);
}

TEST_CASE("what is not a plain number is not read as one") {
  for (const char* const text : {"", "?.", "-?-", "-", ".5", "5.", "1e3", "5,5", " 5", "5 ", "0x5", "nan",
                                 "inf", "1.2.3", "--5", "+", "."}) {
    CAPTURE(text);
    CHECK_FALSE(read_printed_number(text, 0));
  }
  for (const int scale : {400, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
    CHECK_FALSE(read_printed_number("1.5", scale));
  CHECK_FALSE(read_exact_number("1e999"));
  CHECK_FALSE(read_exact_number("1 "));
  CHECK(read_exact_number("1e-3") == 1e-3);
}

TEST_CASE("a well-formed table is read with its errata") {
  const ScratchFolder folder;
  folder.write("errata.csv",
               "table,row,column,printed,read_as,kind,reason\n"
               "other,1,L,1,2,identity,of another table\n"
               "t,1,L,\"5,5\",5.5,glyph,\"comma, not a \"\"point\"\"\"\n"
               "t,2,L,,,unreadable,nothing there\n"
               "t,3,L,7.1,7.1,unreadable,stays\n");
  const Table table = load_table(folder.write("t.csv", header + "W,L\n1e1,\"5,5\"\n2,\n3,7.1\n"));
  CHECK(table.id == "t");
  CHECK(table.parameter("B").value == 2);
  CHECK(table.cell(0, "W").number->rounding.upper == 10);
  CHECK(table.cell(0, "L").printed == "5,5");
  CHECK(table.cell(0, "L").number->value == 0.0055);
  CHECK(table.cell(0, "L").erratum->reason == "comma, not a \"point\"");
  CHECK_FALSE(table.cell(1, "L").is_printed());
  CHECK_FALSE(table.cell(1, "L").is_readable());
  CHECK(table.cell(2, "L").is_doubtful());
}

TEST_CASE("a coordinate in a column's name is read") {
  const ScratchFolder folder;
  const Table table = load_table(folder.write(
      "t.csv",
      "# title: T\n# source: S\n# after: A\n# before: B\n# column: c=0.25; 1; 1; ratio\nc=0.25\n1\n"));
  CHECK(table.columns[0].coordinate == 0.25);
}

TEST_CASE("a malformed table, header or erratum is refused with file, line and column") {
  const std::string good = header + "W,L\n1,2.5\n";
  CHECK(refusal_of_table(good, "t,1,L,2.5,2.6,identity,why\n") == "accepted");
  const auto rows = table_rows("data/table/refusals.txt");
  CHECK(rows.size() > 25);
  for (const auto& row : rows) {
    CAPTURE(row[0]);
    const std::string table = replaced_in(replaced_in(row.at(1), "{header}", header), "{table}", good);
    CHECK(refusal_of_table(table, row.size() > 2 ? row[2] : "") == row[0]);
  }
}

TEST_CASE("known misses that are malformed are refused with file, line and column") {
  const ScratchFolder folder;
  const auto refusal_of_misses = [&](const std::string& text) {
    return refusal(load_known_misses, folder.write("known_misses.csv", text));
  };
  const std::string columns = "table,row,column,note\n";
  CHECK(refusal_of_misses(columns + "t,1,L,\nt,1,M,\"a, b\"\nt,2,L,\n") == "accepted");
  CHECK(refusal_of_misses("table,row,column\nt,1,L\n") ==
        "known_misses.csv:1:1: must be table,row,column,note");
  CHECK(refusal_of_misses(columns + "t,0,L,\n") == "known_misses.csv:2:3: must be a row number from 1");
  CHECK(refusal_of_misses(columns + "t,1.5,L,\n") == "known_misses.csv:2:3: must be a row number from 1");
  CHECK(refusal_of_misses(columns + "t,1,L,\nt,1,L,again\n") ==
        "known_misses.csv:3:1: must be the only line for its cell");
}

TEST_CASE("a line may be as long as is stated and no longer, with an end or without") {
  const ScratchFolder folder;
  const std::string longest(longest_csv_line, 'x');
  for (const std::string end : {"", "\n"})
    CHECK(read_csv(folder.write("t.csv", "a\n" + longest + end)).records[1][0].text == longest);
  CHECK(refusal(load_table, folder.write("t.csv", "a\n" + longest + "x\n")) ==
        "t.csv:2:65537: must have lines of at most 65536 bytes");
}

TEST_CASE("a byte order mark is left out, semicolons between fields are refused as such") {
  const ScratchFolder folder;
  const CsvFile marked = read_csv(folder.write("t.csv", "\xef\xbb\xbf# of a spreadsheet\na,b\n1,2\n"));
  CHECK(marked.comments.at(0).text == "of a spreadsheet");
  const CsvFile bare = read_csv(folder.write("t.csv", "\xef\xbb\xbf\141,b\n1,2\n"));
  CHECK(bare.records.at(0).at(0).text == "a");
  CHECK(refusal(load_table, folder.write("t.csv", "a;b\n1;2\n")) ==
        "t.csv:1:2: must have no semicolon: fields are separated by commas, numbers have decimal points");
}

TEST_CASE("a file that is not there is refused") {
  const ScratchFolder folder;
  CHECK(refusal(load_table, folder.write("t.csv", "").parent_path() / "absent.csv") ==
        "absent.csv: must be a file that exists: there is none of that name");
}
