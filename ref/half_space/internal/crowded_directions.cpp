#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/ref/half_space/internal/crowded_directions.hpp>

namespace nipref::ref {
namespace {

/// K for the complementary modulus.
Float quarter_period(const Float& complement) {
  Float mean;
  mpfr_agm(raw(mean), raw(Float(1)), raw(complement), MPFR_RNDN);
  return pi() / (2 * mean);
}

/// k' is kept below 1, for which K(k') is infinite.
Float apart(const Float& complement) { return std::min(complement, Float(0.75)); }

double reciprocal(const SurfaceAnswer& surface, double degrees) {
  const LineAnswer line = surface(Exact(degrees), 16);
  return 1 / mpfr_get_d(raw(line.compliance), MPFR_RNDN);
}

}  // namespace

CrowdedDirections::CrowdedDirections(const Exact& centre, const Float& smallest, const Float& largest)
    : centre_(centre),
      smallest_(smallest),
      complement_(apart(smallest / largest)),
      quarter_(quarter_period(complement_)),
      conjugate_(quarter_period(sqrt((1 - complement_) * (1 + complement_)))) {}

// The Fourier series of sn on the imaginary axis, whose terms are all positive.
Float CrowdedDirections::sc(const Float& u) const {
  const Float nome = exp(-pi() * quarter_ / conjugate_), growth = exp(pi() * u / (2 * conjugate_));
  const Float square = growth * growth;
  Float sum = 0, up = growth, down = 1 / growth, power = sqrt(nome);  // of 2n + 1, -(2n + 1), n + 1/2
  for (;;) {
    const Float term = power / (1 - power * power) * (up - down) / 2;
    sum += term;
    if (!(term > std::numeric_limits<Float>::epsilon() * sum)) break;
    up *= square;
    down /= square;
    power *= nome;
  }
  return 2 * pi() / (complement_ * conjugate_) * sum;
}

CrowdedDirections::Direction CrowdedDirections::at(long i, long count) const {
  const Float share = Float(2 * i) / count - 1;  // u/K
  const Float magnitude = abs(share), near = std::min(magnitude, Float(1 - magnitude));
  // T or its reciprocal, from sc(u) or its reciprocal, whichever is small.
  const bool is_near_centre = magnitude <= Float(0.5);
  const Float x = is_near_centre ? sc(near * quarter_) : Float(complement_ * sc(near * quarter_));
  const Float k2 = complement_ * complement_, x2 = x * x, s2 = smallest_ * smallest_;
  const Float slope = is_near_centre ? Float(sqrt((1 + x2) * (1 + k2 * x2)) / (1 + s2 * x2))
                                     : Float(sqrt((1 + x2) * (k2 + x2)) / (s2 + x2));
  const Float tangent = is_near_centre ? Float(smallest_ * x) : Float(x / smallest_);
  const Float from_end =
      atan(tangent) * 180 / pi();  // degrees from the centre, or from the direction across it
  Exact from_centre = is_near_centre ? to_exact(from_end) : Exact(mpq_class(90 - to_exact(from_end).value()));
  if (share < 0) from_centre = Exact(mpq_class(-from_centre.value()));
  const Exact degrees(mpq_class(centre_.value() + from_centre.value()));
  const Float angle = to_float(degrees) * pi() / 180;
  const Float across = to_float(mpq_class(90 - degrees.value())) * pi() / 180;
  return {degrees, sin(across), sin(angle), smallest_ * slope * 2 * quarter_};
}

PeakOfCompliance peak_of_compliance(const SurfaceAnswer& surface) {
  constexpr int scan = 5;
  double best = 0, least = reciprocal(surface, best), width = 1;
  for (int degrees = scan - 90; degrees <= 90; degrees += scan) {
    const double value = reciprocal(surface, degrees);
    if (value < least) {
      best = degrees;
      least = value;
    }
  }
  for (double step = scan; step > 1e-3; step /= 8) {
    const double left = reciprocal(surface, best - step), right = reciprocal(surface, best + step);
    const double curvature = left - 2 * least + right;
    if (!(curvature > 0)) break;
    const double move = step * std::clamp((left - right) / (2 * curvature), -1., 1.);
    const double value = move == 0 ? least : reciprocal(surface, best + move);
    if (value < least) {
      best += move;
      least = value;
    }
    const double half = step * std::sqrt(2 * least / curvature) * std::numbers::pi / 180;
    width = std::min(1., half);
  }
  return {best, width};
}

}  // namespace nipref::ref
