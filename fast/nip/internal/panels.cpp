#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/nip/internal/panels.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// The largest |rate| times contact length that one expansion over the whole contact resolves.
constexpr double most_over_whole = 8;
/// The largest width of the first panel, half-thicknesses.
constexpr double widest_at_end = 2;
/// The error estimate needs the last three coefficients.
constexpr int fewest_terms = 3;
constexpr int most_terms = 40;
constexpr double nats_of_double = 37;

/// The logarithm of the factor by which the Chebyshev coefficients of a panel fall from one degree to the next.
double log_fall(double left, double right, double half_length, bool is_whole) {
  const double middle = (left + right) / 2, half = (right - left) / 2;
  const auto by = [&](Complex singular) { return internal::log_of_ellipse((singular - middle) / half); };
  double least = by({0, 2});
  if (left > 0) least = std::min(least, by(0));
  return is_whole ? least : std::min(least, by(2 * half_length));
}

/// The degree from which on the coefficients of e^(-rate x) on a panel, e^(-rate middle) I_n(rate half), are below
/// e^-nats and fall by least_fall, or are less than rounding, by the leading term of their uniform expansion in n.
int degree_of_exponential(Complex rate, double left, double right, double nats) {
  if (rate.real() * left > nats_of_double) return 1;
  const Complex z = rate * (right - left) / 2.0;
  const double middle = rate.real() * (left + right) / 2;
  for (int n = 1; n < 4 * most_terms; ++n) {
    const Complex root = std::sqrt(static_cast<double>(n) * n + z * z);
    const Complex ratio = z / (static_cast<double>(n) + root);
    const double size = (root + static_cast<double>(n) * std::log(ratio)).real() - middle;
    if (size < -nats_of_double || (size < -nats && std::abs(ratio) < 1 / least_fall)) return n;
  }
  return 4 * most_terms;
}

class Layout {
 public:
  Layout(double half_length, const Resolution& resolution, double longest_of_one)
      : half_length_(half_length), resolution_(resolution), longest_whole_(longest_of_one) {}

  [[nodiscard]] std::vector<Panel> panels() const {
    if (is_one()) return {panel(0, 2 * half_length_)};
    std::vector<Panel> result;
    double left = 0;
    for (int count = 0; count < most_panels; ++count) {
      const double right = left == 0 ? width_at_end() : left + width_after(left);
      if (left > 0 && (is_near_middle(right) || is_forgotten(left))) break;
      result.push_back(panel(left, right));
      left = right;
    }
    result.push_back(panel(left, 2 * half_length_ - left));
    return result;
  }

 private:
  static constexpr int most_panels = 100;

  [[nodiscard]] bool is_one() const {
    return half_length_ <= longest_whole_ &&
           resolution_.nats / log_fall(0, 2 * half_length_, half_length_, true) < 2 * most_terms &&
           std::ranges::all_of(resolution_.rates, [&](const Complex& rate) {
             return std::abs(rate) * 2 * half_length_ < most_over_whole;
           });
  }
  /// The width of the panel at the end. The panel has to resolve the exponentials at the trailing end, too.
  [[nodiscard]] double width_at_end() const {
    double width = std::min(widest_at_end, half_length_ / 2);
    while (!holds_exponentials(2 * half_length_ - width, 2 * half_length_)) width /= 2;
    return width;
  }
  /// The width of the panel that begins at `left`. Widths double until the effect of the end is less than rounding. A
  /// panel spans at most 2 most_over_whole radians of an exponential that oscillates and has not decayed.
  [[nodiscard]] double width_after(double left) const {
    const double forgotten = 1.001 * nats_of_double / resolution_.decay;
    double width = left < forgotten ? std::min(left, std::max(forgotten - left, left / 4)) : left;
    for (const Complex& rate : resolution_.rates) {
      if (rate.real() * left < nats_of_double && std::abs(rate.imag()) > 0)
        width = std::min(width, 2 * most_over_whole / std::abs(rate.imag()));
    }
    return width;
  }
  [[nodiscard]] bool is_near_middle(double right) const {
    return right > half_length_ / 1.9 && holds_exponentials(right);
  }
  /// Whether the effect of the end at `left` is less than rounding. A wide panel about the middle does not resolve it.
  [[nodiscard]] bool is_forgotten(double left) const {
    return resolution_.decay * left >= nats_of_double && holds_exponentials(left);
  }
  /// Whether a panel about the middle from here on resolves the exponentials.
  [[nodiscard]] bool holds_exponentials(double left) const {
    return left >= half_length_ || holds_exponentials(left, 2 * half_length_ - left);
  }
  [[nodiscard]] bool holds_exponentials(double left, double right) const {
    return std::ranges::all_of(resolution_.rates, [&](const Complex& rate) {
      return degree_of_exponential(rate, left, right, resolution_.nats) < most_terms;
    });
  }
  [[nodiscard]] Panel panel(double left, double right) const {
    const bool about_middle = right > half_length_, is_whole = about_middle && left == 0;
    const double nats = std::max(resolution_.nats - resolution_.decay * left, 0.0);
    double degree =
        std::max<double>(nats / log_fall(left, right, half_length_, is_whole), resolution_.polynomial);
    if (left > 0 && resolution_.decay > 0)
      degree =
          std::max<double>(degree, degree_of_exponential(resolution_.decay, left, right, resolution_.nats));
    for (const Complex& rate : resolution_.rates) {
      if (rate == 0.0) continue;
      // A layer is on the leading half alone. On the trailing half the terms resolve what is left of the exponential.
      const bool as_layer = left == 0 && !is_whole && std::abs(rate) * right > 1;
      const double from = as_layer ? 2 * half_length_ - right : left;
      degree =
          std::max<double>(degree, degree_of_exponential(rate, from, from + right - left, resolution_.nats));
    }
    const int needed = 1 + static_cast<int>(std::ceil(about_middle ? degree / 2 : degree)),
              terms = std::max(needed + resolution_.checking_terms, fewest_terms);
    return {left, right, left == 0, about_middle, std::min(terms, most_terms)};
  }

  double half_length_;
  const Resolution& resolution_;
  double longest_whole_;
};

}  // namespace

std::vector<Panel> panels(double half_length, const Resolution& resolution, double longest) {
  return Layout(half_length, resolution, longest).panels();
}

bool is_layer(Complex rate, const std::vector<Panel>& panels) {
  return !panels.front().about_middle && std::abs(rate) * panels.front().right > 1;
}

}  // namespace nipref::fast
