#include <algorithm>
#include <cmath>
#include <complex>

#include <nipref/fast/sheet/internal/dispatch.hpp>
#include <nipref/fast/sheet/internal/field_functions.hpp>

namespace nipref::fast::internal {
namespace {

constexpr std::array is_odd{true, false, true, false, false, true};

/// The number of terms that are at least 1e-18 of the first.
int terms_at(double alpha) {
  constexpr double nats = 38;
  return std::min(field_roots, static_cast<int>(nats / (3.141 * alpha)) + 1);
}

/// The number of terms of near_rest at |w|^2 = square. The other terms are below 1e-21 of the first term. Their
/// derivatives, which make up the imaginary parts, are below 1e-21 of the first derivative that is not 0.
int terms_near(double square) {
  constexpr double nats = 48.4;
  return std::min(near_load_terms, 2 + static_cast<int>(nats / std::log(9 / square)));
}

}  // namespace

FieldFunctions near_rest(double alpha, double depth, FieldFunction first) {
  const auto begin = static_cast<std::size_t>(first);
  // With W = w^2 = x + i y, a polynomial in W is p + i y q, and neither part loses digits as y -> 0.
  const double x = (alpha - depth) * (alpha + depth), y = 2 * alpha * depth, y_squared = y * y;
  std::array<double, field_functions> p{}, q{};
  for (int k = terms_near(alpha * alpha + depth * depth) - 1; k >= 0; --k) {
    for (std::size_t f = begin; f < p.size(); ++f) {
      const double before = p[f];
      p[f] = x * before - y_squared * q[f] + field_table.rest[f][k];
      q[f] = x * q[f] + before;
    }
  }
  FieldFunctions result{};
  for (std::size_t f = begin; f < p.size(); ++f) {
    result.of[f] = is_odd[f] ? ComplexValue{alpha * (p[f] - 2 * depth * depth * q[f]),
                                            depth * (p[f] + 2 * alpha * alpha * q[f])}
                             : ComplexValue{p[f], y * q[f]};
  }
  return result;
}

AlongWaves::AlongWaves(double alpha)
    : count(alpha > underflown      ? 0
            : alpha < near_load_end ? field_roots
                                    : terms_at(alpha)) {
  const auto size = static_cast<std::size_t>(count);
  std::array<double, field_roots> real, imaginary;
  const bool is_far =
      alpha > 300;  // where one wave alone contributes, and is a normal number at half the distance
  sheet_code().waves(is_far ? alpha / 2 : alpha, 0, real.data(), imaginary.data(), size);
  for (std::size_t n = 0; n < size; ++n) of[n] = {real[n], imaginary[n]};
  if (is_far && count > 0) {
    scale = std::abs(of[0]);
    of[0] *= of[0] / scale;
  }
}

AcrossWaves::AcrossWaves(double depth, int count) {
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
    const double a = depth * root_table.frequency_high[n], b = depth * root_table.decay_high[n];
    const double cosine = std::cos(b), sine = std::sin(b), grows = std::cosh(a), rises = std::sinh(a);
    cosh[n] = {grows * cosine, rises * sine};
    sinh[n] = {rises * cosine, grows * sine};
  }
}

FieldFunctions decaying(const AlongWaves& along, const AcrossWaves& across, FieldFunction first) {
  FieldFunctions sum{};
  for (int n = along.count - 1; n >= 0; --n) {
    const auto root = static_cast<std::size_t>(n);
    // The poles at z and at its mirror image together give Re(a e^{i w z}), continued to complex w.
    const std::complex<double> even = along.of[root] * across.cosh[root],
                               odd = along.of[root] * across.sinh[root];
    for (auto f = static_cast<std::size_t>(first); f < sum.of.size(); ++f) {
      const auto& a = field_table.amplitude[n][f];
      sum.of[f].re += a[0] * even.real() - a[1] * even.imag();
      sum.of[f].im -= a[0] * odd.imag() + a[1] * odd.real();
    }
  }
  for (ComplexValue& value : sum.of) value = {value.re * along.scale, value.im * along.scale};
  return sum;
}

}  // namespace nipref::fast::internal
