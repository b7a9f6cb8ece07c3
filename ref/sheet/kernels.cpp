#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

constexpr long largest_argument = 1000;

Enclosure odd(const Exact& x, const char* name, int digits, Interval (*interval)(const Exact&, double)) {
  check_argument(x, name);
  if (x.sign() == 0) return exact_zero(digits);
  return enclose(digits, 0, [&](double nats) { return interval(x, nats); });
}

}  // namespace

double nats_of_difference(const Exact& alpha, const Exact& eta) {
  const double nearer = std::min(std::abs(alpha.approximate()), std::abs(eta.approximate()));
  const Exact apart(mpq_class(abs(alpha.value()) - abs(eta.value())));
  return std::min(slowest_decay * nearer, std::max(0.0, -apart.log2_magnitude() * std::numbers::ln2));
}

void check_argument(const Exact& argument, const char* name) {
  if (abs(argument.value()) > largest_argument) {
    throw data::BadInput(name, argument.approximate(),
                         "must satisfy |argument| <= 1000 on the reference path");
  }
}

void check_nonzero_argument(const Exact& argument, const char* name) {
  check_argument(argument, name);
  if (argument.sign() == 0) throw data::BadInput(name, "0", "must be nonzero: the kernel is infinite there");
}

void check_poisson(const Exact& poisson) {
  if (poisson.value() <= -1 || 2 * poisson.value() > 1)
    throw data::BadInput("poisson", poisson.approximate(), "must satisfy -1 < poisson <= 0.5");
}

Enclosure I1(const Exact& alpha, int digits) {
  check_nonzero_argument(alpha, "alpha");
  const double first = slowest_decay * std::abs(alpha.approximate());
  return enclose(digits, first, [&](double nats) { return I1_interval(alpha, nats); });
}

Enclosure I2(const Exact& alpha, int digits) {
  if (alpha.sign() == 0) return exact_zero(digits);
  return enclose(digits, 0, [&](double nats) { return I2_interval(alpha, nats); });
}

Enclosure I3(const Exact& alpha, int digits) { return odd(alpha, "alpha", digits, I3_interval); }
Enclosure I4(const Exact& eta, int digits) { return odd(eta, "eta", digits, I4_interval); }
Enclosure I5(const Exact& eta, int digits) { return odd(eta, "eta", digits, I5_interval); }

Enclosure I6(const Exact& alpha, const Exact& eta, int digits) {
  check_nonzero_argument(alpha, "alpha");
  check_argument(eta, "eta");
  const double first = nats_of_difference(alpha, eta);
  return enclose(digits, first, [&](double nats) { return I6_interval(alpha, eta, nats); });
}

Enclosure I7(const Exact& eta, int digits) {
  check_argument(eta, "eta");
  const double first = slowest_decay * std::abs(eta.approximate());
  return enclose(digits, first, [&](double nats) { return I7_interval(eta, nats); });
}

}  // namespace nipref::ref
