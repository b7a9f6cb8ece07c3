#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

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

/// ref at the first points of a set, computed once for all methods.
struct Truth {
  std::vector<Reference> values;
  std::vector<double> envelopes;
};

Truth truth_of(const Quantity& quantity, const Columns& columns) {
  Truth truth;
  for (std::size_t i = 0; i < points_compared; ++i) {
    Point point;
    for (const auto& column : columns) point.push_back(column[i]);
    truth.values.push_back(ref_value(quantity, point, digits_beyond_double));
    truth.envelopes.push_back(quantity.envelope(point));
  }
  return truth;
}

void compare(std::span<const double> values, const Truth& truth, BenchRow& row) {
  double ulps = 0, relative = 0;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    const Deviation found = deviation(values[i], truth.values[i], truth.envelopes[i]);
    ulps = std::max(ulps, found.ulps);
    relative = std::max(relative, found.relative);
  }
  row.max_error_ulp = ulps;
  row.max_relative_error = relative;
}

std::vector<BenchRow> bench_range(const Quantity& quantity, const TimedRange& range,
                                  const std::vector<OtherKernel>& others) {
  const Columns columns = draw_columns(quantity, range);
  const std::vector<BatchMethod> contestants = methods(quantity, columns, others);
  std::vector<double> values(points_in_a_set);
  std::vector<Contender> contenders;
  for (const BatchMethod& method : contestants) {
    contenders.push_back({[&](std::size_t count) { method.evaluate(count, values); }, least_points,
                          points_in_a_set, method.seconds});
  }
  const std::vector<Timing> timings = time_interleaved(contenders, 15, 1e-3);

  const Truth truth = truth_of(quantity, columns);
  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    rows.push_back(timed_row(quantity.name, range_text(quantity, range), contestants[i].name, timings[i],
                             timings.front()));
    contestants[i].evaluate(points_compared, values);
    compare(std::span(values).first(points_compared), truth, rows.back());
  }
  return rows;
}

}  // namespace

std::vector<BenchRow> bench_double(const Quantity& quantity, const BenchProgress& progress,
                                   const std::vector<OtherKernel>& others) {
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
