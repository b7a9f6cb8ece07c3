#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {
namespace {

/// The number of waves that the tolerance needs. At a distance x the n-th wave is about e^(-pi (n - 1) x) of the first.
int wave_count(double distance, double tolerance) {
  return std::clamp(static_cast<int>(2 - std::log(tolerance) / (std::numbers::pi * distance)), 1, most_waves);
}

/// The sum over the waves of C wave transform(i z). For a real rate it is the real part. For a complex rate the
/// transform at the conjugate root is not the conjugate, and both transforms enter the sum.
template <typename Rate, typename Transform>
Rate sum_over(Kernel kernel, const Waves& at, Transform transform) {
  Rate sum = 0;
  const auto& amplitude = component_tables[static_cast<int>(kernel)].amplitude;
  for (int n = at.count - 1; n >= 0; --n) {
    const Complex term = Complex{amplitude[n][0], amplitude[n][1]} * at.value(n);
    const Complex exponent{-root_table.decay_high[n], root_table.frequency_high[n]};
    if constexpr (std::is_same_v<Rate, double>) {
      sum += (term * transform(n, exponent)).real();
    } else {
      sum += 0.5 * (term * transform(n, exponent) + std::conj(term) * transform(n, std::conj(exponent)));
    }
  }
  return sum;
}

}  // namespace

Waves waves(Two distance, double tolerance) {
  if (distance.high < 0) distance = -distance;
  // Beyond this distance even the first wave is below the smallest double.
  if (distance.high > underflown) distance = {underflown, 0};
  Waves at;
  at.count = wave_count(distance.high, tolerance);
  sheet_code().waves(distance.high, distance.low, at.real.data(), at.imaginary.data(),
                     static_cast<std::size_t>(at.count));
  return at;
}

double faded_kernel(Kernel kernel, const Waves& at) {
  return sum_over<double>(kernel, at, [](int, Complex) { return 1.0; });
}

template <typename Rate>
Rate memory_of_waves(Kernel kernel, const Waves& at, Rate rate, Side side, int order) {
  const auto sum_of = [&](auto integral) {
    if (order == 0)
      return sum_over<Rate>(kernel, at, [&](int, Complex exponent) { return integral(exponent); });
    return sum_over<Rate>(kernel, at, [&](int, Complex exponent) { return exponent * integral(exponent); });
  };
  if (side == Side::ahead) return sum_of([&](Complex exponent) { return inverse(rate - exponent); });
  return sum_of([&](Complex exponent) { return inverse(rate + exponent); });
}

template <typename Rate>
Rate memory_of_piece_ahead(Kernel kernel, const Waves& from, Rate rate, double length) {
  return sum_over<Rate>(kernel, from,
                        [&](int, Complex exponent) { return length * phi1((rate - exponent) * length); });
}

template <typename Rate>
Rate memory_of_piece_behind(Kernel kernel, const Waves& from, const Waves& to, Rate rate, double length,
                            Rate faded) {
  const auto short_piece = [&](Complex exponent) { return std::norm((rate + exponent) * length) < 1; };
  // A wave's integral is the difference of its antiderivative at both ends. Over a short piece the two would cancel;
  // instead the wave at the far end is multiplied by length phi1.
  const Rate far = sum_over<Rate>(kernel, from, [&](int, Complex exponent) {
    const Complex slope = rate + exponent;
    return short_piece(exponent) ? length * phi1(slope * length) : inverse(slope);
  });
  const Rate near = sum_over<Rate>(kernel, to, [&](int n, Complex exponent) {
    const bool with_far = n < from.count && short_piece(exponent);
    return with_far ? Complex(0) : inverse(rate + exponent);
  });
  return far - faded * near;
}

template double memory_of_waves(Kernel, const Waves&, double, Side, int);
template Complex memory_of_waves(Kernel, const Waves&, Complex, Side, int);
template double memory_of_piece_ahead(Kernel, const Waves&, double, double);
template Complex memory_of_piece_ahead(Kernel, const Waves&, Complex, double);
template double memory_of_piece_behind(Kernel, const Waves&, const Waves&, double, double, double);
template Complex memory_of_piece_behind(Kernel, const Waves&, const Waves&, Complex, double, Complex);

}  // namespace nipref::fast::internal
