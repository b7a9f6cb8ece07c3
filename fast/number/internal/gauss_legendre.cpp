#include <boost/math/special_functions/legendre.hpp>

#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {

GaussRule gauss_legendre(const int& count) {
  GaussRule rule;
  const auto add = [&](long double zero) {
    const long double slope = boost::math::legendre_p_prime(count, zero);
    rule.at.push_back(static_cast<double>((1 + zero) / 2));
    rule.weight.push_back(static_cast<double>(1 / ((1 - zero * zero) * slope * slope)));
  };
  for (const long double zero : boost::math::legendre_p_zeros<long double>(count)) {
    add(zero);
    if (zero != 0) add(-zero);
  }
  return rule;
}

}  // namespace nipref::fast
