#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <nipref/fast/nip/internal/length_search.hpp>

namespace nipref::fast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Secants that need more steps do not converge; a wrong fixed exponent may need five steps a digit.
constexpr int most_by_secant = 40, most_by_one_exponent = 200;
/// A memory that softens the sheet over a decade of lengths reduces the exponent 2 of a half-space by one.
constexpr double least_exponent = 1;
/// The least error of ln(load) that counts for the bracket. Panels laid out for another length cause smaller ones.
constexpr double telling_excess = 0.1;

/// The load over the square of the half-length A of a frictionless elastic contact, to 1.3 %: pi for a half-space, and
/// 8/3 A for springs that reach 0.177 beyond both ends, (1/pi) int_0^inf ln(K(0)/K(k)) dk/k^2 by Wiener and Hopf, K the
/// transform of I1. The difference of the two fades such that a half-space has no term linear in A.
constexpr double springs = 8.0 / 3, beyond_ends = 8 * 0.17712708525681775;
constexpr double between = std::numbers::pi - beyond_ends;
double faded(double half_length) { return std::exp(-springs / between * half_length); }
double load_over_square(double half_length) {
  return springs * half_length + beyond_ends + between * faded(half_length);
}

}  // namespace

double load_guess(double half_length) { return load_over_square(half_length) * half_length * half_length; }

double half_length_guess(double load) {
  double length = std::min(std::sqrt(load / std::numbers::pi), std::cbrt(load / springs));
  for (int i = 0; i < 3; ++i) length *= std::pow(load / load_guess(length), 1 / load_exponent(length));
  return std::min(length, longest_sought / 2);
}

double load_exponent(double half_length) {
  return 2 + springs * half_length * (1 - faded(half_length)) / load_over_square(half_length);
}

LengthSearch::LengthSearch(double load, double near, const LengthSearchRule& rule, double exponent)
    : load_(load),
      rule_(rule),
      log_length_(std::min(std::log(near), std::log(rule.longest))),
      exponent_(exponent) {}

double LengthSearch::length() const { return std::exp(log_length_); }

bool LengthSearch::settled(double found) {
  const bool was_last = ++tried_ == (rule_.fixed_exponent ? most_by_one_exponent : most_by_secant);
  if (!(found > 0)) {
    residual_ = infinity;
    log_too_long_ = log_length_;
    move_to(log_length_ - 1);
    return was_last;
  }
  const double excess = std::log(found / load_);
  residual_ = std::fabs(found / load_ - 1);
  met_ = residual_ <= rule_.tolerance || at_rounding(excess);
  const bool at_longest = excess < 0 && log_length_ >= std::log(rule_.longest);
  if (met_ || was_last || at_longest) return true;
  step(excess);
  return false;
}

/// Rounding is reached when a secant does not halve the excess. A step with another exponent may gain less, but it must
/// not make the excess larger.
bool LengthSearch::at_rounding(double excess) const {
  return tried_ > 4 && residual_ < 1e-6 &&
         std::fabs(excess) >= (by_secant_ ? 0.5 : 1) * std::fabs(last_excess_);
}

void LengthSearch::step(double excess) {
  if (excess > telling_excess) log_too_long_ = log_length_;
  if (excess < -telling_excess) log_too_short_ = log_length_;
  by_secant_ = false;
  if (!rule_.fixed_exponent && last_excess_ != 0 && log_length_ != last_log_length_) {
    const double shown = (excess - last_excess_) / (log_length_ - last_log_length_);
    exponent_ = std::max(shown, least_exponent);
    by_secant_ = exponent_ == shown;
  }
  last_log_length_ = log_length_;
  last_excess_ = excess;
  move_to(log_length_ - excess / exponent_);
}

/// A step out of the bracket is replaced by bisection.
void LengthSearch::move_to(double log_length) {
  const bool outside = log_length <= log_too_short_ || log_length >= log_too_long_;
  const bool enclosed = std::isfinite(log_too_short_) && std::isfinite(log_too_long_);
  if (outside && enclosed && !rule_.fixed_exponent) log_length = std::midpoint(log_too_short_, log_too_long_);
  log_length_ = std::min(log_length, std::log(rule_.longest));
}

}  // namespace nipref::fast
