#pragma once
#include <functional>
#include <string>
#include <vector>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

// Where series are from, as the figures' keys call it.
inline const std::string of_continuum = "continuous contact", by_thesis = "thesis's method",
                         as_printed = "printed", at_largest = "largest";

/// Numbers from `first` to `last`, both included, in equal steps or equal ratios.
std::vector<double> evenly(double first, double last, int count);
std::vector<double> logarithmically(double first, double last, int count);

/// Those of `x` that are not among `left_out`.
std::vector<double> without(std::vector<double> x, const std::vector<double>& left_out);

using Curve = std::function<double(double)>;

/// A series of `y` at these places, one after the other.
Series sampled(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y);

/// Likewise, from several threads at once.
Series computed(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y);

/// Rows of replayed tables along an axis.
struct PlacedRow {
  const Replay* replay;
  std::size_t row;
  double printed_at;   ///< on the axis, by the table
  double replayed_at;  ///< by the replay, which is at a load of its own
};

/// What the tables have in a column, with its rounding. Cells that cannot be read and cells in doubt are left out.
Series printed_series(std::string label, const std::vector<PlacedRow>& rows, const std::string& column);

/// What the thesis's method gives there, at the inputs as printed.
Series replayed_series(std::string label, const std::vector<PlacedRow>& rows, const std::string& column);

/// The value of a row's key, in base units.
double key_of_row(const data::Table& table, std::size_t row);

/// What tables call a column and scenes a profile, as the label of an axis.
std::string axis_label(const std::string& quantity);

/// Whether the tables have different values of this parameter.
bool differ_in(const std::vector<Replay>& replays, const std::string& parameter);

/// "W = 100 lbf/in", "B = 1 in"
std::string load_label(double load);
std::string thickness_label(const Replay& replay);

/// The tables of these ids, replayed.
std::vector<Replay> replays_of(const std::vector<std::string>& ids);

}  // namespace nipref::verify
