#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/number/internal/bisection.hpp>

namespace nipref::fast {
namespace {

bool is_sure(const Estimate& number) { return std::fabs(number.value) > number.error; }

/// The distance from `place` at which f exceeds `error` on both sides.
double unsure_distance(const std::function<double(double)>& f, double place, double error, double most) {
  double distance = 0x1p-52 * std::max(std::fabs(place), most);
  while (distance < most &&
         !(std::fabs(f(place - distance)) > error && std::fabs(f(place + distance)) > error))
    distance *= 1.2;
  return std::min(distance, most);
}

/// The zero of `f` between a < b, where f has different signs. Its error is the distance beyond which f exceeds its own
/// error at the zero on both sides, but at most `most`.
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

Estimate place_of_maximum(const std::function<double(double)>& f, const PlaceFunction& slope,
                          const std::function<Estimate(double, double)>& difference,
                          const std::vector<double>& places) {
  std::vector<double> values;
  for (const double place : places) values.push_back(f(place));
  const double most = places.back() - places.front(),
               worth_refining = share_worth_refining * std::ranges::max(values);
  std::vector<Estimate> maxima;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    if (values[i] < worth_refining || values[i] < values[i - 1] || values[i] <= values[i + 1]) continue;
    const double a = places[i - 1], b = places[i + 1];
    // Where the slopes do not have these signs, the function is too rough for the place to be known.
    const bool is_clear = slope.value(a) > 0 && slope.value(b) < 0;
    maxima.push_back(is_clear ? place_of_zero(slope, a, b, most) : Estimate{places[i], most});
  }
  if (maxima.empty()) return {places[places.size() / 2], most};
  Estimate largest = *std::ranges::max_element(maxima, {}, [&](const Estimate& one) { return f(one.value); });
  const double place = largest.value;
  for (const Estimate& other : maxima) {
    const Estimate lead = difference(place, other.value);
    if (lead.value <= lead.error)
      largest.error = std::max(largest.error, std::fabs(other.value - place) + other.error);
  }
  return largest;
}

}  // namespace nipref::fast
