#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include <nipref/ref/material/internal/inverse_transform.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

using Points = std::vector<ComplexInterval>;

ComplexInterval divided(const ComplexInterval& z, long by) { return {z.re / by, z.im / by}; }

/// The divided difference of e^x for points within a distance of 1, by its series. The truncation error is below
/// 2/(M! k!).
ComplexInterval near_difference(const Points& x, mpfr_prec_t bits) {
  const auto count = static_cast<long>(x.size());
  ComplexInterval mean{Interval(bits)};
  for (const ComplexInterval& point : x) mean = mean + point;
  mean = divided(mean, count);
  long terms = 4;
  for (double left = static_cast<double>(bits) + 8; left > 0; ++terms)
    left -= std::log2(static_cast<double>(terms - 3));
  Points symmetric(static_cast<std::size_t>(terms), ComplexInterval(Interval(bits)));
  symmetric[0].re = Interval(1L, bits);
  for (const ComplexInterval& point : x) {
    for (std::size_t m = 1; m < symmetric.size(); ++m)
      symmetric[m] = symmetric[m] + (point - mean) * symmetric[m - 1];
  }
  // Nested from the last term on: (..(h_M/(M + k) + h_(M-1))/(M + k - 1) ..)
  ComplexInterval sum{Interval(bits)};
  for (long m = terms - 1; m >= 0; --m) {
    sum = sum + symmetric[static_cast<std::size_t>(m)];
    if (m > 0) sum = divided(sum, m + count - 1);
  }
  for (long k = 2; k < count; ++k) sum = divided(sum, k);
  Interval rest(1L, 64);
  mpfi_mul_2si(rest.get(), rest.get(), -bits);
  return exp(mean) * ComplexInterval{sum.re.widened(rest), sum.im.widened(rest)};
}

/// The divided differences of e^x over some of the points, by the recurrence for the two that are farthest from each
/// other. Each is computed once, as the recurrence comes to the same points in many ways.
class ExponentialDifferences {
 public:
  using Numbers = std::vector<std::size_t>;

  ExponentialDifferences(Points x, mpfr_prec_t bits) : x_(std::move(x)), bits_(bits) {}

  /// Over the points of these numbers.
  const ComplexInterval& over(const Numbers& some) {
    const auto found = found_.find(some);
    return found != found_.end() ? found->second : found_.emplace(some, computed(some)).first->second;
  }

 private:
  ComplexInterval computed(const Numbers& some) {
    if (some.size() == 1) return exp(x_[some.front()]);
    std::size_t first = 0, second = 1;
    Interval farthest(-1L, 64);
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t j = i + 1; j < some.size(); ++j) {
        const Interval apart = abs(x_[some[i]] - x_[some[j]]);
        if (mpfr_cmp(apart.upper(), farthest.upper()) > 0) {
          farthest = apart;
          first = i;
          second = j;
        }
      }
    }
    if (mpfr_cmp_ui(farthest.upper(), 1) <= 0) {
      Points near;
      for (const std::size_t i : some) near.push_back(x_[i]);
      return near_difference(near, bits_);
    }
    const auto without = [&](std::size_t i) {
      Numbers others = some;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      return over(others);
    };
    return (without(second) - without(first)) * inverse(x_[some[first]] - x_[some[second]]);
  }

  Points x_;
  mpfr_prec_t bits_;
  std::map<Numbers, ComplexInterval> found_;
};

/// The divided differences of a polynomial over the first root, the first two roots, ..., by synthetic division.
Points polynomial_differences(Points rest, const Points& roots) {
  Points found;
  for (std::size_t k = 0; k < roots.size() && !rest.empty(); ++k) {
    for (std::size_t i = rest.size() - 1; i-- > 0;) rest[i] = rest[i] + roots[k] * rest[i + 1];
    found.push_back(rest.front());
    rest.erase(rest.begin());
  }
  return found;
}

/// A bound of a divided difference over n roots, without the factor e^(mu t): the sum of |p[z_1..z_k]| t^(n-k)/(n-k)!.
Interval bound_of(const Points& differences, std::size_t roots, const Interval& t) {
  Interval sum(t.precision());
  for (std::size_t k = 0; k < differences.size(); ++k) {
    Interval term = abs(differences[k]);
    for (std::size_t m = 1; m + k < roots; ++m) term = term * t / static_cast<long>(m);
    sum = sum + term;
  }
  return sum;
}

Points over_last(const Polynomial& numerator, const mpq_class& last, mpfr_prec_t bits) {
  Points result;
  for (const mpq_class& c : numerator)
    result.push_back({Interval(mpq_class(c / last), bits), Interval(bits)});
  return result;
}

/// (D - D~)/d
Points backward_error(const Polynomial& denominator, const Points& roots, mpfr_prec_t bits) {
  Points formed{{Interval(1L, bits), Interval(bits)}};
  for (const ComplexInterval& root : roots) {
    formed.insert(formed.begin(), ComplexInterval(Interval(bits)));
    for (std::size_t k = 0; k + 1 < formed.size(); ++k) formed[k] = formed[k] - root * formed[k + 1];
  }
  Points error = over_last(denominator, denominator.back(), bits);
  for (std::size_t k = 0; k < error.size(); ++k) error[k] = error[k] - formed[k];
  error.pop_back();
  return error;
}

}  // namespace

Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits) {
  const Interval time(t, bits);
  Points roots, faded;
  Interval mu(bits);
  for (const ComplexInterval& root : roots_near(denominator, bits)) {
    mu = roots.empty() ? root.re : larger_of(mu, root.re);
    roots.push_back(root);
    faded.push_back(time * root);
  }
  const Points differences = polynomial_differences(over_last(numerator, denominator.back(), bits), roots);
  ComplexInterval value{Interval(bits)};
  ExponentialDifferences exponential(std::move(faded), bits);
  ExponentialDifferences::Numbers left(roots.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (const ComplexInterval& difference : differences) {
    ComplexInterval term = difference * exponential.over(left);
    for (std::size_t m = 1; m < left.size(); ++m) term = time * term;
    value = value + term;
    left.erase(left.begin());
  }
  const Interval size = bound_of(differences, roots.size(), time) * exp(mu * time);
  const Points error = polynomial_differences(backward_error(denominator, roots, bits), roots);
  return value.re.widened(size * expm1(bound_of(error, roots.size(), time) * time));
}

double slowest_rate(const Polynomial& denominator) {
  double slowest = INFINITY;
  for (const ComplexInterval& root : roots_near(denominator, 200))
    slowest = std::min(slowest, -mpfr_get_d(root.re.lower(), MPFR_RNDD));
  return slowest;
}

}  // namespace nipref::ref
