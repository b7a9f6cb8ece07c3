#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/number/internal/bisection.hpp>

namespace nipref::fast {
namespace {

bool is_sure(const Estimate& number) { return std::fabs(number.value) > number.error; }

/// The distance from `place` at which |f| exceeds `error` on both sides, at most `most`.
double unsure_distance(const std::function<double(double)>& f, double place, double error, double most) {
  double distance = 0x1p-52 * std::max(std::fabs(place), most);
  while (distance < most &&
         !(std::fabs(f(place - distance)) > error && std::fabs(f(place + distance)) > error))
    distance *= 1.2;
  return std::min(distance, most);
}

/// The zero of `f` between a < b, where f has different signs. Its error is the distance at which |f| exceeds on both
/// sides the error that f has at the zero, but at most `most`.
Estimate place_of_zero(const PlaceFunction& f, double a, double b, double most) {
  const bool rises = f.value(a) < 0;
  const double place = internal::last_that([&](double x) { return (f.value(x) < 0) == rises; }, a, b);
  return {place, unsure_distance(f.value, place, f.estimate(place).error, most)};
}

}  // namespace

/// f'(0) = sum_k a_k T_k'(0) with a_k = (2/n) sum_j f_j cos(k theta_j) and T_k'(0) = k sin(k pi/2). The weights are odd
/// in the place, so that one weight serves a pair of nodes.
LocalSlope::LocalSlope(int points) {
  for (int j = 0; j < points / 2; ++j) {
    const double theta = (2.0 * j + 1) * std::numbers::pi / (2 * points);
    double weight = 0;
    for (int k = 1; k < points; k += 2) weight += (k % 4 == 1 ? k : -k) * std::cos(k * theta);
    nodes_.push_back({std::cos(theta), 2 * weight / points});
  }
}

double LocalSlope::condition() const {
  double sum = 0;
  for (const Node& node : nodes_) sum += 2 * std::fabs(node.weight);
  return sum;
}

std::vector<Estimate> places_of_sure_zeros(const PlaceFunction& f, const std::vector<double>& places) {
  std::vector<Estimate> zeros;
  std::optional<double> last;
  for (const double place : places) {
    const Estimate here = f.estimate(place);
    if (!is_sure(here)) continue;
    if (last && (f.value(*last) < 0) != (here.value < 0))
      zeros.push_back(place_of_zero(f, *last, place, place - *last));
    last = place;
  }
  return zeros;
}

std::vector<LocalMaximum> local_maxima(const std::function<double(double)>& f,
                                       const std::vector<double>& places) {
  std::vector<double> values;
  for (const double place : places) values.push_back(f(place));
  std::vector<LocalMaximum> maxima;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, places.size() - 1);
    if ((i > 0 && values[i] <= values[before]) || values[i] < values[after]) continue;
    LocalMaximum maximum{places[i], values[i], places[before], places[after]};
    const double width = maximum.after - maximum.before;
    const auto [part, negative] = boost::math::tools::brent_find_minima(
        [&](double x) { return -f(maximum.before + x * width); }, 0.0, 1.0, 30);
    if (-negative > maximum.value) {
      maximum.place = maximum.before + part * width;
      maximum.value = -negative;
    }
    maxima.push_back(maximum);
  }
  return maxima;
}

const LocalMaximum& largest_of(const std::vector<LocalMaximum>& maxima) {
  return *std::ranges::max_element(maxima, {}, &LocalMaximum::value);
}

Estimate place_of_maximum(const std::vector<LocalMaximum>& maxima, const PlaceFunction& slope,
                          const std::function<Estimate(double)>& estimate, double most) {
  const auto place_of = [&](const LocalMaximum& maximum) {
    // Where the slopes do not have these signs, the function is too rough for the place to be known.
    const bool is_clear = slope.value(maximum.before) > 0 && slope.value(maximum.after) < 0;
    return is_clear ? place_of_zero(slope, maximum.before, maximum.after, most)
                    : Estimate{maximum.place, most};
  };
  const LocalMaximum& best = largest_of(maxima);
  const Estimate size = estimate(best.place);
  Estimate place = place_of(best);
  for (const LocalMaximum& other : maxima) {
    const Estimate others = estimate(other.place);
    if (&other == &best || size.value - others.value > size.error + others.error) continue;
    const Estimate there = place_of(other);
    place.error = std::max(place.error, std::fabs(there.value - place.value) + there.error);
  }
  return place;
}

}  // namespace nipref::fast
