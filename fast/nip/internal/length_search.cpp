#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <nipref/fast/nip/internal/length_search.hpp>

namespace nipref::fast {
namespace {

constexpr int most_iterations = 40;
constexpr double least_slope = 1.8, greatest_slope = 6;

}  // namespace

double half_length_guess(double load) {
  double length = std::min(std::sqrt(load / std::numbers::pi), std::cbrt(load * 3 / 8));
  for (int i = 0; i < 5; ++i) length = std::sqrt(load / (std::numbers::pi + 8 * length / 3));
  return std::min(length, longest_sought / 2);
}

LengthSearch::LengthSearch(double load, double near, double enough, double slope)
    : load_(load), enough_(enough), log_length_(std::log(near)), slope_(slope) {}

double LengthSearch::half_length() const { return std::exp(log_length_); }

bool LengthSearch::settled(double found) {
  if (!(found > 0)) {
    // Lost to rounding in a film far longer than the load needs.
    if (iteration_++ == most_iterations) throw std::runtime_error("no contact length found for the load");
    log_length_ -= 1;
    return false;
  }
  const double excess = std::log(found / load_);
  residual_ = std::fabs(excess);
  const bool at_rounding = iteration_ > 3 && residual_ < 1e-6 && residual_ > 0.5 * std::fabs(last_excess_);
  if (residual_ <= enough_ || at_rounding || iteration_++ == most_iterations) return true;
  if (last_excess_ != 0) {
    slope_ =
        std::clamp((excess - last_excess_) / (log_length_ - last_log_length_), least_slope, greatest_slope);
  }
  last_log_length_ = log_length_;
  last_excess_ = excess;
  log_length_ -= excess / slope_;
  return false;
}

}  // namespace nipref::fast
