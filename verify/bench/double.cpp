#include <nipref/verify/audit/error_tally.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

/// How much is measured in a range of a quantity.
struct Extent {
  std::size_t points_drawn = 4096, least_timed = 32;
  /// The points compared with the truth. The percentile 99.9 of fewer points is their maximum.
  std::size_t most_compared = 1000;
  double seconds_of_truth = HUGE_VAL;
  int rounds = usual_rounds;
};
constexpr Extent usual_extent{};
constexpr Extent costly_extent{
    .points_drawn = 12, .least_timed = 12, .most_compared = 12, .seconds_of_truth = 5, .rounds = 3};

constexpr std::array coarse_tolerances{1e-3, 1e-6, 1e-9, 1e-12};

struct TimedRange {
  std::string name;
  double lower;
  double upper;
  bool logarithmic;
};

/// The ranges of a quantity: only the first if there are no other libraries; one without a name if it is costly.
std::vector<TimedRange> ranges(const Quantity& quantity) {
  if (quantity.is_costly) return std::vector<TimedRange>(1);
  std::vector<TimedRange> all{{"[1e-6,20] log-uniform", 1e-6, 20, true},
                              {"(0,20] uniform", 0, 20, false},
                              {"[1e-6,1e-3]", 1e-6, 1e-3, true},
                              {"[1e-3,1]", 1e-3, 1, true},
                              {"[1,20]", 1, 20, true},
                              {"[20,300]", 20, 300, true}};
  if (quantity.peers.empty()) all.resize(1);
  return all;
}

double representative(ArgumentKind kind, const TimedRange& range, Random& random) {
  if (kind == ArgumentKind::nonzero_position || kind == ArgumentKind::position)
    // The interval includes the upper end, but not the lower end.
    return range.logarithmic ? random.log_uniform(range.lower, range.upper)
                             : range.upper - random.uniform() * (range.upper - range.lower);
  if (kind == ArgumentKind::young) return 1;
  if (kind == ArgumentKind::poisson) return 0.3;
  if (kind == ArgumentKind::index) return std::floor(random.log_uniform(1, 1000));
  return 0;  // quantities with other arguments draw their own points
}

/// Draws points. Those of a costly quantity are drawn again until fast accepts them.
std::vector<Point> draw_points(const Quantity& quantity, const TimedRange& range, std::size_t count) {
  Random random("bench " + quantity.name + range.name);
  std::vector<Point> points(count, Point(quantity.arguments.size()));
  if (quantity.draw) {
    std::ranges::generate(points, [&] {
      Point drawn = quantity.draw(random);
      while (quantity.is_costly && std::isnan(fast_value(quantity, drawn, {}))) drawn = quantity.draw(random);
      return drawn;
    });
    return points;
  }
  for (std::size_t j = 0; j < quantity.arguments.size(); ++j)
    for (Point& point : points) point[j] = representative(quantity.arguments[j].kind, range, random);
  return points;
}

std::string range_text(const Quantity& quantity, const TimedRange& range) {
  if (quantity.is_costly) return fmt::format("as in the audit, {} points", costly_extent.points_drawn);
  const ArgumentKind kind = quantity.arguments.front().kind;
  if (kind == ArgumentKind::index) return "n in [1,1000] log-uniform";
  if (quantity.draw) return "as in the audit";
  return fmt::format("{} in {}", quantity.arguments.front().name, range.name);
}

/// The reference's value at one of the points.
struct Truth {
  std::size_t number;
  ref::Estimate value;
  double envelope;
};

/// The reference's values at the first `count` points that it computes in these seconds, without those that it refuses.
std::vector<Truth> first_truths(const Quantity& quantity, const std::vector<Point>& points, std::size_t count,
                                double seconds) {
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < count && seconds > 0; ++i) {
    seconds -= seconds_of([&] {
      auto truth = unless_refused([&] { return ref_value(quantity, points[i], digits_beyond_double); });
      if (truth) truths.push_back({i, *std::move(truth), quantity.envelope(points[i])});
    });
  }
  return truths;
}

WayError largest_deviation(const BatchMethod& method, const std::vector<Truth>& truths) {
  if (truths.empty()) return {};
  std::vector<double> values(truths.back().number + 1);
  method.evaluate(values);
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

std::vector<TimedWay> ways_to(const Quantity& quantity, const std::vector<Point>& points,
                              const std::vector<Truth>& truths, const std::vector<OtherKernel>& others,
                              std::size_t least) {
  std::vector<TimedWay> all;
  const auto add = [&](const std::string& name, const BatchMethod& method) {
    all.push_back({name, method.contender(least, points.size()),
                   [=, &truths] { return largest_deviation(method, truths); }});
  };
  const auto add_fast = [&](double rtol) {
    const std::string how = rtol == fast::Accuracy::best_rtol ? "full" : fmt::format("rtol={:.0e}", rtol);
    add("fast " + how, method_of(quantity.by_fast_loop, fast::Accuracy(rtol), points));
    if (quantity.by_fast_batch)
      add("fast batch " + how, method_of(quantity.by_fast_batch, fast::Accuracy(rtol), points));
  };
  add_fast(fast::Accuracy::best_rtol);
  for (const OtherKernel& other : others)
    if (other.kernel->info().quantity == quantity.name) add(other.name, method_of(*other.kernel, points));
  if (quantity.peers.empty()) return all;
  for (const double rtol : coarse_tolerances) add_fast(rtol);
  const auto first_arguments = mapped(points, [](const Point& point) { return point.front(); });
  for (const Peer& peer : quantity.peers)
    add(peer.method, {[=, evaluate = peer.make()](std::span<double> values) {
          std::transform(first_arguments.begin(), first_arguments.begin() + std::ssize(values),
                         values.begin(), evaluate);
        }});
  return all;
}

}  // namespace

std::vector<BenchPart> double_bench(const Quantity& quantity, const std::vector<OtherKernel>& others) {
  const Extent& extent = quantity.is_costly ? costly_extent : usual_extent;
  return mapped(ranges(quantity), [&](const TimedRange& range) {
    const std::string arguments = range_text(quantity, range);
    return BenchPart{quantity.name + " " + arguments, [=, &quantity] {
                       const std::vector<Point> points = draw_points(quantity, range, extent.points_drawn);
                       const std::vector<Truth> truths =
                           first_truths(quantity, points, extent.most_compared, extent.seconds_of_truth);
                       return timed_rows(quantity.name, arguments,
                                         ways_to(quantity, points, truths, others, extent.least_timed),
                                         {.count = extent.rounds, .seconds = 1e-3});
                     }};
  });
}

}  // namespace nipref::verify
