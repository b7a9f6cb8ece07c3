#include <algorithm>
#include <cmath>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

void check_material(const Exact& young, const Exact& poisson) {
  if (!std::isnormal(young.approximate()) || young.sign() < 0) {
    throw data::BadInput("young", young.approximate(), "must be > 0, from 2.3e-308 to 1.7e308");
  }
  check_poisson(poisson);
}

/// A lower bound of -ln of a displacement's size: every coefficient of a kernel is below 4/(pi young).
double size_nats(const Exact& young) { return std::log(young.approximate()) - std::log(4.0); }

/// N times over_normal(nats), an interval of half-width about e^{-nats}.
template <class OverNormal>
Enclosure enclose_displacement(int digits, double kernel_nats, const Exact& young, const Exact& poisson,
                               const OverNormal& over_normal) {
  const double size = size_nats(young);
  const Exact normal(normal_compliance(young, poisson));
  return enclose(digits, std::max(0.0, kernel_nats + size), [&](double nats) {
    const double needed = std::max(nats - size, 40.0);
    const Interval value = over_normal(needed);
    return Interval(normal, value.precision()) * value;
  });
}

/// us/N.
Interval us_interval(const ThetaShares& shares, const Exact& alpha, double nats) {
  const Interval I2 = I2_interval(alpha, nats), pi = Interval::pi(working_precision(nats, 1));
  return (Interval(shares.theta2, I2.precision()) * I2 - I3_interval(alpha, nats)) / pi;
}

Enclosure fixed_point_part(data::SheetLoad load, const Exact& eta, const Exact& poisson, int digits) {
  check_argument(eta, "eta");
  check_poisson(poisson);
  return enclose(digits, 0, [&](double nats) {
    return fixed_point_interval(load, eta, ThetaShares(poisson), std::max(nats, 40.0));
  });
}

}  // namespace

Enclosure F1(const Exact& eta, const Exact& poisson, int digits) {
  if (eta.sign() == 0) {
    check_poisson(poisson);
    return exact_zero(digits);
  }
  return fixed_point_part(data::SheetLoad::normal, eta, poisson, digits);
}

Enclosure F2(const Exact& eta, const Exact& poisson, int digits) {
  return fixed_point_part(data::SheetLoad::shear, eta, poisson, digits);
}

Enclosure un(const Exact& alpha, const Exact& young, const Exact& poisson, int digits) {
  check_nonzero_argument(alpha, "alpha");
  check_material(young, poisson);
  const double kernel = slowest_decay * std::abs(alpha.approximate());
  return enclose_displacement(digits, kernel, young, poisson, [&](double nats) {
    const Interval I1 = I1_interval(alpha, nats);
    return I1 / Interval::pi(I1.precision());
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
  const ThetaShares shares(poisson);
  return enclose_displacement(digits, kernel, young, poisson, [&](double nats) {
    return fixed_point_interval(data::SheetLoad::normal, eta, shares, nats) -
           us_interval(shares, alpha, nats);
  });
}

Enclosure us(const Exact& alpha, const Exact& young, const Exact& poisson, int digits) {
  check_argument(alpha, "alpha");
  check_material(young, poisson);
  if (alpha.sign() == 0) return exact_zero(digits);
  return enclose_displacement(digits, 0, young, poisson,
                              [&](double nats) { return us_interval(ThetaShares(poisson), alpha, nats); });
}

Enclosure vs(const Exact& alpha, const Exact& eta, const Exact& young, const Exact& poisson, int digits) {
  check_nonzero_argument(alpha, "alpha");
  check_argument(eta, "eta");
  check_material(young, poisson);
  const double kernel = nats_of_difference(alpha, eta);
  return enclose_displacement(digits, kernel, young, poisson, [&](double nats) {
    const Interval I6 = I6_interval(alpha, eta, nats), pi = Interval::pi(I6.precision()),
                   theta1(Exact(ThetaShares(poisson).theta1), I6.precision());
    return (I6 + theta1 * I7_interval(eta, nats)) / pi;
  });
}

}  // namespace nipref::ref
