#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// What a row of data/statements/figures.csv asks a drawing to show.
struct FigureSubject {
  std::string text;                ///< the row's field `of`
  std::vector<std::string> words;  ///< the words of that field
  std::vector<std::string> tables;

  FigureSubject(const std::string& of, const std::string& numbers, const std::string& table_ids);

  /// The list of that name in the row's field `numbers`: "evenly A B N" and "ratios A B N" are N numbers from A to B,
  /// "without A" leaves one out, all else are numbers; each in this unit.
  [[nodiscard]] std::vector<double> numbers(const std::string& name, double unit = 1) const;
  /// The only number of such a list.
  [[nodiscard]] double number(const std::string& name) const { return numbers(name).front(); }
  /// The tables, replayed.
  [[nodiscard]] std::vector<Replay> replays() const;

 private:
  std::map<std::string, std::vector<std::string>> lists_;
};

/// The panels of each kind of figure, by its name in the column `drawing`.
using Drawings = std::map<std::string, std::vector<Panel> (*)(const FigureSubject&)>;

Drawings sheet_drawings();       ///< sheets under line loads, thesis 7-13, 32-38
Drawings nip_drawings();         ///< numbers of nips, thesis 15, 17-25, 41-48, 50, 51
Drawings profile_drawings();     ///< along and inside nips, thesis 26-29, 49, 52, 53, ch. III
Drawings half_space_drawings();  ///< behind the papers' tables

// Where series are from, as the figures' keys call it.
inline const std::string of_continuum = "continuous contact", by_thesis = "thesis's method",
                         as_printed = "printed", at_largest = "largest";

/// Numbers from `first` to `last`, both included, in equal steps.
std::vector<double> evenly(double first, double last, int count);

using Curve = std::function<double(double)>;

/// A series of `y` at these places, one after the other.
Series sampled(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y);

/// Likewise, from several threads at once.
Series computed(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y);

/// A cell of a replayed table along an axis.
struct PlacedCell {
  const Replay* replay;
  std::size_t row;
  std::string column;
  double printed_at;   ///< on the axis, by the table
  double replayed_at;  ///< by the replay, which may be at a load of its own
};

/// What the seed's method gives there, at the inputs as printed.
Series replayed_series(std::string label, std::string role, const std::vector<PlacedCell>& cells);

/// What the tables have in these cells, with its rounding. Cells that cannot be read and cells in doubt are left out.
Series printed_series(std::string label, const std::vector<PlacedCell>& cells);

/// The value of a row's key, in base units.
double key_of_row(const data::Table& table, std::size_t row);

/// What tables call a column and scenes a profile, as the label of an axis.
std::string axis_label(const std::string& quantity);

}  // namespace nipref::verify
