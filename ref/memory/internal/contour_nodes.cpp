#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nipref/ref/memory/internal/contour_nodes.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t guard_bits = 32;

ComplexInterval scaled(long factor, const ComplexInterval& z) { return {factor * z.real, factor * z.imag}; }
ComplexInterval one_minus(const ComplexInterval& z) { return {1 - z.real, -z.imag}; }

struct PathPoint {
  ComplexInterval z;
  ComplexInterval slope;  ///< dz/dt
};

class Path {
 public:
  Path(Contour contour, mpfr_prec_t precision)
      : contour_(contour),
        half_(0.5, precision),
        angle_(angle(contour), precision),
        cosine_(cos(angle_)),
        sine_(sin(angle_)) {}

  [[nodiscard]] PathPoint at(double t) const {
    const Interval rising = exp(Interval(t, half_.precision())), falling = 1 / rising;
    const Interval large = half_ * (rising + falling), small = half_ * (rising - falling);
    if (contour_ == Contour::down)
      return {{small * cosine_, 3 * half_ - large * sine_}, {large * cosine_, -(small * sine_)}};
    return {{small * cosine_, large * sine_}, {large * cosine_, small * sine_}};
  }

 private:
  static double angle(Contour contour) {
    if (contour == Contour::low) return 0.25;
    return contour == Contour::high ? 0.75 : 0.5;
  }

  Contour contour_;
  Interval half_, angle_, cosine_, sine_;
};

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
  const Interval size = exp(-z.real);
  const ComplexInterval e{size * cos(z.imag), -(size * sin(z.imag))};
  const ComplexInterval square = e * e;
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

/// Sets `result` to the number rounded to its precision; std::logic_error if the interval is wider than 2^-precision.
void set(Complex& result, const ComplexInterval& x) {
  const mpfr_prec_t bits = mpfr_get_prec(mpc_realref(result.get()));
  Float smallest = zero_of_bits(64), width = zero_of_bits(64), other = zero_of_bits(64);
  mpfi_mig(raw(smallest), sqrt(square(x.real) + square(x.imag)).get());
  mpfi_diam_abs(raw(width), x.real.get());
  mpfi_diam_abs(raw(other), x.imag.get());
  mpfr_max(raw(width), raw(width), raw(other), MPFR_RNDU);
  mpfr_mul_2si(raw(width), raw(width), bits + 4, MPFR_RNDU);
  if (mpfr_lessequal_p(raw(width), raw(smallest)) == 0)
    throw std::logic_error("a node of the memory integrals lacks digits");
  mpfi_get_fr(mpc_realref(result.get()), x.real.get());
  mpfi_get_fr(mpc_imagref(result.get()), x.imag.get());
}

ContourNodes make_contour_nodes(const ContourKey& key) {
  const Path path(key.contour, key.bits + guard_bits);
  ContourNodes nodes;
  for (long j = key.block * nodes_in_block; j < (key.block + 1) * nodes_in_block; ++j) {
    const PathPoint point = path.at(static_cast<double>(j) * key.step);
    ContourNode& node = nodes.emplace_back(key.bits);
    set(node.z, point.z);
    set(node.weight, whole_symbol(key.kernel, point.z) * point.slope);
  }
  return nodes;
}

std::size_t size_in_bytes(const ContourNodes& nodes) {
  constexpr std::size_t parts = 4;  // real and imaginary parts of z and of the weight
  const std::size_t digits = mpfr_custom_get_size(mpfr_get_prec(mpc_realref(nodes.front().z.get())));
  return nodes.size() * (sizeof(ContourNode) + parts * digits);
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
