#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <nipref/fast/half_space/direction.hpp>
#include <nipref/verify/formulas/internal/formulas.hpp>

namespace nipref::verify {
namespace {

using Function = Formulas::Function;
using Numbers = Formulas::Numbers;
using Real = std::function<double(double)>;
using fast::Direction;

/// Returns x with the least distance at which `certain` holds as its error. Distances double from `first` times x on;
/// if `certain` holds at none, the error is infinite.
Propagated with_reach(double x, double first, const std::function<bool(double reach)>& certain) {
  for (double reach = first * std::fabs(x); reach < std::fabs(x); reach *= 2)
    if (certain(reach)) return {x, reach};
  return {x, std::numeric_limits<double>::infinity()};
}

Real values_of(const Function& f) {
  return [&](double x) { return f(x).value(); };
}

/// The integral of f. integrate(function, tolerance, &error, &size) is the integral of a function of a double. The
/// error is the rule's estimate of its truncation error, twice the integral of the errors of f, and the rounding error.
Propagated integral_by(const auto& integrate, const Function& f) {
  // A rule divides its intervals to the end if it cannot reach the tolerance, because the values have errors and the
  // errors jump. The integral of the errors is doubled below, so that a tenth of it suffices.
  constexpr double roughly = 0.1, finest = 1e-15;
  double truncation = 0, size = 0, unused = 0;
  const Real values = values_of(f), errors = [&](double x) { return f(x).error(); };
  integrate(values, roughly, &unused, &size);
  const double of_errors = integrate(errors, roughly, &unused, &unused);
  const double value = integrate(values, std::max(finest, of_errors / size), &truncation, &size);
  return {value, truncation + 2 * of_errors + 0x1p-50 * size};
}

/// The maximum of f, which rises before it and falls behind it. The error of its place reaches to where f is certainly
/// smaller.
struct Maximum {
  Propagated place, value;
};
Maximum maximum_of(const Function& f, double lower, double upper) {
  constexpr int binary_digits = 20;
  const double place = boost::math::tools::brent_find_minima([&](double x) { return -f(x).value(); }, lower,
                                                             upper, binary_digits)
                           .first;
  const Propagated value = f(place);
  double fall = 0;
  // A maximum is flat: the relative error of its place is about the square root of that of its value.
  const Propagated reached = with_reach(place, 0x1p-24, [&](double reach) {
    const Propagated below = value - f(place - reach), above = value - f(place + reach);
    fall = std::max(below.value() + below.error(), above.value() + above.error());
    return below.is_positive() && above.is_positive();
  });
  // Where f is concave, it rises on one side of the place by no more than it falls on the other.
  return {reached, {value.value(), value.error() + fall}};
}

/// certain(): 1 if x is positive beyond its error, otherwise 0. within(): 0 with this error. without_error(): exact.
Propagated certain(const Propagated& x) { return Propagated::exact(x.is_positive() ? 1 : 0); }
Propagated within(const Propagated& error) { return {0, error.value()}; }
Propagated without_error(const Propagated& x) { return Propagated::exact(x.value()); }

template <Propagated (*functional)(const Function&, double, double)>
Propagated of_range(const Function& f, const Numbers& at) {
  return functional(f, at[0].value(), at[1].value());
}

/// int_from^to f, which may be singular at the ends in an integrable way.
Propagated integral(const Function& f, double from, double to) {
  boost::math::quadrature::tanh_sinh<double> rule;
  return integral_by([&](const auto& g, auto... how) { return rule.integrate(g, from, to, how...); }, f);
}

/// The same for a smooth f.
Propagated smooth_integral(const Function& f, double from, double to) {
  constexpr unsigned halvings = 12;
  return integral_by(
      [&](const auto& g, auto... how) {
        return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(g, from, to, halvings, how...);
      },
      f);
}

/// int_0^inf f
Propagated half_line_integral(const Function& f, const Numbers&) {
  boost::math::quadrature::exp_sinh<double> rule;
  return integral_by([&](const auto& g, auto... how) { return rule.integrate(g, how...); }, f);
}

/// (1/pi) times the principal value of int_from^to f(t)/(t - x) dt. `at` has x, from and to; from < x < to.
Propagated hilbert(const Function& f, const Numbers& at) {
  const double x = at[0].value(), from = at[1].value(), to = at[2].value();
  const auto distance = [](double a, double b) { return Propagated::exact(a) - Propagated::exact(b); };
  const Propagated at_x = f(x);
  const Function rest = [&](double t) {
    return t == x ? Propagated::exact(0) : (f(t) - at_x) / distance(t, x);
  };
  return (integral(rest, from, x) + integral(rest, x, to) + at_x * log(distance(to, x) / distance(x, from))) /
         Propagated::pi();
}

/// f'(x) by central differences with halved steps, extrapolated to 0 (Ridders). The result is the extrapolated value of
/// least error, the last change plus the propagated errors of f. f must be analytic within several steps.
Propagated derivative(const Function& f, double x, double step) {
  constexpr int halvings = 7;
  Propagated best(0, std::numeric_limits<double>::infinity());
  std::vector<Propagated> last;
  for (int k = 0; k < halvings; ++k) {
    const double h = std::ldexp(step, -k), above = x + h, below = x - h;
    std::vector<Propagated> row{(f(above) - f(below)) /
                                (Propagated::exact(above) - Propagated::exact(below))};
    for (std::size_t j = 0; j < last.size(); ++j) {
      const Propagated change = (row[j] - last[j]) / (std::pow(4.0, j + 1) - 1);
      row.push_back(row[j] + change);
      const double changed = std::max(std::fabs(row[j + 1].value() - row[j].value()),
                                      std::fabs(row[j + 1].value() - last[j].value()));
      if (row[j + 1].error() + changed < best.error())
        best = {row[j + 1].value(), row[j + 1].error() + changed};
    }
    last = row;
  }
  return best;
}

/// The place where f changes its sign, between two places at which its signs differ. Its error reaches to where the
/// signs are certain.
Propagated sign_change(const Function& f, double lower, double upper) {
  constexpr int binary_digits = 44;
  std::uintmax_t steps = 100;
  const auto ends =
      boost::math::tools::toms748_solve([&](double x) { return f(x).value(); }, lower, upper,
                                        boost::math::tools::eps_tolerance<double>(binary_digits), steps);
  const double root = std::midpoint(ends.first, ends.second);
  return with_reach(root, 0x1p-46, [&](double reach) {
    const Propagated below = f(root - reach), above = f(root + reach);
    return (below.is_positive() && above.is_negative()) || (below.is_negative() && above.is_positive());
  });
}

/// f at a place with an error, within which f must be monotonic.
Propagated monotonic(const Function& f, const Numbers& at) {
  const Propagated& place = at[0];
  const Propagated below = f(place.value() - place.error()), above = f(place.value() + place.error());
  return below.value() < above.value() ? Propagated::between(below, above)
                                       : Propagated::between(above, below);
}

Propagated largest(const Function& f, double lower, double upper) {
  return maximum_of(f, lower, upper).value;
}
Propagated place_of_largest(const Function& f, double lower, double upper) {
  return maximum_of(f, lower, upper).place;
}

// Functions without known errors. Sines and cosines of degrees, and of the angle psi turned by degrees, keep their
// digits near 90 degrees.
Propagated alone(double value) { return {value, std::numeric_limits<double>::infinity()}; }
Propagated floor(const Propagated& x) { return alone(std::floor(x.value())); }
Propagated round(const Propagated& x) { return alone(std::round(x.value())); }
Propagated log1p(const Propagated& x) { return alone(std::log1p(x.value())); }
Propagated atan2(const Propagated& y, const Propagated& x) { return alone(std::atan2(y.value(), x.value())); }
Propagated nextafter(const Propagated& x, const Propagated& to) {
  return alone(std::nextafter(x.value(), to.value()));
}
Propagated cosine(const Propagated& degrees) { return alone(Direction::of_degrees(degrees.value()).cosine); }
Propagated sine(const Propagated& degrees) { return alone(Direction::of_degrees(degrees.value()).sine); }
Direction turned(const Propagated& psi, const Propagated& degrees) {
  return Direction::of_angle(psi.value()).turned(Direction::of_degrees(degrees.value()));
}
Propagated turned_cosine(const Propagated& psi, const Propagated& degrees) {
  return alone(turned(psi, degrees).cosine);
}
Propagated turned_sine(const Propagated& psi, const Propagated& degrees) {
  return alone(turned(psi, degrees).sine);
}
Propagated quick_integral(const Function& f, double from, double to) {
  return alone(boost::math::quadrature::tanh_sinh<double>().integrate(values_of(f), from, to));
}
Propagated quick_smooth_integral(const Function& f, double from, double to) {
  return alone(
      boost::math::quadrature::gauss_kronrod<double, 31>::integrate(values_of(f), from, to, 10, 1e-10));
}

}  // namespace

const std::map<std::string, OfOne*> FormulaWords::of_one{
    {"fabs", fabs},       {"sqrt", sqrt},     {"exp", exp},
    {"expm1", expm1},     {"log", log},       {"log1p", log1p},
    {"sinh", sinh},       {"cosh", cosh},     {"tanh", tanh},
    {"atanh", atanh},     {"sin", sin},       {"cos", cos},
    {"tan", tan},         {"atan", atan},     {"cosine", cosine},
    {"sine", sine},       {"floor", floor},   {"round", round},
    {"certain", certain}, {"within", within}, {"exactly", without_error}};
const std::map<std::string, OfTwo*> FormulaWords::of_two{{"hypot", hypot},
                                                         {"pow", pow},
                                                         {"atan2", atan2},
                                                         {"nextafter", nextafter},
                                                         {"turned_cosine", turned_cosine},
                                                         {"turned_sine", turned_sine}};
const std::map<std::string, Functional> FormulaWords::functionals{
    {"integral", {2, of_range<integral>}},
    {"smooth_integral", {2, of_range<smooth_integral>}},
    {"derivative", {2, of_range<derivative>}},
    {"sign_change", {2, of_range<sign_change>}},
    {"place_of_largest", {2, of_range<place_of_largest>}},
    {"largest", {2, of_range<largest>}},
    {"half_line_integral", {0, half_line_integral}},
    {"hilbert", {3, hilbert}},
    {"monotonic", {1, monotonic}},
    {"quick_integral", {2, of_range<quick_integral>}},
    {"quick_smooth_integral", {2, of_range<quick_smooth_integral>}}};

}  // namespace nipref::verify
