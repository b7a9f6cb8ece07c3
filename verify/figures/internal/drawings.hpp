#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// The fields of a row of data/statements/figures.csv that say what a drawing shows.
struct FigureSubject {
  std::string text;                ///< the row's field `of`
  std::vector<std::string> words;  ///< the words of that field
  std::vector<std::string> tables;

  FigureSubject(const std::string& of, const std::string& numbers, const std::string& table_ids);

  /// The list of that name in the row's field `numbers`: "evenly A B N" and "ratios A B N" are N numbers from A to B,
  /// "without A" leaves one out, all other words are numbers. Each is multiplied by the unit.
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
Drawings nip_drawings();         ///< numbers of nips, along and inside them, thesis 15, 17-29, 41-53, ch. III
Drawings half_space_drawings();  ///< curves of the papers' tables
Drawings partial_slip_drawings();  ///< nips with Coulomb's friction

// Roles of series, as the figures' keys name them.
inline const std::string of_continuum = "continuous contact", by_thesis = "thesis's method",
                         as_printed = "printed", at_largest = "largest";

/// Numbers from `first` to `last`, both included, in equal steps.
std::vector<double> evenly(double first, double last, int count);

using Curve = std::function<double(double)>;

/// A series with the values of `y` at these places.
Series sampled(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y);

/// The same, computed in several threads.
Series computed(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y);

/// A cell of a replayed table, with its place on an axis.
struct PlacedCell {
  const Replay* replay;
  std::size_t row;
  std::string column;
  double printed_at;   ///< by the table
  double replayed_at;  ///< by the replay, which may have found another load
};

/// The values of the seed's method in these cells, from the inputs as printed.
Series replayed_series(std::string label, std::string role, const std::vector<PlacedCell>& cells);

/// The printed values of these cells, with their rounding intervals. Illegible and doubtful cells are left out.
Series printed_series(std::string label, const std::vector<PlacedCell>& cells);

/// The label of an axis for a column of a table or a profile of a scene.
std::string axis_label(const std::string& quantity);

}  // namespace nipref::verify
