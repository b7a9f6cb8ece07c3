#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/memory/internal/fading_near_load.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast::internal {
namespace {

double one_word(Two rate) { return rate.high; }
double one_word(const Fade& fade) { return fade.rate.high; }
Complex one_word(Complex rate) { return rate; }
Complex one_word(const OscillatingFade& fade) { return fade.rate; }

double faded(const Fade& fade, Two way) { return decay(fade.rate * way); }
Complex faded(Complex rate, Two way) { return faded_exp(rate * way.high); }
Complex faded(const OscillatingFade& fade, Two way) { return faded(fade.rate, way); }

/// The waves at the distance `nearest`, beyond which kernels are summed as waves.
const Waves& nearest_waves(Accuracy accuracy) {
  static const Waves full = waves({nearest, 0}, 0x1p-56), coarse = waves({nearest, 0}, 1e-10);
  return accuracy.rtol() >= 1e-8 ? coarse : full;
}

/// The limit of a kernel far ahead of the load; far behind it, the odd kernels have the opposite limit.
double limit(Kernel kernel) { return kernel == Kernel::I1 ? 0 : std::numbers::pi / 4; }

/// The integral of e^(-rate (w - start)) I(w) over `length` behind or ahead of the load; `kept` is e^(-rate length).
template <typename Rate>
Rate piece_behind(Kernel kernel, const Waves& from, const Waves& to, Rate rate, double length, Rate kept) {
  const Rate piece = memory_of_piece_behind(kernel, from, to, rate, length, kept);
  return kernel == Kernel::I1 ? piece : -(piece + limit(kernel) * length * phi1(rate * length));
}
template <typename Rate>
Rate piece_ahead(Kernel kernel, const Waves& from, Rate rate, double length) {
  return memory_of_piece_ahead(kernel, from, rate, length) + limit(kernel) * length * phi1(rate * length);
}
/// The integral of e^(-rate (w - start)) times the kernel's limit over all w > start. At rate 0, where it diverges, the
/// integral over all w > 0 is subtracted.
template <typename Rate>
Rate limit_ahead(Kernel kernel, double start, Rate rate) {
  return rate == 0.0 ? Rate(-limit(kernel) * start) : limit(kernel) / rate;
}
/// The integral of e^(-rate (w - start)) I(w) from a start ahead of the load to infinity, at rate 0 like limit_ahead.
template <typename Rate>
Rate all_ahead(Kernel kernel, const Waves& from, double start, Rate rate) {
  const Rate far = memory_of_waves(kernel, from, rate, Side::ahead);
  return kernel == Kernel::I1 ? far : far + limit_ahead(kernel, start, rate);
}

double under_load(Kernel kernel, double from, double to, double length, const Fade& fade, Accuracy accuracy) {
  return memory_under_load(kernel, from, to, length, fade.rate.high,
                           fade.core[static_cast<std::size_t>(kernel)], accuracy);
}
Complex under_load(Kernel kernel, double from, double to, double length, Complex rate, Accuracy accuracy) {
  return memory_under_load(kernel, from, to, length, rate, accuracy);
}
Complex under_load(Kernel kernel, double from, double, double, const OscillatingFade& fade, Accuracy) {
  return fade.core[static_cast<std::size_t>(kernel)]->from(from);
}

template <typename Kept>
auto from_nearest(Kernel kernel, const Kept& fade, Accuracy) {
  return fade.beyond[static_cast<std::size_t>(kernel)];
}
Complex from_nearest(Kernel kernel, Complex rate, Accuracy accuracy) {
  return all_ahead(kernel, nearest_waves(accuracy), nearest, rate);
}

/// The integral of e^(-rate (w - start)) I(w) on [start, end], or on [start, infinity) if `end` is null, which is at rate
/// 0 like limit_ahead. Parts farther from the load than `nearest` are sums of residues; memory_under_load is the part
/// near the load. Each part is multiplied by e^(-rate d), where d is its distance from `start`.
template <typename Rate>
auto by_pieces(Kernel kernel, const SurfacePoint& start, const SurfacePoint* end, Two length,
               const Rate& rate, Accuracy accuracy) {
  using Value = std::remove_cvref_t<decltype(one_word(rate))>;
  const Value plain = one_word(rate);
  const double w = start.at.high;
  Value sum = 0;
  if (w < -nearest) {
    const bool ends = end && end->at.high <= -nearest;
    const Two behind = ends ? length : -start.at + Two{-nearest, 0};
    sum += piece_behind(kernel, start.waves, ends ? end->waves : nearest_waves(accuracy), plain, behind.high,
                        faded(rate, behind));
    if (ends) return sum;
  }
  if (w < nearest) {
    const Two behind = w < -nearest ? -start.at + Two{-nearest, 0} : Two{0, 0};
    const double from = std::max(w, -nearest);
    const bool ends = end && end->at.high <= nearest;
    const double to = ends ? end->at.high : nearest;
    const double part = ends && from == w ? length.high : to - from;
    sum += faded(rate, behind) * under_load(kernel, from, to, part, rate, accuracy);
    if (ends) return sum;
  }
  if (w >= nearest) {
    return end ? piece_ahead(kernel, start.waves, plain, length.high)
               : all_ahead(kernel, start.waves, w, plain);
  }
  const Value piece = end ? piece_ahead(kernel, nearest_waves(accuracy), plain, end->at.high - nearest)
                          : from_nearest(kernel, rate, accuracy);
  return sum + faded(rate, -start.at + Two{nearest, 0}) * piece;
}

/// The derivative of I1 or I3 is a sum of waves for |w| >= `nearest`. Nearer, it is smooth, except for the term -1/w of I1.
template <typename Rate>
auto slope_memory(Kernel kernel, const SurfacePoint& start, const Rate& rate, Accuracy accuracy) {
  const auto plain = one_word(rate);
  const double w = start.at.high;
  if (w >= nearest) return memory_of_waves(kernel, start.waves, plain, Side::ahead, 1);
  const double from = std::max(w, -nearest);
  const auto kept = faded(rate, {nearest - from, 0});
  auto sum = rate.slope[static_cast<std::size_t>(kernel)]->from(from) +
             kept * memory_of_waves(kernel, nearest_waves(accuracy), plain, Side::ahead, 1);
  if (kernel == Kernel::I1) sum += kept * scaled_E1(plain * nearest) - scaled_E1(plain * w);
  if (w >= -nearest) return sum;
  const auto reached = memory_of_waves(kernel, nearest_waves(accuracy), plain, Side::behind, 1);
  return memory_of_waves(kernel, start.waves, plain, Side::behind, 1) +
         faded(rate, -start.at + Two{-nearest, 0}) * (sum - reached);
}

/// The integral of e^(-L w) I1(w) over all w, continued analytically to values of L for which it diverges. It is pi
/// times the kernel's transform 2 sinh^2 x/(x (sinh 2x + 2x)) at x = i L. (notes on thesis 6.23)
double whole_line(double L) {
  const double sine_ratio = L == 0 ? 1 : std::sin(L) / L;
  return std::numbers::pi * sine_ratio * sine_ratio / (1 + sine_ratio * std::cos(L));
}

bool has_slope(Kernel kernel, double) { return kernel == Kernel::I1 || kernel == Kernel::I3; }
bool has_slope(Kernel kernel, Complex rate) {
  return has_slope(kernel, rate.real()) && std::abs(rate) >= polynomial_from;
}

OscillatingCore core_of(Kernel kernel, Complex rate, Accuracy accuracy) { return {kernel, rate, accuracy}; }

template <typename Made, typename Rate>
Made made_for(Rate rate, std::initializer_list<Kernel> kernels, Accuracy accuracy) {
  Made made{rate};
  const auto plain = one_word(rate);
  for (const Kernel kernel : kernels) {
    const auto number = static_cast<std::size_t>(kernel);
    if (has_slope(kernel, plain)) made.slope[number].emplace(slope_of_smooth_part(kernel), plain);
    made.core[number] = core_of(kernel, plain, accuracy);
    made.beyond[number] = all_ahead(kernel, nearest_waves(accuracy), nearest, plain);
  }
  return made;
}

}  // namespace

SurfacePoint surface_point(Two at, Accuracy accuracy) {
  // 2^-56 at full accuracy. Waves fall by e^-pi each at the nearest point, so that all that are left out add 2^-55.9.
  const double tolerance = accuracy.rtol() / 32;
  return {at, std::fabs(at.high) < nearest ? Waves{} : waves(at, tolerance)};
}

double kernel_at(Kernel kernel, const SurfacePoint& at, Accuracy accuracy) {
  const double w = at.at.high;
  if (std::fabs(w) >= nearest) {
    const double faded = faded_kernel(kernel, at.waves);
    return kernel == Kernel::I1 ? faded : (w > 0 ? 1 : -1) * (limit(kernel) + faded);
  }
  if (kernel == Kernel::I1) return I1(w, accuracy);
  if (kernel == Kernel::I3) return I3(w, accuracy);
  return kernel == Kernel::I4 ? I4(w, accuracy) : I5(w, accuracy);
}

Fade fade(Two rate, std::initializer_list<Kernel> kernels, Accuracy accuracy) {
  return made_for<Fade>(rate, kernels, accuracy);
}

OscillatingFade fade(Complex rate, std::initializer_list<Kernel> kernels, Accuracy accuracy) {
  return made_for<OscillatingFade>(rate, kernels, accuracy);
}

double steady_memory(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy) {
  if (kernel == Kernel::I1 && start.at.high <= -nearest) {
    const double rate = fade.rate.high;
    return whole_line(rate) * faded(fade, -start.at) +
           memory_of_waves(kernel, start.waves, rate, Side::behind);
  }
  // At rate 0 the whole integral of the limit is left out.
  const double rest_of_limit = fade.rate.high == 0 ? -limit_ahead(kernel, start.at.high, 0.0) : 0;
  return by_pieces(kernel, start, nullptr, {}, fade, accuracy) + rest_of_limit;
}

Complex steady_memory(Kernel kernel, const SurfacePoint& start, Complex rate, Accuracy accuracy) {
  return by_pieces(kernel, start, nullptr, {}, rate, accuracy);
}

Complex steady_memory(Kernel kernel, const SurfacePoint& start, const OscillatingFade& fade,
                      Accuracy accuracy) {
  return by_pieces(kernel, start, nullptr, {}, fade, accuracy);
}

/// Adds the integral up to the distance `nearest` and that beyond, where the kernel minus its limit is a sum of waves.
template <typename Kept>
typename Kept::Number steady_memory_beside_limit(Kernel kernel, const SurfacePoint& start, const Kept& fade,
                                                 Accuracy accuracy) {
  const auto plain = one_word(fade);
  if (start.at.high >= nearest) return memory_of_waves(kernel, start.waves, plain, Side::ahead);
  const SurfacePoint end{{nearest, 0}, nearest_waves(accuracy)};
  const Two length = -start.at + Two{nearest, 0};
  return by_pieces(kernel, start, &end, length, fade, accuracy) -
         limit(kernel) * length.high * phi1(plain * length.high) +
         faded(fade, length) * memory_of_waves(kernel, end.waves, plain, Side::ahead);
}
template double steady_memory_beside_limit(Kernel, const SurfacePoint&, const Fade&, Accuracy);
template Complex steady_memory_beside_limit(Kernel, const SurfacePoint&, const OscillatingFade&, Accuracy);

double steady_memory_of_slope(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy) {
  // At rate 0 the slope's integral is the limit minus the kernel. Far ahead of the load the two cancel.
  if (fade.rate.high == 0 && start.at.high < nearest)
    return limit(kernel) - kernel_at(kernel, start, accuracy);
  return slope_memory(kernel, start, fade, accuracy);
}

Complex steady_memory_of_slope(Kernel kernel, const SurfacePoint& start, const OscillatingFade& fade,
                               Accuracy accuracy) {
  if (fade.slope[static_cast<std::size_t>(kernel)]) return slope_memory(kernel, start, fade, accuracy);
  return fade.rate * steady_memory_beside_limit(kernel, start, fade, accuracy) +
         (limit(kernel) - kernel_at(kernel, start, accuracy));
}

double memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, const Fade& fade,
              Accuracy accuracy) {
  if (length.high < 1 || end.at.high < nearest) return by_pieces(kernel, start, &end, length, fade, accuracy);
  constexpr double nats_forgotten = 42;  // e^-42 < 2^-60
  const bool forgotten = fade.rate.high * std::min(length.high, end.at.high) > nats_forgotten;
  if (forgotten) return steady_memory(kernel, start, fade, accuracy);
  // For I1 the result is the integral to infinity minus that beyond `end`. With a length of at least a half-thickness and
  // `end` far ahead of the load, the second integral is small, since I1, unlike the other kernels, decays.
  if (kernel != Kernel::I1) return by_pieces(kernel, start, &end, length, fade, accuracy);
  return steady_memory(kernel, start, fade, accuracy) -
         faded(fade, length) * steady_memory(kernel, end, fade, accuracy);
}

Complex memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, Complex rate,
               Accuracy accuracy) {
  return by_pieces(kernel, start, &end, length, rate, accuracy);
}

}  // namespace nipref::fast::internal
