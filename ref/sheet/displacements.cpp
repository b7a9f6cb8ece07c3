#include <algorithm>
#include <cmath>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

/// theta1, theta2 and N of the sheet, as intervals of relative width e^{-nats}.
struct Compliances {
  Compliances(const Exact& young, const Exact& poisson, double nats)
      : precision(working_precision(std::max(nats, 1.0), 1)),
        theta1(quotient(mpq_class(1 + poisson.value()), young)),
        theta2(quotient(mpq_class((1 + poisson.value()) * (1 - 2 * poisson.value())), young)),
        normal(quotient(mpq_class(2 * (1 + poisson.value()) * (1 - poisson.value())), young)),
        pi(Interval::pi(precision)) {}

  mpfr_prec_t precision;
  Interval theta1;
  Interval theta2;
  Interval normal;
  Interval pi;

 private:
  [[nodiscard]] Interval quotient(const mpq_class& numerator, const Exact& young) const {
    Interval result(precision);
    const mpq_class exact = numerator / young.value();
    mpfi_set_q(result.get(), exact.get_mpq_t());
    return result;
  }
};

void check_poisson(const Exact& poisson) {
  if (poisson.value() <= -1 || 2 * poisson.value() > 1) {
    throw data::BadInput("poisson", poisson.approximate(), "must satisfy -1 < poisson <= 0.5");
  }
}

void check_material(const Exact& young, const Exact& poisson) {
  if (!std::isnormal(young.approximate()) || young.sign() < 0) {
    throw data::BadInput("young", young.approximate(), "must be > 0, from 2.3e-308 to 1.7e308");
  }
  check_poisson(poisson);
}

const Exact& unit() {
  static const Exact one(1.0);
  return one;
}

/// A lower bound of -ln of a displacement's size: every coefficient of a kernel is below 4/(pi young).
double size_nats(const Exact& young) { return std::log(young.approximate()) - std::log(4.0); }

/// As enclose(), for a displacement that is composed of kernels; `displacement(c, nats)` gets the nats that the kernels
/// need.
template <class Displacement>
Enclosure enclose_displacement(int digits, double kernel_nats, const Exact& young, const Exact& poisson,
                               Displacement displacement) {
  const double size = size_nats(young);
  return enclose(digits, std::max(0.0, kernel_nats + size), [&](double nats) {
    const double needed = std::max(nats - size, 40.0);
    return displacement(Compliances(young, poisson, needed), needed);
  });
}

Interval F1_times_normal(const Compliances& c, const Exact& eta, double nats) {
  return (c.theta2 * I4_interval(eta, nats) - c.theta1 * I5_interval(eta, nats)) / c.pi;
}

Interval us_interval(const Compliances& c, const Exact& alpha, double nats) {
  return (c.theta2 * I2_interval(alpha, nats) - c.normal * I3_interval(alpha, nats)) / c.pi;
}

}  // namespace

Enclosure F1(const Exact& eta, const Exact& poisson, int digits) {
  check_argument(eta, "eta");
  check_poisson(poisson);
  if (eta.sign() == 0) return exact_zero(digits);
  return enclose_displacement(digits, 0, unit(), poisson, [&](const Compliances& c, double nats) {
    return F1_times_normal(c, eta, nats) / c.normal;
  });
}

Enclosure F2(const Exact& eta, const Exact& poisson, int digits) {
  check_argument(eta, "eta");
  check_poisson(poisson);
  return enclose_displacement(digits, 0, unit(), poisson, [&](const Compliances& c, double nats) {
    return Interval(eta.magnitude(), c.precision + 16) / 4 - I6_eta_interval(eta, nats) / c.pi +
           c.theta1 / c.normal * I7_interval(eta, nats) / c.pi;
  });
}

Enclosure un(const Exact& alpha, const Exact& young, const Exact& poisson, int digits) {
  check_nonzero_argument(alpha, "alpha");
  check_material(young, poisson);
  const double kernel = slowest_decay * std::abs(alpha.approximate());
  return enclose_displacement(digits, kernel, young, poisson, [&](const Compliances& c, double nats) {
    return c.normal * I1_interval(alpha, nats) / c.pi;
  });
}

Enclosure vn(const Exact& alpha, const Exact& eta, const Exact& young, const Exact& poisson, int digits) {
  check_argument(alpha, "alpha");
  check_argument(eta, "eta");
  check_material(young, poisson);
  if (alpha.sign() == 0 && eta.sign() == 0) return exact_zero(digits);
  // Far from the load, on the side of the fixed point, both parts tend to the same limit.
  const bool same_side = alpha.sign() * eta.sign() > 0;
  const double nearer = std::min(std::abs(alpha.approximate()), std::abs(eta.approximate()));
  const double kernel = same_side ? slowest_decay * nearer : 0;
  return enclose_displacement(digits, kernel, young, poisson, [&](const Compliances& c, double nats) {
    return F1_times_normal(c, eta, nats) - us_interval(c, alpha, nats);
  });
}

Enclosure us(const Exact& alpha, const Exact& young, const Exact& poisson, int digits) {
  check_argument(alpha, "alpha");
  check_material(young, poisson);
  if (alpha.sign() == 0) return exact_zero(digits);
  return enclose_displacement(digits, 0, young, poisson,
                              [&](const Compliances& c, double nats) { return us_interval(c, alpha, nats); });
}

Enclosure vs(const Exact& alpha, const Exact& eta, const Exact& young, const Exact& poisson, int digits) {
  check_nonzero_argument(alpha, "alpha");
  check_argument(eta, "eta");
  check_material(young, poisson);
  const double kernel = nats_of_difference(alpha, eta);
  return enclose_displacement(digits, kernel, young, poisson, [&](const Compliances& c, double nats) {
    return (c.normal * I6_interval(alpha, eta, nats) + c.theta1 * I7_interval(eta, nats)) / c.pi;
  });
}

}  // namespace nipref::ref
