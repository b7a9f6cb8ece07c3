#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <nipref/verify/seeds/internal/numerics.hpp>

namespace nipref::verify {
namespace {

/// The least distance from x, doubled from `first` of it on, at which `certain`; as an error of x, infinite if it is so
/// nowhere.
Propagated with_reach(double x, double first, const std::function<bool(double reach)>& certain) {
  for (double reach = first * std::fabs(x); reach < std::fabs(x); reach *= 2) {
    if (certain(reach)) return {x, reach};
  }
  return {x, std::numeric_limits<double>::infinity()};
}

}  // namespace

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

Largest largest(const Function& f, double lower, double upper) {
  constexpr int binary_digits = 20;
  const double place = boost::math::tools::brent_find_minima([&](double x) { return -f(x).value(); }, lower,
                                                             upper, binary_digits)
                           .first;
  const Propagated value = f(place);
  double fall = 0;
  // A maximum is flat: what rounding is to its value, its root is to its place.
  const Propagated reached = with_reach(place, 0x1p-24, [&](double reach) {
    const Propagated below = value - f(place - reach), above = value - f(place + reach);
    fall = std::max(below.value() + below.error(), above.value() + above.error());
    return below.is_positive() && above.is_positive();
  });
  // Where f is concave, it rises on one side of the place by no more than it falls on the other.
  return {reached, {value.value(), value.error() + fall}};
}

}  // namespace nipref::verify
