#pragma once
#include <functional>
#include <map>
#include <vector>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/internal/cosines.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A kernel, or its substitute in a test: an interval of half-width about e^{-nats} that contains the value at alpha
/// > 0.
using NormalKernel = std::function<Interval(const Exact& alpha, double nats)>;

/// The properties of a kernel: whether -ln|alpha| is part of it, and M, see SmoothKernel.
struct KernelShape {
  bool logarithmic;
  double variation;
};
inline constexpr KernelShape I1_shape{true, 127}, I3_shape{false, 127}, I3_integral_shape{false, 226};

/// The analytic part of I1, J(alpha) = I1(alpha) + ln|alpha|, from few values of I1. It is interpolated at Chebyshev
/// points on panels of length 1/4, each of which is made when it is first needed.
///
/// With g(x) = x K(x), K the symbol of I1,
///
///     1 - g(x) = (1 + 2x - e^{-2x})/(sinh 2x + 2x) <= 2 (1 + 2x) e^{-2x},    x >= 0
///
/// (multiplied out this is e^{-2x} (1 - e^{-2x} + 4x + 8x^2 - 2x e^{-2x}) >= 0), so that J, even, with
/// J'(z) = int_0^inf (1 - g) sin(zx) dx, is analytic for |Im z| < 2, where |J'(z)| <= Q(|Im z|),
///
///     Q(y) = int_0^inf (1 - g(x)) e^{yx} dx <= 2/(2 - y) + 4/(2 - y)^2.
///
/// On the real axis |J'| <= Q(0) <= 2. The ellipse with the ends of a panel as foci and semi-minor axis 7/4
/// has semi-axes that sum to more than 28 of the panel's half lengths; on it J differs from its value in the
/// middle by at most M = 1.76 Q(7/4) < 127. Hence the n-th Chebyshev coefficient is at most 2 M/28^n, and the error of
/// interpolation at n points is at most 4 M/28^{n-1}/27. (Trefethen, Approximation Theory and Approximation Practice,
/// 8.1, 8.2)
///
/// The same holds for I3, which is odd and analytic itself: I3'(z) = int (2x/S) cos(zx) dx, S = sinh 2x + 2x, and
/// 2x/S <= 1 - g. Here its values are for alpha > 0, and the caller has to apply the sign. It also holds for the even
/// integral of I3 from 0: |I3| <= Si(pi)/2 < 1 on the real axis (2/S decreases and is at most 1/(2x)) and |I3| < 1 +
/// (7/4) Q(7/4) within the ellipse, so that M = 1.76 (1 + 127) < 226.
class SmoothKernel {
 public:
  /// The error is about 10^-digits; the working precision has to be a few digits more.
  SmoothKernel(NormalKernel kernel, int digits, KernelShape shape = I1_shape);

  /// J at |alpha| <= 1000, with error error(). std::logic_error if the kernel's values cannot be those of I1, because
  /// the last coefficients of a panel exceed their bound.
  [[nodiscard]] Float operator()(const Float& alpha);
  /// The slope of the interpolation at |alpha|. With n points its error is about 8 n^2 error(), by Markov's inequality.
  [[nodiscard]] Float slope(const Float& alpha);
  /// An interval that contains J on an interval of arguments.
  [[nodiscard]] Interval over(const Interval& alpha);
  /// Bound on the error of every value given so far.
  [[nodiscard]] const Float& error() const { return error_; }
  [[nodiscard]] long kernel_values() const { return static_cast<long>(panels_.size()) * points_; }

 private:
  using Coefficients = std::vector<Float>;
  struct Panel {
    Coefficients value, slope;
  };
  /// evaluate(coefficients, x) for the panel of |alpha|, where x is the position in the panel, -1 to 1.
  template <class Evaluate>
  Float in_panel(const Float& alpha, const Evaluate& evaluate);
  Panel make_panel(long index);
  [[nodiscard]] std::vector<Interval> node_values(long index, const Cosines& cosines) const;

  NormalKernel kernel_;
  KernelShape shape_;
  double nats_;
  long points_;  ///< number of points of a panel
  std::map<long, Panel> panels_;
  Float error_ = 0;
};

}  // namespace nipref::ref
