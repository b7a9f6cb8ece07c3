#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/mapped.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t most_timed = 1024, least_timed = 32;
constexpr int rounds = 15;
constexpr double seconds_of_round = 2e-3;

/// A kernel that has failed is infinitely slow, and is not called again.
Contender contender_of(PluginKernel& kernel, const std::vector<Point>& points) {
  const auto seconds = [&, failed = std::make_shared<bool>(false)](std::size_t count, std::size_t passes) {
    const auto taken = *failed ? std::nullopt : kernel.seconds(std::span(points).first(count), passes);
    *failed = !taken;
    return taken.value_or(std::numeric_limits<double>::infinity());
  };
  return {[=](std::size_t count) { seconds(count, 1); }, least_timed, points.size(), seconds};
}

Contender contender_of_fast(const Quantity& quantity, const std::vector<Point>& points, bool batch) {
  std::vector<std::vector<double>> columns(quantity.arguments.size());
  for (const Point& point : points) {
    for (std::size_t j = 0; j < point.size(); ++j) columns[j].push_back(point[j]);
  }
  const auto& evaluate = batch && quantity.by_fast_batch ? quantity.by_fast_batch : quantity.by_fast_loop;
  const auto run = [&evaluate, columns = std::move(columns)](std::size_t count) {
    const auto heads = mapped<std::span<const double>>(
        columns, [&](const auto& column) { return std::span(column).first(count); });
    std::vector<double> values(count);
    evaluate(heads, values, fast::Accuracy());
  };
  return {run, least_timed, points.size()};
}

/// Both at as many points as the slower one bears.
std::optional<Speed> in_turns(std::vector<Contender> ways) {
  std::vector<Timing> timings = time_interleaved(ways, 1, seconds_of_round);
  for (Contender& way : ways) way.least = way.most = std::min(timings[0].count, timings[1].count);
  timings = time_interleaved(ways, rounds, seconds_of_round);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < rounds; ++i) ratios.push_back(timings[0].rounds[i] / timings[1].rounds[i]);
  const auto fails = [](const Timing& timing) { return !std::isfinite(std::ranges::max(timing.rounds)); };
  if (std::ranges::any_of(timings, fails)) return std::nullopt;
  return Speed{1e9 * timings[0].seconds, 1e9 * timings[1].seconds, quantile(ratios, 0.25),
               quantile(ratios, 0.5), quantile(ratios, 0.75)};
}

}  // namespace

std::vector<Point> timing_points(const Quantity& quantity, const Ranges& ranges) {
  Random random("speed " + quantity.name);
  std::vector<Point> points = random_points(quantity, ranges, most_timed, random);
  std::erase_if(points, [&](const Point& point) {
    return !std::isfinite(fast_value(quantity, point, fast::Accuracy()));
  });
  return points;
}

std::optional<Speed> speed_against_fast(PluginKernel& kernel, const Quantity& quantity,
                                        const std::vector<Point>& points) {
  const bool batch = !kernel.info().quantity.empty();
  return in_turns({contender_of(kernel, points), contender_of_fast(quantity, points, batch)});
}

std::optional<Speed> speed_against(PluginKernel& kernel, PluginKernel& older,
                                   const std::vector<Point>& points) {
  return in_turns({contender_of(kernel, points), contender_of(older, points)});
}

}  // namespace nipref::verify
