#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/audit/internal/error_tally.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/mapped.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t points_in_a_set = 4096;
constexpr std::size_t least_points = 32;
constexpr std::size_t points_compared = 1000;  ///< the fewest of which 99.9 % are not all
constexpr std::size_t costly_points = 12;
constexpr double seconds_of_costly_truth = 5, unlimited = std::numeric_limits<double>::infinity();
constexpr std::array coarse_tolerances{1e-3, 1e-6, 1e-9, 1e-12};

struct TimedRange {
  std::string name;
  double lower;
  double upper;
  bool logarithmic;
};

/// Only the first range if there is no other library to compare with.
std::vector<TimedRange> ranges(const Quantity& quantity) {
  std::vector<TimedRange> all{{"[1e-6,20] log-uniform", 1e-6, 20, true},
                              {"(0,20] uniform", 0, 20, false},
                              {"[1e-6,1e-3]", 1e-6, 1e-3, true},
                              {"[1e-3,1]", 1e-3, 1, true},
                              {"[1,20]", 1, 20, true},
                              {"[20,300]", 20, 300, true}};
  if (quantity.peers.empty()) all.resize(1);
  return all;
}

using Columns = std::vector<std::vector<double>>;

double representative(ArgumentKind kind, const TimedRange& range, Random& random) {
  switch (kind) {
    case ArgumentKind::nonzero_position:
    case ArgumentKind::position:
      // The upper end is included, the lower end is not.
      return range.logarithmic ? random.log_uniform(range.lower, range.upper)
                               : range.upper - random.uniform() * (range.upper - range.lower);
    case ArgumentKind::young:
      return 1;
    case ArgumentKind::poisson:
      return 0.3;
    case ArgumentKind::index:
      return std::floor(random.log_uniform(1, 1000));
    default:  // quantities with other arguments draw their points themselves
      return 0;
  }
}

Columns draw_columns(const Quantity& quantity, const TimedRange& range) {
  Random random("bench " + quantity.name + range.name);
  Columns columns(quantity.arguments.size(), std::vector<double>(points_in_a_set));
  for (std::size_t i = 0; quantity.draw && i < points_in_a_set; ++i) {
    const Point point = quantity.draw(random);
    for (std::size_t j = 0; j < point.size(); ++j) columns[j][i] = point[j];
  }
  for (std::size_t j = 0; !quantity.draw && j < columns.size(); ++j)
    std::ranges::generate(columns[j],
                          [&] { return representative(quantity.arguments[j].kind, range, random); });
  return columns;
}

std::string range_text(const Quantity& quantity, const TimedRange& range) {
  const ArgumentKind kind = quantity.arguments.front().kind;
  if (kind == ArgumentKind::index) return "n in [1,1000] log-uniform";
  if (quantity.draw) return "as in the audit";
  return fmt::format("{} in {}", quantity.arguments.front().name, range.name);
}

/// Fills values[0, count) for the first `count` points.
using Fill = std::function<void(std::size_t count, std::span<double> values)>;

struct BatchMethod {
  std::string name;
  Fill evaluate;
  std::function<double(std::size_t count, std::size_t passes)> seconds = {};  ///< see Contender
};

/// The first `count` values of each column.
std::vector<std::span<const double>> heads(const Columns& columns, std::size_t count) {
  return mapped(columns, [&](const auto& column) { return std::span(column).first(count); });
}

BatchMethod fast_method(const std::string& name, const auto& evaluate, const Columns& columns, double rtol) {
  return {name + (rtol == fast::Accuracy::best_rtol ? "full" : fmt::format("rtol={:.0e}", rtol)),
          [&, accuracy = fast::Accuracy(rtol)](std::size_t count, std::span<double> values) {
            evaluate(heads(columns, count), values.first(count), accuracy);
          }};
}

BatchMethod peer_method(const Peer& peer, const Columns& columns) {
  return {peer.method, [evaluate = peer.make(), &columns](std::size_t count, std::span<double> values) {
            for (std::size_t i = 0; i < count; ++i) values[i] = evaluate(columns[0][i]);
          }};
}

Point point_at(const Columns& columns, std::size_t number) {
  return mapped(columns, [&](const auto& column) { return column[number]; });
}

BatchMethod kernel_method(const OtherKernel& other, const Columns& columns) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < columns.front().size(); ++i) points.push_back(point_at(columns, i));
  const auto shared = std::make_shared<const std::vector<Point>>(std::move(points));
  return {other.name,
          [=](std::size_t count, std::span<double> values) {
            other.kernel->evaluate(std::span(*shared).first(count), values.first(count));
          },
          [=](std::size_t count, std::size_t passes) {
            // A kernel that fails counts as infinitely slow; it also has no values.
            return other.kernel->seconds(std::span(*shared).first(count), passes).value_or(unlimited);
          }};
}

std::vector<BatchMethod> methods(const Quantity& quantity, const Columns& columns,
                                 const std::vector<OtherKernel>& others) {
  std::vector<BatchMethod> all;
  const auto add_fast = [&](double rtol) {
    all.push_back(fast_method("fast ", quantity.by_fast_loop, columns, rtol));
    if (quantity.by_fast_batch)
      all.push_back(fast_method("fast batch ", quantity.by_fast_batch, columns, rtol));
  };
  add_fast(fast::Accuracy::best_rtol);
  for (const OtherKernel& other : others) {
    if (other.quantity == quantity.name) all.push_back(kernel_method(other, columns));
  }
  if (quantity.peers.empty()) return all;
  for (const double rtol : coarse_tolerances) add_fast(rtol);
  for (const Peer& peer : quantity.peers) all.push_back(peer_method(peer, columns));
  return all;
}

/// The reference's value at one of a set's points.
struct Truth {
  std::size_t number;
  ref::Estimate value;
  double envelope;
};

Truth truth_at(const Quantity& quantity, const Columns& columns, std::size_t number) {
  const Point point = point_at(columns, number);
  return {number, ref_value(quantity, point, digits_beyond_double), quantity.envelope(point)};
}

/// The reference's values at the first `count` points, or at as many as it computes in these seconds, without those that it
/// refuses.
std::vector<Truth> first_truths(const Quantity& quantity, const Columns& columns, std::size_t count,
                                double seconds) {
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < count && seconds > 0; ++i) {
    seconds -= seconds_of([&] {
      try {
        truths.push_back(truth_at(quantity, columns, i));
      } catch (const data::BadInput&) {  // outside ref's domain, which is smaller than fast's
      }
    });
  }
  return truths;
}

WayError largest_deviation(const BatchMethod& method, const std::vector<Truth>& truths) {
  if (truths.empty()) return {};
  std::vector<double> values(truths.back().number + 1);
  method.evaluate(values.size(), values);
  double ulps = 0, relative = 0;
  ErrorTally errors;
  for (const Truth& truth : truths) {
    const Deviation found = deviation(values[truth.number], truth.value, truth.envelope);
    ulps = std::max(ulps, found.ulps);
    relative = std::max(relative, found.relative);
    errors.add(found.ulps);
  }
  return {ulps, relative, errors.mean(), errors.percentile(0.999)};
}

std::vector<BenchRow> rows_of(const Quantity& quantity, const std::string& arguments, const Columns& columns,
                              const std::vector<Truth>& truths, const std::vector<OtherKernel>& others,
                              std::size_t least, int rounds) {
  const std::vector<BatchMethod> contestants = methods(quantity, columns, others);
  std::vector<double> values(columns.front().size());
  std::vector<TimedWay> ways;
  for (const BatchMethod& method : contestants)
    ways.push_back(
        {method.name,
         {[&](std::size_t count) { method.evaluate(count, values); }, least, values.size(), method.seconds},
         [&] { return largest_deviation(method, truths); }});
  return timed_rows(quantity.name, arguments, ways, {.count = rounds, .seconds = 1e-3});
}

/// Points drawn as the audit draws them, without those that fast refuses.
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

}  // namespace

std::vector<BenchRow> bench_double(const Quantity& quantity, const BenchProgress& progress,
                                   const std::vector<OtherKernel>& others) {
  if (quantity.is_costly) {
    const Columns columns = draw_costly_columns(quantity);
    return rows_of(quantity, fmt::format("as in the audit, {} points", costly_points), columns,
                   first_truths(quantity, columns, costly_points, seconds_of_costly_truth), others,
                   costly_points, 3);
  }
  std::vector<BenchRow> rows;
  for (const TimedRange& range : ranges(quantity)) {
    if (interrupted()) break;
    if (progress) progress(range.name);
    const Columns columns = draw_columns(quantity, range);
    std::ranges::move(
        rows_of(quantity, range_text(quantity, range), columns,
                first_truths(quantity, columns, points_compared, unlimited), others, least_points, 15),
        std::back_inserter(rows));
  }
  return rows;
}

}  // namespace nipref::verify
