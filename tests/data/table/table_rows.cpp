#include <nipref/data/table/index.hpp>

#include "support/test.hpp"

// The redundancy of the thesis's tables, row by row: is there a contact (d0, L1, L2) that rounds to all cells of the
// row at once? This decides between corrections that single identities leave open, and shows that each correction is
// the only one.

using namespace nipref::data;

namespace {

/// The cells of one row as read, by column.
using Texts = std::map<std::string, std::string>;

/// Narrows the intervals of a row's unknowns until they no longer change; there is no answer if one becomes empty.
class Row {
 public:
  Row(const Table& table, const Texts& texts)
      : elastic_(!table.has_column("L1")),
        thickness_(table.parameter("B").value),
        diameter_(2 * table.parameter("R").value) {
    for (const auto& [column, text] : texts) {
      const auto& declared = table.columns[table.column_index(column)];
      cells_.emplace(column, read_printed_number(text, declared.scale_exponent).value().rounding);
    }
  }

  bool is_consistent() {
    for (auto& [name, unknown] : unknowns_) {
      if (cells_.contains(name)) narrow(unknown, cells_.at(name));
      if (cells_.contains(name + "/B")) narrow_by_ratio_to_thickness(unknown, name);
    }
    // A round narrows at least one of the few intervals noticeably, or is the last. 60 rounds are far more than any
    // row needs.
    for (int round = 0; round < 60 && !empty_; ++round) narrow_all();
    return !empty_;
  }

 private:
  void narrow(Interval& unknown, Interval by) {
    const double slack = 1e-13 * std::max(std::abs(by.lower), std::abs(by.upper));
    unknown.lower = std::max(unknown.lower, by.lower - slack);
    unknown.upper = std::min(unknown.upper, by.upper + slack);
    if (unknown.lower > unknown.upper) empty_ = true;
  }

  /// With B = 1 a column and its ratio to B are the same number printed twice. One rule of rounding then sends it to
  /// the same end of a tie, so that intervals that only touch, such as those of 162.3 and 162.4, do not agree.
  void narrow_by_ratio_to_thickness(Interval& unknown, const std::string& name) {
    const Interval ratio = cells_.at(name + "/B");
    narrow(unknown, {ratio.lower * thickness_, ratio.upper * thickness_});
    const bool only_touch = unknown.upper - unknown.lower <= 1e-12 * unknown.upper;
    if (thickness_ == 1 && cells_.contains(name) && only_touch) empty_ = true;
  }

  void narrow_all() {
    Interval& first = unknowns_.at("L1");
    Interval& second = unknowns_.at("L2");
    Interval& whole = unknowns_.at("L");
    narrow(whole, {first.lower + second.lower, first.upper + second.upper});
    narrow(first, {whole.lower - second.upper, whole.upper - second.lower});
    narrow(second, {whole.lower - first.upper, whole.upper - first.lower});
    if (elastic_) {  // symmetric: half the length on either side
      narrow(first, {whole.lower / 2, whole.upper / 2});
      narrow(second, first);
      narrow(unknowns_.at("d2"), unknowns_.at("d1"));
    }
    narrow_end(first, "d1");
    narrow_end(second, "d2");
  }

  /// d0 - end = length^2/(2R), and end/d0.
  void narrow_end(Interval& length, const std::string& name) {
    Interval& middle = unknowns_.at("d0");
    Interval& end = unknowns_.at(name);
    const Interval rise{length.lower * length.lower / diameter_, length.upper * length.upper / diameter_};
    narrow(middle, {end.lower + rise.lower, end.upper + rise.upper});
    narrow(end, {middle.lower - rise.upper, middle.upper - rise.lower});
    narrow(length, {std::sqrt(diameter_ * std::max(0.0, middle.lower - end.upper)),
                    std::sqrt(diameter_ * std::max(0.0, middle.upper - end.lower))});
    const auto ratio = cells_.find(name + "/d0");
    if (ratio == cells_.end()) return;
    narrow(end, {ratio->second.lower * middle.lower, ratio->second.upper * middle.upper});
    narrow(middle, {end.lower / ratio->second.upper, end.upper / ratio->second.lower});
  }

  bool elastic_;
  double thickness_;
  double diameter_;
  std::map<std::string, Interval> cells_;
  std::map<std::string, Interval> unknowns_{{"d0", {0, 1}},  {"d1", {0, 1}},  {"d2", {0, 1}},
                                            {"L1", {0, 10}}, {"L2", {0, 10}}, {"L", {0, 10}}};
  bool empty_ = false;
};

bool enters_identities(const TableColumn& column) {
  constexpr std::array<std::string_view, 4> outside{"creep", "p_max", "q_max", "muR"};
  return !column.is_key && std::find(outside.begin(), outside.end(), column.name) == outside.end();
}

bool is_consistent(const Table& table, const Texts& texts) { return Row(table, texts).is_consistent(); }

Texts trusted_texts(const Table& table, std::size_t row) {
  Texts texts;
  for (const auto& column : table.columns) {
    const TableCell& cell = table.cell(row, column.name);
    if (enters_identities(column) && cell.is_readable() && !cell.is_doubtful())
      texts[column.name] = cell.read_as;
  }
  return texts;
}

/// Calls visit(table, row) for each row of the thesis.
template <class Visit>
void for_each_row(Visit visit) {
  for (const auto& id : table_ids()) {
    if (!id.starts_with("thesis-")) continue;
    const Table table = load_table_by_id(id);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      CAPTURE(id, row + 1);
      visit(table, row);
    }
  }
}

/// Calls visit(table, row, column, cell) for each cell of the thesis that enters an identity and has an
/// erratum of `kind`.
template <class Visit>
void for_each_erratum(ErratumKind kind, Visit visit) {
  for_each_row([&](const Table& table, std::size_t row) {
    for (const auto& column : table.columns) {
      const TableCell& cell = table.cell(row, column.name);
      CAPTURE(column.name);
      if (enters_identities(column) && cell.erratum && cell.erratum->kind == kind)
        visit(table, row, column.name, cell);
    }
  });
}

/// The printed text with its glyphs corrected: a point for a comma, 0 for c and C, no blanks; nothing if the result is
/// no number.
std::optional<std::string> mended(std::string printed) {
  std::replace(printed.begin(), printed.end(), ',', '.');
  std::replace_if(
      printed.begin(), printed.end(), [](char letter) { return letter == 'c' || letter == 'C'; }, '0');
  std::erase(printed, ' ');
  if (!read_printed_number(printed, 0)) return std::nullopt;
  return printed;
}

/// The number that is `units` units of the last place away from `text`, with the same number of decimals.
std::string neighbour(const std::string& text, int units) {
  const std::size_t point = text.find('.');
  const std::size_t decimals = point == text.npos ? 0 : text.size() - point - 1;
  std::string digits = text;
  if (decimals > 0) digits.erase(point, 1);
  std::string changed = std::to_string(std::stol(digits) + units);
  if (changed.size() <= decimals) changed.insert(0, decimals + 1 - changed.size(), '0');
  if (decimals > 0) changed.insert(changed.size() - decimals, ".");
  return changed;
}

}  // namespace

TEST_CASE("the cells of each row of the thesis agree as a whole") {
  for_each_row(
      [](const Table& table, std::size_t row) { CHECK(is_consistent(table, trusted_texts(table, row))); });
}

TEST_CASE("a repair by identity is needed, and the only one: other readings contradict the row") {
  std::size_t repairs = 0, tried = 0;
  for_each_erratum(ErratumKind::identity, [&](const Table& table, std::size_t row, const std::string& column,
                                              const TableCell& cell) {
    const auto check_refused = [&](const std::string& text) {
      Texts texts = trusted_texts(table, row);
      texts[column] = text;
      CAPTURE(text);
      CHECK_FALSE(is_consistent(table, texts));
      ++tried;
    };
    const auto printed = mended(cell.printed);
    if (printed) {
      check_refused(*printed);
      ++repairs;
    }
    if (!printed || printed->size() != cell.read_as.size()) {
      for (const int units : {-1, 1}) check_refused(neighbour(cell.read_as, units));
      return;
    }
    for (std::size_t place = 0; place < printed->size(); ++place) {
      for (char digit = '0'; digit <= '9' && (*printed)[place] != '.'; ++digit) {
        std::string changed = *printed;
        changed[place] = digit;
        if (changed != *printed && changed != cell.read_as) check_refused(changed);
      }
    }
  });
  CHECK(repairs > 0);
  MESSAGE("cells repaired by identity that are printed as numbers: ", repairs, ", readings refused: ", tried);
}

TEST_CASE("doubtful cells contradict their row, and leaving one out removes the contradiction") {
  std::size_t rows = 0;
  for_each_row([&](const Table& table, std::size_t row) {
    Texts doubtful;
    for (const auto& column : table.columns) {
      const TableCell& cell = table.cell(row, column.name);
      if (enters_identities(column) && cell.is_doubtful()) doubtful[column.name] = cell.read_as;
    }
    if (doubtful.empty()) return;
    Texts all = trusted_texts(table, row);
    all.insert(doubtful.begin(), doubtful.end());
    CHECK_FALSE(is_consistent(table, all));
    for (const auto& [column, text] : doubtful) {
      Texts without = all;
      without.erase(column);
      CAPTURE(column);
      CHECK(is_consistent(table, without));
    }
    ++rows;
  });
  MESSAGE("rows with doubtful cells: ", rows);
}
