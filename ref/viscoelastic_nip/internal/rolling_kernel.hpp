#pragma once
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <nipref/ref/number/internal/float.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// amplitude e^(-rate w), w the way (half-thicknesses) that a material point has gone since: a relaxation term
/// of the compliance over its instantaneous part, as the steadily rolling sheet sees it. Dimensionless.
struct RollingMemory {
  Float amplitude;
  Float rate;  ///< > 0
};

/// G(x) = int_0^inf e^{-rate w} J(x - w) dw, J = I1 + ln|.| analytic for |Im x| < 2, of x in a range that grows
/// as it is asked for: G' + rate G = J is collocated at Chebyshev points of panels of length 1, downstream
/// from where I1 is 0 to the working precision and G follows from the logarithm alone.
class FadingSmoothPart {
 public:
  FadingSmoothPart(Float rate, int digits, const Float& first_value, long first_panel);

  Float operator()(const Float& x, SmoothKernel& kernel);

 private:
  void append_panel(SmoothKernel& kernel);

  long first_panel_;
  int points_;
  Float scale_;
  Matrix inverse_;  ///< from J at the points, over the scale, and G at the panel's start to coefficients
  std::vector<Float> nodes_;
  Float end_value_;
  std::vector<std::vector<Float>> panels_;
};

/// Displacement under a unit of pressure of a steadily rolling sheet, x downstream of it, and all that it
/// leaves behind in the sheet's memory,
///
///     pi K(x) = I1(x) + sum amplitude int_0^inf e^{-rate w} I1(x - w) dw.
///
/// With I1 = J - ln|x| the logarithm's part is -(1/rate)(ln|x| - e^{-rate x} Ei(rate x)), the rest
/// FadingSmoothPart. K is analytic but for x = 0 (and for |Im x| < 2), on the scale of x itself however short
/// the memory is: it is interpolated on panels that double away from 0, up to length 1, each made when it is
/// first met.
class RollingKernel {
 public:
  /// To about `digits` digits of its size, at |x| <= 900.
  RollingKernel(std::vector<RollingMemory> memory, int digits);

  /// K at x, not 0.
  Float operator()(const Float& x);
  [[nodiscard]] const std::vector<RollingMemory>& memory() const { return memory_; }
  [[nodiscard]] double nats() const { return nats_; }
  [[nodiscard]] long kernel_values() const { return smooth_.kernel_values(); }

 private:
  Float direct(const Float& x);
  std::vector<Float> make_panel(const Float& from, const Float& width);

  std::vector<RollingMemory> memory_;
  double nats_;
  SmoothKernel smooth_;
  std::vector<FadingSmoothPart> fading_;
  std::map<std::pair<int, long>, std::vector<Float>> panels_;  ///< by sign and place
};

}  // namespace nipref::ref
