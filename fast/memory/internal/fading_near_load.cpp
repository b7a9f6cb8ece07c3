#include <algorithm>
#include <array>
#include <cmath>

#include <nipref/fast/memory/internal/fading_near_load.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {
namespace {

/// I1 = ln(log_end/w) + a smooth even function that begins with w^2.
constexpr double log_end = 0x1.68324269695c0p-1;
/// From this x on, e^-x < 2^-57 is neglected.
constexpr double faded_nats = 40;
/// Up to this ratio of the distances of an interval's ends from the load, a Gauss rule integrates the logarithm.
constexpr double smooth_ratio = 6;

constexpr int most_nodes = 32;
using Nodes = std::array<double, most_nodes>;

constexpr int rules[] = {8, 10, 16, 32};

const GaussRule& rule(int index) {
  static const std::array<GaussRule, std::size(rules)> all = [] {
    std::array<GaussRule, std::size(rules)> made;
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = gauss_legendre(rules[i]);
    return made;
  }();
  return all[static_cast<std::size_t>(index)];
}

/// The index of the Gauss rule. At full accuracy its degree 2 n has to be about 12 + 0.85 x for e^(-x s) on [0, 1], and
/// 30 for the kernels, whose singularities are at least a quarter of the interval away.
int rule_for(double decays, double ratio, Accuracy accuracy) {
  const bool easy = decays <= 6 && ratio <= 3;
  if (accuracy.rtol() >= 1e-8) return easy ? 0 : 2;
  return easy ? 2 : 3;
}

/// The kernel at a rule's points between v > 0 and v + step.
void kernel_between(Kernel kernel, double v, double step, const GaussRule& rule, Nodes& values,
                    Accuracy accuracy) {
  Nodes points;
  const std::size_t count = rule.at.size();
  for (std::size_t i = 0; i < count; ++i) points[i] = v + step * rule.at[i];
  sheet_code().batch[static_cast<int>(kernel)][accuracy.tier()](points.data(), values.data(), count);
}

/// The kernels at the rules' points on the intervals that most integrals consist of: [1/2, 1] and, for the kernels
/// without logarithm, [0, 1/2], each in both directions.
struct WholePieces {
  Nodes value[kernel_count][2][2][std::size(rules)];

  WholePieces() {
    for (int kernel = 0; kernel < kernel_count; ++kernel) {
      for (int outer = kernel == 0 ? 1 : 0; outer < 2; ++outer) {
        for (int i = 0; i < static_cast<int>(std::size(rules)); ++i) {
          const double near = outer * inner_end;
          kernel_between(static_cast<Kernel>(kernel), near, inner_end, rule(i), value[kernel][outer][1][i],
                         {});
          kernel_between(static_cast<Kernel>(kernel), near + inner_end, -inner_end, rule(i),
                         value[kernel][outer][0][i], {});
        }
      }
    }
  }
};

const Nodes* whole_piece(Kernel kernel, double v, int step, double length, int index) {
  if (length != inner_end) return nullptr;
  const double near = step > 0 ? v : v - length;
  if (near != inner_end && (near != 0 || kernel == Kernel::I1)) return nullptr;
  static const WholePieces all;
  return &all.value[static_cast<int>(kernel)][near > 0][step > 0][index];
}

/// The rule for e^(-decays s) on [0, 1] times a function as smooth as the regular part of I1 on [0, 1/2].
const GaussRule& gauss_rule_for(double decays, Accuracy accuracy) {
  return rule(decays <= 2 ? 1 : rule_for(decays, 1, accuracy));
}

/// int_0^length e^(-rate d) f(d) dd from the values of f at the rule's points.
double faded_sum(const GaussRule& rule, const Nodes& values, double length, double rate) {
  const std::size_t count = rule.at.size();
  Nodes decay;
  sheet_code().decays(rate * length, rule.at.data(), decay.data(), count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += rule.weight[i] * values[i] * decay[i];
  return length * sum;
}

Complex faded_sum(const GaussRule& rule, const Nodes& values, double length, Complex rate) {
  Complex sum = 0;
  for (std::size_t i = 0; i < rule.at.size(); ++i)
    sum += rule.weight[i] * values[i] * faded_exp(rate * (length * rule.at[i]));
  return length * sum;
}

/// int_0^length e^(-rate d) I(v + step d) dd by one Gauss rule, where v and v + step length are distances from the
/// load >= 0, and step is 1 ahead of the load, -1 behind it. For I1 their ratio must be below 6.
template <typename Rate>
Rate by_rule(Kernel kernel, double v, int step, double length, Rate rate, Accuracy accuracy) {
  const double end = v + step * length;
  const double ratio = kernel == Kernel::I1 ? std::max(v, end) / std::min(v, end) : 2;
  const int index = rule_for(std::abs(rate) * length, ratio, accuracy);
  const GaussRule& gauss = rule(index);
  Nodes computed;
  const Nodes* value = whole_piece(kernel, v, step, length, index);
  if (!value) {
    kernel_between(kernel, v, step * length, gauss, computed, accuracy);
    value = &computed;
  }
  return faded_sum(gauss, *value, length, rate);
}

/// The integral of e^(-rate d) times the smooth part of I1 over any piece of [-1/2, 1/2].
double smooth_rest(double w, double length, double rate, Accuracy accuracy) {
  const GaussRule& gauss = gauss_rule_for(rate * length, accuracy);
  Nodes smooth;
  sheet_code().even_rest(Component::I1, w, length, gauss.at.data(), smooth.data(), gauss.at.size());
  return faded_sum(gauss, smooth, length, rate);
}

/// int_0^length e^(-rate d) ln(log_end/(p + d)) dd for p >= 0, p + length <= 1/2, integrated by parts. The terms cancel
/// if p is close to p + length.
double log_ahead(double p, double length, double rate) {
  const double q = p + length;
  const double constant = std::log(log_end / q) * length * phi1(rate * length);
  if (p == 0) return constant + q * ein_ratio(rate * q);
  const double near = rate * p, far = rate * q;
  if (near <= 0.35) {
    const double growth = std::exp(near);
    const double relative_growth = near < 1e-17 ? 1 : std::expm1(near) / near;
    return constant + growth * (q * ein_ratio(far) - p * ein_ratio(near)) -
           p * std::log(q / p) * relative_growth;
  }
  return constant + (std::log(q / p) - scaled_E1(near) + faded_exp(rate * length) * scaled_E1(far)) / rate;
}

/// int_0^a e^(-rate d) ln(log_end/(a - d)) dd, 0 < a <= 1/2.
double log_behind(double a, double rate) {
  return a * (std::log(log_end / a) * phi1(rate * a) + faded_ein_ratio(rate * a));
}

/// The integral of e^(-rate d) I1 over a piece of [0, 1/2].
double inner_ahead(double p, double length, double rate, Accuracy accuracy) {
  if (p > 0 && p + length <= smooth_ratio * p) return by_rule(Kernel::I1, p, 1, length, rate, accuracy);
  return log_ahead(p, length, rate) + smooth_rest(p, length, rate, accuracy);
}

/// The integral of e^(-rate d) I1 over a piece behind the load, from the distance a <= 1/2 down to c.
double inner_behind(double a, double c, double length, double rate, Accuracy accuracy) {
  if (a <= smooth_ratio * c) return by_rule(Kernel::I1, a, -1, length, rate, accuracy);
  const double missing = c > 0 ? faded_exp(rate * length) * log_behind(c, rate) : 0;
  return log_behind(a, rate) - missing + smooth_rest(-a, length, rate, accuracy);
}

/// The integral over a piece from w to `end` = w + length, on one side of the load and of the distance 1/2.
double piece(Kernel kernel, double w, double end, double length, double rate, Accuracy accuracy) {
  const int step = w < 0 ? -1 : 1;
  const double distance = std::fabs(w);
  if (rate * length > faded_nats) {
    length = faded_nats / rate;
    end = w + length;
  }
  if (kernel != Kernel::I1) return step * by_rule(kernel, distance, step, length, rate, accuracy);
  const bool inner = std::max(distance, std::fabs(end)) <= inner_end;
  if (!inner) return by_rule(kernel, distance, step, length, rate, accuracy);
  return step > 0 ? inner_ahead(distance, length, rate, accuracy)
                  : inner_behind(distance, -end, length, rate, accuracy);
}

/// For a complex rate: the distance x from the load within which the weight is taken as constant, the logarithm is
/// integrated in closed form, and the other kernels are taken as 0. The relative error in the integral over `length` is
/// rate x^2/length or, if the weight decays sooner, (rate x)^2; it is at most 1e-18.
double nearest_panel(double rate_size, double length) {
  return 1e-9 * std::sqrt(std::min(length, 1 / (1 + rate_size)) / (1 + rate_size));
}

/// The integral over one panel within [-1, 1], on one side of the load.
Complex panel(Kernel kernel, double w, double length, Complex rate, double tiny, Accuracy accuracy) {
  const int step = w < 0 ? -1 : 1;
  const double v = std::fabs(w);
  if (step > 0 ? v >= tiny : v > tiny)
    return (kernel == Kernel::I1 ? 1.0 : step) * by_rule(kernel, v, step, length, rate, accuracy);
  if (kernel != Kernel::I1) return 0;
  const auto log_to = [](double x) { return x > 0 ? x * (std::log(log_end / x) + 1) : 0; };
  return step > 0 ? log_to(v + length) - log_to(v) : log_to(v) - log_to(std::max(v - length, 0.0));
}

/// The length of the panel from w, short compared with the period of the weight and with the distance from the load.
double panel_length(double w, double rate_size, double tiny) {
  const double v = std::fabs(w), most = 12 / rate_size;
  if (w >= 0) return v < tiny ? tiny - v : std::min(most, 2 * v);
  return v > tiny ? std::min(most, v * 2 / 3) : v;
}

Complex piece(Kernel kernel, double w, double end, double length, Complex rate, Accuracy accuracy) {
  length = std::min(length, faded_nats / std::max(rate.real(), 1e-300));
  // The second distance exceeds the first if |rate| length > 1e4, and causes the error (1e-13 |rate| length)^2. This is
  // less than a rounding for each radian up to 1e10 radians.
  const double tiny = std::max(nearest_panel(std::abs(rate), length), 1e-13 * length);
  Complex sum = 0;
  double done = 0;
  while (done < length) {
    const double left = done == 0 ? length : std::min(length - done, end - (w + done));
    const double here = std::min(left, panel_length(w + done, std::abs(rate), tiny));
    sum += faded_exp(rate * done) * panel(kernel, w + done, here, rate, tiny, accuracy);
    done = here >= left ? length : done + here;
  }
  return sum;
}

/// The integral from w to `end` as a sum of `of_piece` over the parts between neighbouring core_stops.
template <typename Rate, typename Piece>
Rate over_pieces(double w, double end, double length, Rate rate, Piece of_piece) {
  Rate sum = 0;
  double done = 0;
  for (std::size_t k = 0; k < core_stops.size(); ++k) {
    const double stop = core_stops[k];
    if (w >= stop || (w >= end && done > 0)) continue;
    const bool last = end <= stop;
    const double left = done == 0 ? length : end - w;
    const double part = last ? left : stop - w;
    const Rate weight = done == 0 ? Rate(1) : faded_exp(rate * done);
    sum += weight * of_piece(k, w, last ? end : stop, part);
    done += part;
    w = stop;
  }
  return sum;
}

}  // namespace

CorePieces core_of(Kernel kernel, double rate, Accuracy accuracy) {
  CorePieces pieces;
  double start = -1;
  for (std::size_t k = 0; k < core_stops.size(); ++k) {
    pieces[k] = piece(kernel, start, core_stops[k], core_stops[k] - start, rate, accuracy);
    start = core_stops[k];
  }
  return pieces;
}

double memory_under_load(Kernel kernel, double w, double end, double length, double rate,
                         const CorePieces& whole, Accuracy accuracy) {
  return over_pieces(w, end, length, rate, [&](std::size_t k, double from, double to, double part) {
    const double start = k == 0 ? -1 : core_stops[k - 1];
    const bool is_whole = from == start && to == core_stops[k];
    return is_whole ? whole[k] : piece(kernel, from, to, part, rate, accuracy);
  });
}

Complex memory_under_load(Kernel kernel, double w, double end, double length, Complex rate,
                          Accuracy accuracy) {
  return over_pieces(w, end, length, rate, [&](std::size_t, double from, double to, double part) {
    return piece(kernel, from, to, part, rate, accuracy);
  });
}

namespace {

/// The principal value of int_0^inf e^(-rate x)/(w + x) dx.
Complex memory_of_inverse(double w, Complex rate) {
  return w > 0 ? scaled_E1(rate * w) : -scaled_Ei(-rate * w);
}

}  // namespace

OscillatingCore::OscillatingCore(Kernel kernel, Complex rate, Accuracy accuracy)
    : kernel_(kernel), rate_(rate), accuracy_(accuracy) {
  const double size = std::abs(rate), tiny = nearest_panel(size, 1), most = 12 / size;
  if (size >= polynomial_from && (kernel == Kernel::I1 || kernel == Kernel::I3)) {
    smooth_.emplace(smooth_part(kernel), rate);
    return;
  }
  // Each stop is the beginning of a panel that ends at the stop before it.
  for (double w = 1; w > tiny; w -= std::min(most, w * 2 / 3)) stops_.push_back(w);
  stops_.insert(stops_.end(), {tiny, 0, -tiny});
  for (double v = tiny; v < 1;) stops_.push_back(-(v = std::min({1.0, v + most, 3 * v})));
  from_stops_.push_back(0);
  for (std::size_t i = 1; i < stops_.size(); ++i) {
    const double length = stops_[i - 1] - stops_[i];
    from_stops_.push_back(panel(kernel, stops_[i], length, rate, tiny, accuracy) +
                          faded_exp(rate * length) * from_stops_.back());
  }
}

Complex OscillatingCore::from(double w) const {
  if (smooth_) {
    const Complex smooth = smooth_->from(w);
    if (kernel_ != Kernel::I1) return smooth;
    const Complex beyond = faded_exp(rate_ * (nearest - w)) * memory_of_inverse(nearest, rate_);
    return smooth - (std::log(std::fabs(w)) + memory_of_inverse(w, rate_) - beyond) / rate_;
  }
  const auto after = std::ranges::lower_bound(stops_, w, std::ranges::greater{});
  if (after == stops_.begin()) return 0;
  const auto stop = static_cast<std::size_t>(after - stops_.begin()) - 1;
  const double length = stops_[stop] - w;
  return panel(kernel_, w, length, rate_, nearest_panel(std::abs(rate_), 1), accuracy_) +
         faded_exp(rate_ * length) * from_stops_[stop];
}

}  // namespace nipref::fast::internal
