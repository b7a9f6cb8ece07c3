#include <climits>
#include <cmath>

#include <nipref/ref/memory/internal/contour_nodes.hpp>
#include <nipref/ref/number/internal/cache.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t guard_bits = 32;

ComplexInterval scaled(long factor, const ComplexInterval& z) { return {factor * z.real, factor * z.imag}; }
ComplexInterval one_minus(const ComplexInterval& z) { return {1 - z.real, -z.imag}; }

/// The complex interval around 1 whose real and imaginary parts have the half-width 2^-k.
ComplexInterval nearly_one(mpfr_prec_t k) {
  Interval radius(1L, k);
  mpfi_div_2ui(radius.get(), radius.get(), static_cast<unsigned long>(k));
  return {Interval(1L, k).widened(radius), Interval(0L, k).widened(radius)};
}

/// G(z) with E = e^{-z} and D = 1 - E^4 + 4 z E^2 = 2 E^2 S:
///   I1: (1 - E^2)^2/(z D), I3: 4 E^2/D, I4: 2 E (1 - E^2)/(z D), I5: 2 E (1 + E^2)/D
ComplexInterval whole_symbol(Symbol kernel, const ComplexInterval& z) {
  const mpfr_prec_t precision = z.real.precision();
  // (1 - E^2)^2/D differs from 1 by less than 5 (|z| + 1) e^{-2x} < e^{-x}, as |z| < 2x and x > 32.
  if (kernel == Symbol::normal && mpfr_cmp_si(z.real.lower(), precision) > 0)
    return nearly_one(precision) * inverse(z);
  const ComplexInterval e = exp(-z), square = e * e;
  const ComplexInterval over_d = inverse(one_minus(square * square) + scaled(4, z * square));
  switch (kernel) {
    case Symbol::I3:
      return scaled(4, square) * over_d;
    case Symbol::I4:
      return scaled(2, e) * one_minus(square) * over_d * inverse(z);
    case Symbol::I5:
      return scaled(2, e) * one_minus(scaled(-1, square)) * over_d;
    default:
      return one_minus(square) * one_minus(square) * over_d * inverse(z);
  }
}

ContourNodes make_contour_nodes(const ContourKey& key) {
  const mpfr_prec_t more = key.bits + guard_bits;
  const Interval angle(key.angle, more), cosine = cos(angle), sine = sin(angle);
  ContourNodes nodes;
  for (long j = key.block * nodes_in_block; j < (key.block + 1) * nodes_in_block; ++j) {
    const Interval t(static_cast<double>(j) * key.step, more), large = cosh(t), small = sinh(t);
    const ComplexInterval z{small * cosine, large * sine}, slope{large * cosine, small * sine};
    nodes.push_back({rounded(z, key.bits), rounded(whole_symbol(key.kernel, z) * slope, key.bits)});
  }
  return nodes;
}

std::size_t size_in_bytes(const ContourNodes& nodes) {
  constexpr std::size_t numbers = 8;  // both ends of the parts of z and of the weight
  const auto bits = static_cast<std::size_t>(nodes.front().z.real.precision());
  return nodes.size() * (sizeof(ContourNode) + numbers * bits / CHAR_BIT);
}

}  // namespace

double contour_step(double limit) {
  int exponent = 0;
  const double fraction = std::frexp(limit, &exponent);
  return std::ldexp(std::floor(fraction * 16), exponent - 4);
}

std::shared_ptr<const ContourNodes> contour_nodes(const ContourKey& key) {
  static Cache<ContourKey, ContourNodes> kept(make_contour_nodes, size_in_bytes);
  return kept.at(key);
}

}  // namespace nipref::ref
