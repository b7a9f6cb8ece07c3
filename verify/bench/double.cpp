#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/timed_row.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t points_in_a_set = 4096;
constexpr std::size_t least_points = 32;
constexpr std::size_t points_compared = 400;
constexpr std::size_t costly_points = 12;
constexpr double seconds_of_costly_truth = 5;
constexpr std::array tolerances{1e-3, 1e-6, 1e-9, 1e-12, fast::Accuracy::best_rtol};

struct TimedRange {
  std::string name;
  double lower;
  double upper;
  bool logarithmic;
};

/// The first range is the one that the promised ratios are about.
std::vector<TimedRange> ranges(const Quantity& quantity) {
  std::vector<TimedRange> all{{"[1e-6,20] log-uniform", 1e-6, 20, true}};
  if (quantity.peers.empty()) return all;
  all.push_back({"(0,20] uniform", 0, 20, false});
  all.push_back({"[1e-6,1e-3]", 1e-6, 1e-3, true});
  all.push_back({"[1e-3,1]", 1e-3, 1, true});
  all.push_back({"[1,20]", 1, 20, true});
  all.push_back({"[20,300]", 20, 300, true});
  return all;
}

using Columns = std::vector<std::vector<double>>;

double representative(ArgumentKind kind, const TimedRange& range, Random& random) {
  switch (kind) {
    case ArgumentKind::nonzero_position:
    case ArgumentKind::position:
      // Upper end included, lower end not.
      return range.logarithmic ? random.log_uniform(range.lower, range.upper)
                               : range.upper - random.uniform() * (range.upper - range.lower);
    case ArgumentKind::young:
      return 1;
    case ArgumentKind::poisson:
      return 0.3;
    case ArgumentKind::index:
      return std::floor(random.log_uniform(1, 1000));
    default:  // see draw_columns
      return 0;
  }
}

Columns draw_columns(const Quantity& quantity, const TimedRange& range) {
  Random random("bench " + quantity.name + range.name);
  Columns columns;
  if (quantity.draw) {
    columns.resize(quantity.arguments.size());
    for (std::size_t i = 0; i < points_in_a_set; ++i) {
      const Point point = quantity.draw(random);
      for (std::size_t j = 0; j < point.size(); ++j) columns[j].push_back(point[j]);
    }
    return columns;
  }
  for (const Argument& argument : quantity.arguments) {
    columns.emplace_back();
    for (std::size_t i = 0; i < points_in_a_set; ++i) {
      columns.back().push_back(representative(argument.kind, range, random));
    }
  }
  return columns;
}

std::string range_text(const Quantity& quantity, const TimedRange& range) {
  const ArgumentKind kind = quantity.arguments.front().kind;
  if (kind == ArgumentKind::index) return "n in [1,1000] log-uniform";
  if (quantity.draw) return "as in the audit";
  return fmt::format("{} in {}", quantity.arguments.front().name, range.name);
}

/// A method fills values[0, count) for the first `count` points.
struct BatchMethod {
  std::string name;
  std::function<void(std::size_t count, std::span<double> values)> evaluate;
  std::function<double(std::size_t count, std::size_t passes)> seconds = {};  ///< see Contender
};

std::string tolerance_name(double rtol) {
  return rtol == fast::Accuracy::best_rtol ? "full" : fmt::format("rtol={:.0e}", rtol);
}

/// The first `count` values of each column.
std::vector<std::span<const double>> heads(const Columns& columns, std::size_t count) {
  std::vector<std::span<const double>> parts;
  for (const auto& column : columns) parts.push_back(std::span(column).first(count));
  return parts;
}

BatchMethod scalar_method(const Quantity& quantity, const Columns& columns, double rtol) {
  return {"fast " + tolerance_name(rtol),
          [&, accuracy = fast::Accuracy(rtol)](std::size_t count, std::span<double> values) {
            quantity.by_fast_loop(heads(columns, count), values.first(count), accuracy);
          }};
}

BatchMethod batch_method(const Quantity& quantity, const Columns& columns, double rtol) {
  return {"fast batch " + tolerance_name(rtol),
          [&, accuracy = fast::Accuracy(rtol)](std::size_t count, std::span<double> values) {
            quantity.by_fast_batch(heads(columns, count), values.first(count), accuracy);
          }};
}

BatchMethod peer_method(const Peer& peer, const Columns& columns) {
  return {peer.method, [evaluate = peer.make(), &columns](std::size_t count, std::span<double> values) {
            for (std::size_t i = 0; i < count; ++i) values[i] = evaluate(columns[0][i]);
          }};
}

std::vector<Point> points_of(const Columns& columns) {
  std::vector<Point> points(columns.front().size());
  for (const auto& column : columns) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i].push_back(column[i]);
  }
  return points;
}

BatchMethod kernel_method(const OtherKernel& other, const Columns& columns) {
  const auto points = std::make_shared<const std::vector<Point>>(points_of(columns));
  return {other.name,
          [=](std::size_t count, std::span<double> values) {
            other.kernel->evaluate(std::span(*points).first(count), values.first(count));
          },
          [=](std::size_t count, std::size_t passes) {
            // What fails is infinitely slow; its values, which are none, say so too.
            return other.kernel->seconds(std::span(*points).first(count), passes)
                .value_or(std::numeric_limits<double>::infinity());
          }};
}

std::vector<BatchMethod> methods(const Quantity& quantity, const Columns& columns,
                                 const std::vector<OtherKernel>& others) {
  std::vector<BatchMethod> all{scalar_method(quantity, columns, fast::Accuracy::best_rtol)};
  if (quantity.by_fast_batch) all.push_back(batch_method(quantity, columns, fast::Accuracy::best_rtol));
  for (const OtherKernel& other : others) {
    if (other.quantity == quantity.name) all.push_back(kernel_method(other, columns));
  }
  if (quantity.peers.empty()) return all;
  for (const double rtol : tolerances) {
    if (rtol == fast::Accuracy::best_rtol) continue;
    all.push_back(scalar_method(quantity, columns, rtol));
    all.push_back(batch_method(quantity, columns, rtol));
  }
  for (const Peer& peer : quantity.peers) all.push_back(peer_method(peer, columns));
  return all;
}

/// What is right at one of a set's points.
struct Truth {
  std::size_t number;
  ref::Estimate value;
  double envelope;
};

Truth truth_at(const Quantity& quantity, const Columns& columns, std::size_t number) {
  Point point;
  for (const auto& column : columns) point.push_back(column[number]);
  return {number, ref_value(quantity, point, digits_beyond_double), quantity.envelope(point)};
}

/// ref at the first points of a set, computed once for all methods.
std::vector<Truth> first_truths(const Quantity& quantity, const Columns& columns) {
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < points_compared; ++i) truths.push_back(truth_at(quantity, columns, i));
  return truths;
}

void compare(std::span<const double> values, const std::vector<Truth>& truths, BenchRow& row) {
  double ulps = 0, relative = 0;
  for (const Truth& truth : truths) {
    const Deviation found = deviation(values[truth.number], truth.value, truth.envelope);
    ulps = std::max(ulps, found.ulps);
    relative = std::max(relative, found.relative);
  }
  row.max_error_ulp = ulps;
  row.max_relative_error = relative;
}

/// What all methods are given.
struct Trial {
  std::string arguments;
  Columns columns;
  std::size_t least;  ///< points in a round
  int rounds;
};

std::vector<BenchRow> rows_of(const Quantity& quantity, const Trial& trial, const std::vector<Truth>& truths,
                              const std::vector<OtherKernel>& others) {
  const std::vector<BatchMethod> contestants = methods(quantity, trial.columns, others);
  std::vector<double> values(trial.columns.front().size());
  std::vector<Contender> contenders;
  for (const BatchMethod& method : contestants) {
    contenders.push_back({[&](std::size_t count) { method.evaluate(count, values); }, trial.least,
                          values.size(), method.seconds});
  }
  const std::vector<Timing> timings = time_interleaved(contenders, trial.rounds, 1e-3);

  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    rows.push_back(
        timed_row(quantity.name, trial.arguments, contestants[i].name, timings[i], timings.front()));
    if (truths.empty()) continue;
    contestants[i].evaluate(truths.back().number + 1, values);
    compare(values, truths, rows.back());
  }
  return rows;
}

std::vector<BenchRow> bench_range(const Quantity& quantity, const TimedRange& range,
                                  const std::vector<OtherKernel>& others) {
  const Trial trial{range_text(quantity, range), draw_columns(quantity, range), least_points, 15};
  return rows_of(quantity, trial, first_truths(quantity, trial.columns), others);
}

/// Points of the audit that fast takes.
Columns draw_costly_columns(const Quantity& quantity) {
  Random random("bench " + quantity.name);
  Columns columns(quantity.arguments.size());
  while (columns.front().size() < costly_points) {
    const Point point = quantity.draw(random);
    if (std::isnan(fast_value(quantity, point, {}))) continue;
    for (std::size_t j = 0; j < point.size(); ++j) columns[j].push_back(point[j]);
  }
  return columns;
}

/// ref where it answers, as far as a few seconds go.
std::vector<Truth> costly_truths(const Quantity& quantity, const Columns& columns) {
  std::vector<Truth> truths;
  double left = seconds_of_costly_truth;
  for (std::size_t i = 0; i < costly_points && left > 0; ++i) {
    left -= seconds_of([&] {
      try {
        truths.push_back(truth_at(quantity, columns, i));
      } catch (const data::BadInput&) {  // fast's domain is larger
      }
    });
  }
  return truths;
}

std::vector<BenchRow> bench_costly(const Quantity& quantity, const std::vector<OtherKernel>& others) {
  const Trial trial{fmt::format("as in the audit, {} points", costly_points), draw_costly_columns(quantity),
                    costly_points, 3};
  return rows_of(quantity, trial, costly_truths(quantity, trial.columns), others);
}

}  // namespace

std::vector<BenchRow> bench_double(const Quantity& quantity, const BenchProgress& progress,
                                   const std::vector<OtherKernel>& others) {
  if (quantity.is_costly) return bench_costly(quantity, others);
  std::vector<BenchRow> rows;
  for (const TimedRange& range : ranges(quantity)) {
    if (interrupted()) break;
    if (progress) progress(range.name);
    std::vector<BenchRow> more = bench_range(quantity, range, others);
    rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return rows;
}

}  // namespace nipref::verify
