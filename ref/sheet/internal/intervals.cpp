#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>

namespace nipref::ref {
namespace {

constexpr int slack_bits = 24;

/// ln coth(pi a/3) = ln(1 + 2/(e^{2 pi a/3} - 1)), relatively accurate for every a > 0.
Interval log_coth(const Exact& a, double nats) {
  const double relative_nats = std::max(0.0, nats - 2 * a.approximate());
  const mpfr_prec_t precision = working_precision(relative_nats, 1 << 14);
  const Interval exponent = 2 * Interval::pi(precision) * Interval(a, precision) / 3;
  return log1p(2 / expm1(exponent));
}

/// The transform of a symbol other than that of I1 at x >= 0, by the cheaper of the two methods.
Interval cheaper_transform(Symbol symbol, const Exact& x, double nats) {
  return residues_are_cheaper(x.approximate(), nats) ? residue_series(symbol, x, nats)
                                                     : transform(symbol, x, nats);
}

Interval odd(Symbol symbol, const Exact& x, double nats) {
  const Interval value = cheaper_transform(symbol, x.magnitude(), nats);
  return x.sign() < 0 ? -value : value;
}

}  // namespace

double of_few_bits(double x, int bits) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(std::floor(std::ldexp(fraction, bits)), exponent - bits);
}

mpfr_prec_t working_precision(double nats, double size) {
  return static_cast<mpfr_prec_t>(std::ceil(nats / std::numbers::ln2 + std::log2(1 + size))) + slack_bits;
}

Interval I1_interval(const Exact& alpha, double nats) {
  const Exact a = alpha.magnitude();
  if (residues_are_cheaper(a.approximate(), nats)) return residue_series(Symbol::I1, a, nats);
  return log_coth(a, nats) + transform(Symbol::I1, a, nats);
}

Interval I2_interval(const Exact& alpha, double nats) {
  const Interval half_pi = Interval::pi(working_precision(nats, 1)) / 2;
  return static_cast<long>(alpha.sign()) * half_pi;
}

Interval I3_interval(const Exact& alpha, double nats) { return odd(Symbol::I3, alpha, nats); }
Interval I4_interval(const Exact& eta, double nats) { return odd(Symbol::I4, eta, nats); }
Interval I5_interval(const Exact& eta, double nats) { return odd(Symbol::I5, eta, nats); }
Interval I7_interval(const Exact& eta, double nats) {
  return cheaper_transform(Symbol::I7, eta.magnitude(), nats);
}
Interval I6_eta_interval(const Exact& eta, double nats) {
  return cheaper_transform(Symbol::I6_eta_part, eta.magnitude(), nats);
}

Interval fixed_point_interval(data::SheetLoad load, const Exact& eta, const ThetaShares& shares,
                              double nats) {
  const mpfr_prec_t precision = working_precision(nats, 1000);
  const Interval pi = Interval::pi(precision);
  const Interval t1(Exact(shares.theta1), precision), t2(Exact(shares.theta2), precision);
  if (load == data::SheetLoad::normal)
    return (t2 * I4_interval(eta, nats) - t1 * I5_interval(eta, nats)) / pi;
  return (t1 * I7_interval(eta, nats) - I6_eta_interval(eta, nats)) / pi +
         Interval(eta.magnitude(), precision) / 4;
}

Interval I6_interval(const Exact& alpha, const Exact& eta, double nats) {
  const Exact a = alpha.magnitude();
  const Exact e = eta.magnitude();
  const mpq_class longer = e.value() - a.value();
  const mpfr_prec_t precision = working_precision(nats, std::abs(longer.get_d()));
  const Interval growth = Interval::pi(precision) / 4 * Interval(longer, precision);
  return growth + (I1_interval(a, nats) + cheaper_transform(Symbol::I6_alpha_part, a, nats)) -
         I6_eta_interval(e, nats);
}

}  // namespace nipref::ref
