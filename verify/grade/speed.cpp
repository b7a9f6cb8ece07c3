#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t most_timed = 1024, least_timed = 32;
constexpr int rounds = 15;
constexpr double seconds_of_round = 2e-3;

}  // namespace

Contender BatchMethod::contender(std::size_t least, std::size_t most) const {
  if (seconds) return {[once = seconds](std::size_t count) { once(count, 1); }, least, most, seconds};
  return {[=, fill = evaluate, values = std::vector<double>(most)](std::size_t count) mutable {
            fill(std::span(values).first(count));
          },
          least, most};
}

BatchMethod method_of(const decltype(Quantity::by_fast_loop)& evaluate, fast::Accuracy accuracy,
                      const std::vector<Point>& points) {
  std::vector<std::vector<double>> columns(points.front().size());
  for (const Point& point : points)
    for (std::size_t j = 0; j < point.size(); ++j) columns[j].push_back(point[j]);
  return {[=, &evaluate](std::span<double> values) {
    const auto heads = mapped<std::span<const double>>(
        columns, [&](const auto& column) { return std::span(column).first(values.size()); });
    evaluate(heads, values, accuracy);
  }};
}

BatchMethod method_of(PluginKernel& kernel, const std::vector<Point>& points) {
  const auto first = [&](std::size_t count) { return std::span(points).first(count); };
  return {[=, &kernel](std::span<double> values) { kernel.evaluate(first(values.size()), values); },
          [=, &kernel, failed = std::make_shared<bool>(false)](std::size_t count, std::size_t passes) {
            const auto taken = *failed ? std::nullopt : kernel.seconds(first(count), passes);
            *failed = !taken;
            return taken.value_or(std::numeric_limits<double>::infinity());
          }};
}

Speed::Speed(const std::vector<double>& nanoseconds_of_rounds, const std::vector<double>& others,
             double lower)
    : nanoseconds(quantile(nanoseconds_of_rounds, 0.5)), other_nanoseconds(quantile(others, 0.5)) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(nanoseconds_of_rounds.size(), others.size()); ++i)
    ratios.push_back(nanoseconds_of_rounds[i] / others[i]);
  lower_ratio = quantile(ratios, lower);
  ratio = quantile(ratios, 0.5);
  upper_ratio = quantile(ratios, 1 - lower);
}

std::vector<Point> timing_points(const Quantity& quantity, const Ranges& ranges) {
  Random random("speed " + quantity.name);
  std::vector<Point> points = random_points(quantity, ranges, most_timed, random);
  std::erase_if(points, [&](const Point& point) {
    return !std::isfinite(fast_value(quantity, point, fast::Accuracy()));
  });
  return points;
}

std::optional<Speed> in_turns(const BatchMethod& one, const BatchMethod& other, std::size_t points) {
  std::vector<Contender> ways{one.contender(least_timed, points), other.contender(least_timed, points)};
  std::vector<Timing> timings = time_interleaved(ways, 1, seconds_of_round);
  for (Contender& way : ways) way.least = way.most = std::min(timings[0].count, timings[1].count);
  timings = time_interleaved(ways, rounds, seconds_of_round);
  const auto fails = [](const Timing& timing) { return !std::isfinite(std::ranges::max(timing.rounds)); };
  if (std::ranges::any_of(timings, fails)) return std::nullopt;
  const auto nanoseconds = [](const Timing& timing) {
    return mapped(timing.rounds, [](double seconds) { return 1e9 * seconds; });
  };
  return Speed(nanoseconds(timings[0]), nanoseconds(timings[1]), 0.25);
}

}  // namespace nipref::verify
