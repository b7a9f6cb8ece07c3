#pragma once
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

namespace nipref::verify {

/// int_from^to f, which may be singular at the ends in an integrable way.
double integral_between(const auto& f, double from, double to) {
  return boost::math::quadrature::tanh_sinh<double>().integrate(f, from, to, 1e-15);
}

/// (1/pi) vp int_from^to f(t)/(t - x) dt, from < x < to: what is left without f(x), on either side of x.
double hilbert(const auto& f, double x, double from, double to) {
  const double at_x = f(x);
  const auto rest = [&](double t) { return t == x ? 0 : (f(t) - at_x) / (t - x); };
  return (integral_between(rest, from, x) + integral_between(rest, x, to) +
          at_x * std::log((to - x) / (x - from))) /
         boost::math::constants::pi<double>();
}

}  // namespace nipref::verify
