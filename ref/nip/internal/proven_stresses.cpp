#include <utility>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/nip/internal/proven_stresses.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/field.hpp>

namespace nipref::ref {
namespace {

StressIntervals operator+(const StressIntervals& x, const StressIntervals& y) {
  return {x.across + y.across, x.along + y.along, x.shear + y.shear};
}
StressIntervals operator*(const Interval& factor, const StressIntervals& x) {
  return {factor * x.across, factor * x.along, factor * x.shear};
}
StressIntervals widened(const StressIntervals& x, const Interval& error) {
  return {x.across.widened(error), x.along.widened(error), x.shear.widened(error)};
}

Interval zero() { return Interval(working_bits()); }

/// The square root, in the first quadrant, of a number in the upper half-plane.
ComplexInterval root_of(const ComplexInterval& x) {
  const Interval size = abs(x);
  if (mpfr_sgn(x.re.lower()) >= 0) {
    const Interval real = sqrt((size + x.re) / 2);
    return {real, x.im / (2 * real)};
  }
  const Interval imag = sqrt((size - x.re) / 2);
  return {x.im / (2 * imag), imag};
}

/// The stresses over 2A of the half-plane of a face, 1 or -1, under sum c_m sin(m theta) at z = 1 - before_end + i y.
StressIntervals of_half_plane(const std::vector<Interval>& c, const Interval& before_end, const Interval& y,
                              int face) {
  const ComplexInterval root = root_of({-before_end, y}) * root_of({2 - before_end, y});
  const Interval real = 1 - before_end + root.re, imag = y + root.im;  // of zeta
  const Interval size = sqrt(square(real) + square(imag));
  const Interval growth = log(size), theta = 2 * atan(imag / (size + real));
  ComplexInterval sum{zero(), zero()}, slope = sum;
  for (long m = 1; m < static_cast<long>(c.size()); ++m) {
    const Interval scale = c[static_cast<std::size_t>(m)] * exp(-(m * growth));
    const ComplexInterval term{scale * cos(m * theta), -(scale * sin(m * theta))};
    sum = sum + term;
    slope = slope - Interval(m, working_bits()) * term;
  }
  // On the face itself y = 0, and the term of the slope is 0.
  slope = mpfr_zero_p(y.upper()) != 0 ? ComplexInterval{zero(), zero()} : y * (slope * inverse(root));
  return {sum.im - slope.re, sum.im + slope.re, face * slope.im};
}

/// The stresses of the half-plane of a face under a unit line load, at the distance alpha from the load.
StressIntervals of_half_plane(const Exact& alpha, const Exact& distance, int face) {
  const Interval u(alpha, working_bits()), d(distance, working_bits()), squares = square(u) + square(d);
  const Interval part = -(2 * d / (Interval::pi(working_bits()) * square(squares)));
  return {part * square(d), part * square(u), -face * (part * d * u)};
}

/// The field of a unit line load less those of both half-planes.
StressIntervals rest_of(const Exact& alpha, const Exact& depth, int digits) {
  const auto of = [&](const auto& field) {
    return interval_of(field(alpha, depth, data::SheetLoad::normal, digits));
  };
  StressIntervals rest{of(sheet_across), of(sheet_along), of(sheet_shear)};
  for (const int face : {1, -1})
    rest = rest + Interval(-1L, working_bits()) *
                      of_half_plane(alpha, Exact(mpq_class(1 - face * depth.value())), face);
  return rest;
}

bool is_bounded(const StressIntervals& x) {
  return mpfi_bounded_p(x.across.get()) != 0 && mpfi_bounded_p(x.along.get()) != 0 &&
         mpfi_bounded_p(x.shear.get()) != 0;
}

}  // namespace

Interval sheet_rest(const Interval& height) {
  const Interval u = 2 - height;
  return 2 * (3 / u + 10 / square(u) + 16 / (u * square(u))) / Interval::pi(height.precision());
}

std::optional<StressIntervals> proven_stresses(const ProvenExpansion& pressure, const SurfacePoint& place,
                                               const Exact& depth, int digits) {
  const Interval& A = pressure.half_length;
  std::vector<Interval> c = pressure.coefficients;
  if (place.is_trailing)
    for (std::size_t m = 2; m < c.size(); m += 2) c[m] = -c[m];
  const Interval two_A = 2 * A, pi = Interval::pi(working_bits());
  StressIntervals sum{zero(), zero(), zero()};
  for (const int face : {1, -1}) {
    const Interval distance(Exact(mpq_class(1 - face * depth.value())), working_bits());
    sum = sum + two_A * of_half_plane(c, place.before_end, distance / A, face);
  }
  // The rest, by Gauss and Chebyshev's rule at rounded nodes.
  const auto N = static_cast<long>(c.size());
  const Cosines cosines(N, working_bits());
  const Interval from_middle = A * (1 - place.before_end);
  for (long i = 0; i < N; ++i) {
    Interval traction = zero();
    for (long m = 1; m < N; ++m)
      traction = traction + c[static_cast<std::size_t>(m)] * cosines(m * (2 * i + 1) - N);
    const Interval exactly = from_middle - A * cosines(2 * i + 1);
    Float apart = middle_of(exactly);
    if (apart == 0)
      apart = ldexp(Float(1), -working_bits());  // the field on a face is refused at the load itself
    const StressIntervals rest =
        widened(rest_of(to_exact(apart), depth, digits), sheet_rest_slope * distance_from(apart, exactly));
    sum = sum + two_A * A * pi / N * traction * cosines(2 * i + 1 - N) * rest;
  }
  // The truncation error of the rule, and the error of the coefficients.
  const EntryBounds decay = entry_bounds(A, static_cast<int>(N / 2));
  const Interval height = interval_of(upper_end(A)) * sinh(decay.rate), left = decay.power(N);
  const Interval missed = 4 * pi * square(A) * sheet_rest(height) * sum_of_magnitudes(c) * left / (1 - left) +
                          (8 * A + pi * square(A) * sheet_rest(zero())) * pressure.radius;
  sum = widened(sum, magnitude_of(missed));
  if (place.is_trailing) sum.shear = -sum.shear;
  return is_bounded(sum) ? std::optional(sum) : std::nullopt;
}

}  // namespace nipref::ref
