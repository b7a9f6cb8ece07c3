#pragma once
#include <array>
#include <optional>
#include <vector>

#include <nipref/fast/memory/internal/smooth_part.hpp>
#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal {

/// Up to this distance from the load the logarithm of I1 is treated separately, as in the table of the smooth rest.
constexpr double inner_end = near_end;

/// The ends of the pieces near the load, the first of which starts at -1.
inline constexpr std::array core_stops{-inner_end, 0.0, inner_end, 1.0};
/// The integral over each whole piece, with a weight that is 1 at its start.
using CorePieces = std::array<double, core_stops.size()>;

CorePieces core_of(Kernel kernel, double rate, Accuracy accuracy);

/// int_0^length e^(-rate d) I(w + d) dd for -1 <= w < end = w + length <= 1, by exponential integrals for the logarithm
/// and Gauss rules for the smooth rest. Both `end` and `length` are arguments, as either may be smaller than the
/// rounding error of the other. `whole` must be made for the same kernel and rate.
double memory_under_load(Kernel kernel, double w, double end, double length, double rate,
                         const CorePieces& whole, Accuracy accuracy);
/// The integral for a complex rate, by panels that are graded towards the logarithm.
Complex memory_under_load(Kernel kernel, double w, double end, double length, Complex rate,
                          Accuracy accuracy);

/// int_w^1 e^(-rate (x - w)) I(x) dx from many places w of [-1, 1], for a complex rate. The integral is stored at the
/// ends of the panels of memory_under_load, so that each place needs one panel. For I1 and I3, at rates of modulus
/// polynomial_from or more, the logarithm is integrated in closed form and the smooth rest is a SmoothMemory.
class OscillatingCore {
 public:
  OscillatingCore(Kernel kernel, Complex rate, Accuracy accuracy);
  [[nodiscard]] Complex from(double w) const;

 private:
  Kernel kernel_;
  Complex rate_;
  Accuracy accuracy_;
  std::vector<double> stops_;  ///< ends of the panels, from 1 down to -1
  std::vector<Complex> from_stops_;
  std::optional<SmoothMemory<Complex>> smooth_;
};

}  // namespace nipref::fast::internal
