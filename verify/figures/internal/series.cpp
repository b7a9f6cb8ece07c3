#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <nipref/verify/figures/internal/series.hpp>
#include <nipref/verify/support/internal/cache.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {

std::vector<double> evenly(double first, double last, int count) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(std::lerp(first, last, i / (count - 1.0)));
  return x;
}

std::vector<double> logarithmically(double first, double last, int count) {
  std::vector<double> x = evenly(std::log10(first), std::log10(last), count);
  for (double& value : x) value = std::pow(10, value);
  return x;
}

std::vector<double> without(std::vector<double> x, const std::vector<double>& left_out) {
  std::erase_if(x, [&](double value) { return std::ranges::find(left_out, value) != left_out.end(); });
  return x;
}

Series sampled(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y) {
  Series series{std::move(label), std::move(role), mark, std::move(x), {}};
  for (const double place : series.x) series.y.push_back(y(place));
  return series;
}

Series computed(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y) {
  Series series{std::move(label), std::move(role), mark, std::move(x), {}};
  series.y.resize(series.x.size());
  parallel_for(series.x.size(), [&](std::size_t i) { series.y[i] = y(series.x[i]); }, {});
  return series;
}

Series printed_series(std::string label, const std::vector<PlacedRow>& rows, const std::string& column) {
  Series series{std::move(label), as_printed, Mark::bars, {}, {}};
  for (const PlacedRow& place : rows) {
    const data::TableCell& cell = place.replay->table.cell(place.row, column);
    if (!cell.is_printed() || !cell.is_readable() || cell.is_doubtful()) continue;
    series.x.push_back(place.printed_at);
    series.y.push_back(cell.number->value);
    series.low.push_back(cell.number->rounding.lower);
    series.high.push_back(cell.number->rounding.upper);
  }
  return series;
}

Series replayed_series(std::string label, const std::vector<PlacedRow>& rows, const std::string& column) {
  Series series{std::move(label), by_thesis, Mark::points, {}, {}};
  for (const PlacedRow& place : rows) {
    series.x.push_back(place.replayed_at);
    series.y.push_back(place.replay->nips[place.row].values.at(column));
  }
  return series;
}

double key_of_row(const data::Table& table, std::size_t row) {
  return table.cell(row, table.columns.front().name).number->value;
}

std::string axis_label(const std::string& quantity) {
  static const std::map<std::string, std::string> labels{
      {"p_max", "peak pressure p_max, psi"},
      {"L", "contact length L, in"},
      {"L/B", "contact length over thickness, L/B"},
      {"d0", "indentation d0, in"},
      {"d0/B", "indentation over thickness, d0/B"},
      {"creep", "creep ratio"},
      {"muR", "coefficient of rolling resistance mu_R"},
      {"pressure", "pressure p, psi"},
      {"normal_displacement", "normal displacement u, in"},
      {"tangential_displacement", "tangential displacement v, in"}};
  return labels.at(quantity);
}

bool differ_in(const std::vector<Replay>& replays, const std::string& parameter) {
  const double first = replays.front().table.parameter(parameter).value;
  return std::ranges::any_of(
      replays, [&](const Replay& replay) { return replay.table.parameter(parameter).value != first; });
}

std::string load_label(double load) { return fmt::format("W = {:g} lbf/in", load); }

std::string thickness_label(const Replay& replay) {
  return fmt::format("B = {:g} in", replay.table.parameter("B").value);
}

std::vector<Replay> replays_of(const std::vector<std::string>& ids) {
  static Cache<std::string, Replay> known;
  std::vector<Replay> replays;
  for (const std::string& id : ids) replays.push_back(*known.at(id, [&] { return replay_table(id); }));
  return replays;
}

}  // namespace nipref::verify
