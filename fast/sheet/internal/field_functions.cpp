#include <algorithm>
#include <cmath>
#include <complex>

#include <nipref/fast/sheet/internal/field_functions.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal {
namespace {

constexpr std::array is_odd{true, false, true, false, false, true};

/// The product alpha m in two words.
struct Product {
  double high, low;

  Product(double alpha, const double (&m)[2])
      : high(alpha * m[0]), low(std::fma(alpha, m[0], -high) + alpha * m[1]) {}
};

/// e^{i alpha z}; the low words matter where alpha is large.
std::complex<double> wave(double alpha, const double (&root)[2][2]) {
  const Product angle(alpha, root[0]), decay(alpha, root[1]);
  const double size = std::exp(-decay.high), cosine = std::cos(angle.high), sine = std::sin(angle.high);
  const double trimmed = size - size * decay.low;
  return {trimmed * (cosine - sine * angle.low), trimmed * (sine + cosine * angle.low)};
}

/// How many terms are at least 1e-18 of the first.
int terms_at(double alpha) {
  constexpr double nats = 38;
  return std::min(field_roots, static_cast<int>(nats / (3.141 * alpha)) + 1);
}

}  // namespace

FieldFunctions near_rest(double alpha, double depth, FieldFunction first) {
  const auto begin = static_cast<std::size_t>(first);
  // With W = w^2 = x + i y a polynomial in W is p + i y q: no part loses digits as y -> 0.
  const double x = (alpha - depth) * (alpha + depth), y = 2 * alpha * depth, y_squared = y * y;
  std::array<double, field_functions> p{}, q{};
  for (int k = near_load_terms - 1; k >= 0; --k) {
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
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) of[n] = wave(alpha, field_table.root[n]);
}

AcrossWaves::AcrossWaves(double depth, int count) {
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
    const double a = depth * field_table.root[n][0][0], b = depth * field_table.root[n][1][0];
    const double cosine = std::cos(b), sine = std::sin(b), grows = std::cosh(a), rises = std::sinh(a);
    cosh[n] = {grows * cosine, rises * sine};
    sinh[n] = {rises * cosine, grows * sine};
  }
}

FieldFunctions decaying(const AlongWaves& along, const AcrossWaves& across) {
  FieldFunctions sum{};
  for (int n = along.count - 1; n >= 0; --n) {
    const auto root = static_cast<std::size_t>(n);
    // The pole at z and its mirror image give Re and Im of Re(a e^{i w z}) continued to complex w.
    const std::complex<double> even = along.of[root] * across.cosh[root],
                               odd = along.of[root] * across.sinh[root];
    for (std::size_t f = 0; f < sum.of.size(); ++f) {
      const auto& a = field_table.amplitude[n][f];
      sum.of[f].re += a[0] * even.real() - a[1] * even.imag();
      sum.of[f].im -= a[0] * odd.imag() + a[1] * odd.real();
    }
  }
  return sum;
}

}  // namespace nipref::fast::internal
