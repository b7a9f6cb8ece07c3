#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/magnitude.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/material/internal/partial_fractions.hpp>
#include <nipref/fast/material/rational_solid.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/number/internal/sized.hpp>

namespace nipref::fast {
namespace {

using internal::check_not_negative;
using internal::Octuple;
using internal::OctupleComplex;
using internal::Operators;
using internal::Polynomial;
using internal::product;
using internal::Rational;
using internal::Sized;
using internal::sum;

using Points = std::vector<OctupleComplex>;

/// The divided difference of e^x over n points that are within 1 of each other. It is e^mean sum_m h_m/(m + n - 1)!,
/// where h_m is the complete symmetric polynomial of degree m of the points minus their mean.
OctupleComplex near_difference(const Points& x) {
  OctupleComplex mean;
  for (const OctupleComplex& point : x) mean += point;
  mean /= x.size();
  constexpr int most_terms = 70;
  std::vector<OctupleComplex> symmetric(most_terms);
  symmetric[0] = 1;
  for (const OctupleComplex& point : x) {
    for (std::size_t m = 1; m < symmetric.size(); ++m) symmetric[m] += (point - mean) * symmetric[m - 1];
  }
  Octuple over = 1;
  for (std::size_t k = 2; k < x.size(); ++k) over /= Octuple(k);
  OctupleComplex sum;
  for (std::size_t m = 0; m < symmetric.size(); ++m) {
    if (m > 0) over /= Octuple(m + x.size() - 1);
    sum += over * symmetric[m];
  }
  return exp(mean) * sum;
}

/// Divided differences of e^x over subsets of the points. If a subset's points are not all within 1 of each other, the
/// recurrence leaves out one of the two farthest at a time. Results are stored, as larger subsets share smaller ones.
class ExponentialDifferences {
 public:
  using Numbers = std::vector<std::size_t>;

  explicit ExponentialDifferences(Points x) : x_(std::move(x)) {}

  /// The divided difference over the points with these numbers.
  const OctupleComplex& over(const Numbers& some) {
    const auto found = found_.find(some);
    return found != found_.end() ? found->second : found_.emplace(some, computed(some)).first->second;
  }

 private:
  OctupleComplex computed(const Numbers& some) {
    std::size_t first = 0, second = 0;
    Octuple farthest = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t j = i + 1; j < some.size(); ++j) {
        const Octuple square = norm(x_[some[i]] - x_[some[j]]);
        if (square > farthest) {
          farthest = square;
          first = i;
          second = j;
        }
      }
    }
    if (farthest <= 1) {
      Points near;
      for (const std::size_t i : some) near.push_back(x_[i]);
      return near_difference(near);
    }
    const auto without = [&](std::size_t i) {
      Numbers others = some;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      return over(others);
    };
    return (without(second) - without(first)) / (x_[some[first]] - x_[some[second]]);
  }

  Points x_;
  std::map<Numbers, OctupleComplex> found_;
};

/// Throws BadInput if five roots of a factor are within 1e-9 of each other, as then only a fifth of their digits is right.
void check_apart(const Points& roots) {
  for (const OctupleComplex& root : roots) {
    const auto near = std::ranges::count_if(
        roots, [&](const OctupleComplex& other) { return abs(other - root) <= 1e-9 * abs(root); });
    if (near >= 5)
      throw data::BadInput("material", "(its rates)", "must not have five rates within 1e-9 of each other");
  }
}

/// The divided differences of a polynomial over the first node, the first two and so on, by synthetic division. They are
/// its coefficients in Newton's form.
Points newton_coefficients(Points polynomial, const Points& nodes) {
  for (std::size_t k = 0; k < polynomial.size(); ++k)
    for (std::size_t i = polynomial.size() - 1; i-- > k;) polynomial[i] += nodes[k] * polynomial[i + 1];
  return polynomial;
}

/// The function of time, t >= 0, that has this transform, without its impulses at 0. It consists of divided differences
/// of e^(p t) over the roots of the denominator, which may coincide. The error is below 2^-150 of the size. Throws
/// BadInput if five roots of one factor nearly coincide.
Sized<Octuple> inverse_transform(const Rational& transform, double t) {
  Points roots;
  for (const Polynomial& factor : transform.denominator) {
    const Points more = internal::roots_of(factor);
    check_apart(more);
    roots.insert(roots.end(), more.begin(), more.end());
  }
  const Polynomial denominator = product(transform.denominator);
  const Polynomial proper = product(transform.numerator) % denominator;
  Points numerator, exponents = roots;
  for (const Octuple& c : proper.data()) numerator.emplace_back(c / denominator.data().back());
  for (OctupleComplex& root : exponents) root *= t;
  Octuple slowest = roots.empty() ? Octuple(0) : exponents.front().real(), value = 0, size = 0;
  for (const OctupleComplex& exponent : exponents) slowest = std::max<Octuple>(slowest, exponent.real());
  ExponentialDifferences differences(std::move(exponents));
  // Leibniz's rule for divided differences of a product: the sum over k of that of the polynomial over the roots up to
  // the k-th times that of the exponential over the roots from the k-th on.
  const Points coefficients = newton_coefficients(std::move(numerator), roots);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    ExponentialDifferences::Numbers from_k(roots.size() - k);
    std::iota(from_k.begin(), from_k.end(), k);
    Octuple power = 1, factorial = 1;
    for (std::size_t n = 1; n < from_k.size(); ++n) {
      power *= t;
      factorial *= static_cast<double>(n);
    }
    value += power * OctupleComplex(coefficients[k] * differences.over(from_k)).real();
    size += power / factorial * abs(coefficients[k]) * exp(slowest);
  }
  return {value, size};
}

/// The ratio of Fading::size to the sum of the terms' magnitudes. The relative errors of the terms are smaller.
constexpr double least_scale = 0x1p-150;

struct Solid {
  Operators shear, dilatation;
  internal::Compliances compliances;
};

void check_part(const std::string& name, double value) {
  if (!(value == 0 || data::is_magnitude(std::fabs(value))))
    throw data::BadInput(name, value, "must be 0 or of a magnitude from 1e-60 to 1e60");
}

void check_not_below_0(const std::string& name, double value) {
  check_part(name, value);
  if (value < 0) throw data::BadInput(name, value, "must be >= 0");
}

/// The transform of theta1 or theta2.
Rational series_of(const data::PronyList& list, const std::string& name) {
  check_not_below_0(name + "_instantaneous", list.instantaneous);
  Polynomial numerator{list.instantaneous}, denominator{1};
  std::vector<Polynomial> factors;
  // Terms of equal rate are added, as a root that many factors share would be found to few digits.
  std::map<double, Octuple> by_rate;
  for (std::size_t i = 0; i < list.rates.size(); ++i) {
    const std::string number = i == 0 ? "" : "_" + std::to_string(i + 1);
    check_part(name + "_amplitude" + number, list.amplitudes[i]);
    check_not_below_0(name + "_rate" + number, list.rates[i]);
    if (list.amplitudes[i] != 0) by_rate[list.rates[i]] += list.amplitudes[i];
  }
  for (const auto& [rate, amplitude] : by_rate) {
    const Polynomial factor{rate, 1};
    numerator = sum(numerator * factor, amplitude * denominator);
    denominator *= factor;
    factors.push_back(factor);
  }
  if (numerator.is_zero()) throw data::BadInput(name, "0 at all times", "must have a constant that is not 0");
  return {{numerator}, factors};
}

Polynomial polynomial_of(const std::vector<double>& coefficients, const std::string& name) {
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    check_not_below_0(name + "_" + std::to_string(k), coefficients[k]);
  Polynomial p(coefficients.begin(), coefficients.end());
  if (p.is_zero()) throw data::BadInput(name, "0", "must have a coefficient that is not 0");
  return p;
}

Operators operators_of(const std::vector<double>& p, const std::vector<double>& q,
                       const std::string& suffix) {
  Operators both{polynomial_of(p, "P" + suffix), polynomial_of(q, "Q" + suffix)};
  if (both.q.size() < both.p.size() || both.q.size() > both.p.size() + 1) {
    throw data::BadInput("Q" + suffix, "of degree " + std::to_string(both.q.size() - 1),
                         "must be of the degree of P" + suffix + ", " + std::to_string(both.p.size() - 1) +
                             ", or of one more: what gives way without bound at once is no solid");
  }
  return both;
}

struct Build {
  Solid operator()(const data::PronySeries& both) const {
    return of_compliances({series_of(both.theta1, "theta1"), series_of(both.theta2, "theta2")});
  }
  Solid operator()(const data::DifferentialOperators& x) const {
    const Operators shear = operators_of(x.p, x.q, ""),
                    dilatation = operators_of(x.p_dilatation, x.q_dilatation, "_dilatation");
    return {shear, dilatation, compliances_of(shear, dilatation)};
  }
  Solid operator()(const data::SingleRelaxationTimeSolid& x) const {
    data::check_magnitude("bulk", x.bulk);
    data::check_magnitude("shear", x.shear);
    data::check_magnitude("tau", x.relaxation_time);
    const Octuple tau = x.relaxation_time, shear = x.shear, both = 6 * Octuple(x.bulk) + 2 * shear;
    const Octuple factor = x.theta2_rate_factor;
    // theta1 = (2 + tau p)/(2 shear (1 + tau p)), theta2 = 3 (1 + factor + tau p)/(both (factor + tau p))
    const Polynomial n1{2, tau}, n2{3 * (1 + factor), 3 * tau};
    const Polynomial d1{2 * shear, 2 * shear * tau}, d2{factor * both, both * tau};
    return of_compliances({{{n1}, {d1}}, {{n2}, {d2}}});
  }

 private:
  /// G = 1/(2 theta1), 6K = 3/theta2 - 1/theta1.
  static Solid of_compliances(const internal::Compliances& both) {
    const Polynomial n1 = product(both.theta1.numerator), d1 = product(both.theta1.denominator);
    const Polynomial n2 = product(both.theta2.numerator), d2 = product(both.theta2.denominator);
    return {{2 * n1, d1}, {6 * n1 * n2, sum(3 * d2 * n1, -1 * d1 * n2), {{6}, n1, n2}}, both};
  }
};

Solid built(const RationalSolid& solid) { return std::visit(Build{}, solid); }

const Operators& of_strain(const Solid& solid, Strain of) {
  return of == Strain::shear ? solid.shear : solid.dilatation;
}

Fading rounded(const Sized<Octuple>& found, const char* name, double at) {
  const Fading result{static_cast<double>(found.value), least_scale * static_cast<double>(found.size)};
  if (!std::isfinite(result.value))
    throw data::BadInput(name, at, "must be where the value is within the range of doubles");
  return {result.value, std::isfinite(result.size) ? result.size : 0};
}

Fading in_time(const Rational& transform, double t) {
  check_not_negative("t", t);
  return rounded(inverse_transform(transform, t), "t", t);
}

/// The value of a polynomial at growth + i omega, and the sum of its terms' magnitudes.
struct AtPoint {
  OctupleComplex value;
  Octuple size = 0;

  AtPoint(const Polynomial& p, double growth, double omega) {
    const OctupleComplex z(growth, omega);
    const Octuple radius = abs(z);
    for (auto c = p.data().rbegin(); c != p.data().rend(); ++c) {
      value = value * z + *c;
      size = size * radius + abs(*c);
    }
  }
};

}  // namespace

data::MaterialFunctions material_functions(const RationalSolid& solid) {
  const auto [theta1, theta2] = built(solid).compliances;
  return {partial_fractions(theta1, "theta1", internal::of_exact),
          partial_fractions(theta2, "theta2", internal::of_exact)};
}

Fading relaxation(const RationalSolid& solid, Strain of, double t) {
  const Solid all = built(solid);
  const Operators& modulus = of_strain(all, of);
  std::vector<Polynomial> factors = modulus.factors;
  factors.push_back({0, 1});
  return in_time({{modulus.q}, factors}, t);
}

Fading creep(const RationalSolid& solid, Strain of, double t) {
  const Solid all = built(solid);
  const Operators& modulus = of_strain(all, of);
  if (modulus.q.is_zero())
    throw data::BadInput("theta2", "3 theta1 at all times", "must be less: nothing resists dilatation");
  return in_time({{modulus.p}, {{0, 1}, modulus.q}}, t);
}

Fading storage(const RationalSolid& solid, Strain of, double omega) {
  return modulus_at(solid, of, 0, omega, false);
}

Fading loss(const RationalSolid& solid, Strain of, double omega) {
  return modulus_at(solid, of, 0, omega, true);
}

Fading modulus_at(const RationalSolid& solid, Strain of, double p, double omega, bool imaginary) {
  check_not_negative("p", p);
  check_not_negative("omega", omega);
  const Solid all = built(solid);
  const Operators& modulus = of_strain(all, of);
  const AtPoint n(modulus.q, p, omega), d(modulus.p, p, omega);
  const auto [name, at] = p == 0 ? std::pair("omega", omega) : std::pair("p", p);
  if (d.value == 0) throw data::BadInput(name, at, "must not be where the modulus is infinite");
  const OctupleComplex value = n.value / d.value;
  return rounded({imaginary ? value.imag() : value.real(), n.size * d.size / norm(d.value)}, name, at);
}

Fading theta1(const RationalSolid& solid, double t) { return in_time(built(solid).compliances.theta1, t); }
Fading theta2(const RationalSolid& solid, double t) { return in_time(built(solid).compliances.theta2, t); }

}  // namespace nipref::fast
