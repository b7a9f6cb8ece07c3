#pragma once
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <functional>

#include <nipref/verify/seeds/propagated.hpp>

namespace nipref::verify {

/// A rule's integral of f: its own estimate of what it leaves out, what errors of f make of it, and rounding of the sum.
/// `integrate`: of a function of a double, with a tolerance, the error's and the integrand's size.
Propagated integral_by(const auto& integrate, const auto& f) {
  double left_out = 0, size = 0, unused = 0;
  const double value =
      integrate([&](double x) { return f(Propagated::exact(x)).value(); }, 1e-15, &left_out, &size);
  const double carried =
      integrate([&](double x) { return f(Propagated::exact(x)).error(); }, 1e-2, &unused, &unused);
  return {value, left_out + 2 * carried + 0x1p-50 * size};
}

/// int_from^to f, which may be singular at the ends in an integrable way.
Propagated integral_between(const auto& f, double from, double to) {
  boost::math::quadrature::tanh_sinh<double> rule;
  return integral_by([&](const auto& g, auto... how) { return rule.integrate(g, from, to, how...); }, f);
}

/// The same of a smooth f.
Propagated smooth_integral(const auto& f, double from, double to) {
  constexpr unsigned halvings = 12;
  return integral_by(
      [&](const auto& g, auto... how) {
        return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(g, from, to, halvings, how...);
      },
      f);
}

/// (1/pi) vp int_from^to f(t)/(t - x) dt, from < x < to: what is left without f(x), on either side of x.
Propagated hilbert(const auto& f, double x, double from, double to) {
  const Propagated place = Propagated::exact(x), at_x = f(place);
  const auto rest = [&](const Propagated& t) {
    return t.value() == x ? Propagated::exact(0) : (f(t) - at_x) / (t - place);
  };
  return (integral_between(rest, from, x) + integral_between(rest, x, to) +
          at_x * log((Propagated::exact(to) - place) / (place - Propagated::exact(from)))) /
         Propagated::pi();
}

using Function = std::function<Propagated(double)>;

/// f'(x) by central differences with steps halved and extrapolated to 0 (Ridders): of the values extrapolated that whose
/// error is least, which is what the last extrapolation changed and what errors of f make of it. f is analytic within
/// several steps.
Propagated derivative(const Function& f, double x, double step);

/// Where f changes its sign between two places at which its signs differ: the error reaches to where they are certain.
Propagated sign_change(const Function& f, double lower, double upper);

/// The largest value of f, which rises to it and falls from it, and its place: the place's error reaches to where f is
/// certainly smaller.
struct Largest {
  Propagated place, value;
};
Largest largest(const Function& f, double lower, double upper);

}  // namespace nipref::verify
