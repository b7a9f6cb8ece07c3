#include "fast/hereditary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "fast/hereditary_core.hpp"
#include "fast/sheet_kernels.hpp"

namespace nipref::fast::internal {
namespace {

constexpr double pi = std::numbers::pi;

double one_word(Two rate) { return rate.high; }
Complex one_word(Complex rate) { return rate; }

double faded(Two rate, Two way) { return decay(rate * way); }
Complex faded(Complex rate, Two way) { return std::exp(-rate * way.high); }

/// The waves at kNearest, from where the far pieces start.
const Waves& nearest_waves(Accuracy accuracy) {
  static const Waves full = waves({kNearest, 0}, 0x1p-56), coarse = waves({kNearest, 0}, 1e-10);
  return accuracy.rtol() >= 1e-8 ? coarse : full;
}

/// D on [start, end], or to infinity without an end: behind the load by residues, within kNearest of it by
/// memory_under_load, ahead by residues. What is passed first has faded most.
template <typename Rate>
auto by_pieces(Kernel kernel, const Spot& start, const Spot* end, Two length, Rate rate, Accuracy accuracy) {
  using Value = std::remove_cvref_t<decltype(one_word(rate))>;
  const Value plain = one_word(rate);
  const double w = start.at.high;
  Value sum = 0;
  if (w < -kNearest) {
    const bool all = end && end->at.high <= -kNearest;
    const Two way = all ? length : -start.at + Two{-kNearest, 0};
    const Value kept = faded(rate, way);
    const Value piece = memory_of_piece_behind(
        kernel, start.waves, all ? end->waves : nearest_waves(accuracy), plain, way.high, kept);
    sum += kernel == Kernel::I1 ? piece : -piece;
    if (all) return sum;
  }
  if (w < kNearest) {
    const Two way = w < -kNearest ? -start.at + Two{-kNearest, 0} : Two{0, 0};
    const double from = std::max(w, -kNearest);
    const bool ends = end && end->at.high <= kNearest;
    const double to = ends ? end->at.high : kNearest;
    const double part = ends && from == w ? length.high : to - from;
    sum += faded(rate, way) * memory_under_load(kernel, from, to, part, plain, accuracy);
    if (ends) return sum;
  }
  const Two way = w < kNearest ? -start.at + Two{kNearest, 0} : Two{0, 0};
  const Waves& from = w < kNearest ? nearest_waves(accuracy) : start.waves;
  const double part = w < kNearest && end ? end->at.high - kNearest : length.high;
  const Value piece =
      end ? memory_of_piece_ahead(kernel, from, plain, part) : memory_from_far(kernel, from, plain);
  return sum + faded(rate, way) * piece;
}

/// int over the whole line of e^(-L w) I1(w) dw, continued to where the integral no longer exists: pi times
/// the kernel's transform 2 sinh^2 x/(x (sinh 2x + 2x)) at x = i L. (notes on thesis 6.23)
double whole_line(double L) {
  const double sine_ratio = L == 0 ? 1 : std::sin(L) / L;
  return pi * sine_ratio * sine_ratio / (1 + sine_ratio * std::cos(L));
}

}  // namespace

Spot spot(Two at, Accuracy accuracy) {
  const double tolerance = accuracy.rtol() / 32;
  return {at, std::fabs(at.high) < kNearest ? Waves{} : waves(at, tolerance)};
}

double faded_kernel(Kernel kernel, const Spot& at, Accuracy accuracy) {
  const double w = at.at.high;
  const int sign = (w > 0) - (w < 0);
  if (std::fabs(w) >= kNearest) return (kernel == Kernel::I1 ? 1 : sign) * faded_kernel(kernel, at.waves);
  if (kernel == Kernel::I1) return I1(w, accuracy);
  const double odd = kernel == Kernel::I3   ? I3(w, accuracy)
                     : kernel == Kernel::I4 ? I4(w, accuracy)
                                            : I5(w, accuracy);
  return odd - sign * (pi / 4);
}

double steady_memory(Kernel kernel, const Spot& start, Two rate, Accuracy accuracy) {
  if (kernel == Kernel::I1 && start.at.high <= -kNearest) {
    return whole_line(rate.high) * decay(rate * -start.at) + residues_behind(kernel, start.waves, rate.high);
  }
  return by_pieces(kernel, start, nullptr, {}, rate, accuracy);
}

Complex steady_memory(Kernel kernel, const Spot& start, Complex rate, Accuracy accuracy) {
  return by_pieces(kernel, start, nullptr, {}, rate, accuracy);
}

double memory(Kernel kernel, const Spot& start, const Spot& end, Two length, Two rate, Accuracy accuracy) {
  // Over a half-thickness or more, and beyond the surroundings of the load, the rest is small against the
  // whole.
  if (length.high >= 1 && end.at.high >= kNearest) {
    const double all = steady_memory(kernel, start, rate, accuracy);
    const bool forgotten = rate.high * std::min(length.high, end.at.high) > 42;
    return forgotten ? all : all - decay(rate * length) * steady_memory(kernel, end, rate, accuracy);
  }
  return by_pieces(kernel, start, &end, length, rate, accuracy);
}

Complex memory(Kernel kernel, const Spot& start, const Spot& end, Two length, Complex rate,
               Accuracy accuracy) {
  return by_pieces(kernel, start, &end, length, rate, accuracy);
}

}  // namespace nipref::fast::internal
