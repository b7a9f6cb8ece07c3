#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t most_timed = 1024, least_timed = 32;
constexpr int rounds = 15;
constexpr double seconds_of_round = 2e-3;

/// The seconds for so many passes over the first points; nothing if this fails.
using Timed = std::function<std::optional<double>(std::size_t points, std::size_t passes)>;

Timed timed(PluginKernel& kernel, const std::vector<Point>& points) {
  return [&](std::size_t count, std::size_t passes) {
    return kernel.seconds(std::span(points).first(count), passes);
  };
}

Timed timed_fast(const Quantity& quantity, const std::vector<Point>& points, bool batch) {
  std::vector<std::vector<double>> columns(quantity.arguments.size());
  for (const Point& point : points) {
    for (std::size_t j = 0; j < point.size(); ++j) columns[j].push_back(point[j]);
  }
  const auto& evaluate = batch && quantity.by_fast_batch ? quantity.by_fast_batch : quantity.by_fast_loop;
  return [&evaluate, columns = std::move(columns)](std::size_t count, std::size_t passes) {
    std::vector<std::span<const double>> heads;
    for (const auto& column : columns) heads.push_back(std::span(column).first(count));
    std::vector<double> values(count);
    return std::optional(seconds_of([&] {
      for (std::size_t pass = 0; pass < passes; ++pass) evaluate(heads, values, fast::Accuracy());
    }));
  };
}

/// The number of points for which one pass takes at most as long as a round; nothing if this fails.
std::optional<std::size_t> points_for(const Timed& way, std::size_t points) {
  std::size_t count = std::min(points, least_timed);
  for (;;) {
    const auto seconds = way(count, 1);
    if (!seconds) return std::nullopt;
    if (count == points || *seconds > seconds_of_round / 2) return count;
    count = std::min(2 * count, points);
  }
}

/// The number of passes that take about as long as a round.
std::optional<std::size_t> passes_for(const Timed& way, std::size_t points) {
  const auto seconds = way(points, 1);
  if (!seconds) return std::nullopt;
  return std::max<std::size_t>(1, static_cast<std::size_t>(seconds_of_round / std::max(*seconds, 1e-9)));
}

double quantile(std::vector<double> numbers, double part) {
  const auto which = static_cast<std::ptrdiff_t>(part * static_cast<double>(numbers.size() - 1));
  std::ranges::nth_element(numbers, numbers.begin() + which);
  return numbers[static_cast<std::size_t>(which)];
}

std::optional<Speed> in_turns(const std::array<Timed, 2>& ways, std::size_t points) {
  std::size_t count = points;
  for (const Timed& way : ways) {
    const auto bearable = points_for(way, points);
    if (!bearable) return std::nullopt;
    count = std::min(count, *bearable);
  }
  std::array<std::size_t, 2> passes{};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto wanted = passes_for(ways[i], count);
    if (!wanted) return std::nullopt;
    passes[i] = *wanted;
  }
  std::array<std::vector<double>, 2> times;
  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const auto seconds = ways[i](count, passes[i]);
      if (!seconds) return std::nullopt;
      times[i].push_back(*seconds / static_cast<double>(passes[i] * count));
    }
    ratios.push_back(times[0].back() / times[1].back());
  }
  return Speed{1e9 * quantile(times[0], 0.5), 1e9 * quantile(times[1], 0.5), quantile(ratios, 0.25),
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
  return in_turns({timed(kernel, points), timed_fast(quantity, points, batch)}, points.size());
}

std::optional<Speed> speed_against(PluginKernel& kernel, PluginKernel& older,
                                   const std::vector<Point>& points) {
  return in_turns({timed(kernel, points), timed(older, points)}, points.size());
}

std::string speed_text(const Speed& speed, const std::string& other) {
  return fmt::format("{:.3g} ns a value, {:.3g} times the {:.3g} ns of {} (quartiles {:.3g} to {:.3g})",
                     speed.nanoseconds, speed.ratio, speed.other_nanoseconds, other, speed.lower_ratio,
                     speed.upper_ratio);
}

}  // namespace nipref::verify
