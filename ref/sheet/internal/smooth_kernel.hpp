#pragma once
#include <functional>
#include <map>
#include <vector>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {

/// A kernel, or its substitute in a test: returns an interval of half-width about e^{-nats} that contains the value at
/// alpha > 0.
using NormalKernel = std::function<Interval(const Exact& alpha, double nats)>;

/// Whether -ln|alpha| is part of a kernel, and the kernel's bound M in ref/sheet/README.md, The smooth kernels.
struct KernelShape {
  bool logarithmic;
  double variation;
};
inline constexpr KernelShape I1_shape{true, 127}, I3_shape{false, 127}, I3_integral_shape{false, 226};

/// The analytic part of I1, J(alpha) = I1(alpha) + ln|alpha|, interpolated between few values of I1 at Chebyshev points
/// on panels of length 1/4. A panel is made when it is first needed. With other shapes J is I3 for alpha > 0, to which
/// the caller applies the sign, or the integral of I3 from 0. Proven: ref/sheet/README.md, The smooth kernels.
class SmoothKernel {
 public:
  /// The error is about 10^-digits; the working precision has to be a few digits more.
  SmoothKernel(NormalKernel kernel, int digits, KernelShape shape = I1_shape);

  /// J at |alpha| <= 1000, with error error(). Throws std::logic_error if the last coefficients of a panel exceed their
  /// bound, so that the values given are not those of the kernel.
  [[nodiscard]] Float operator()(const Float& alpha);
  /// The slope of the interpolation at |alpha|. With n points its error is about 8 n^2 error(), by Markov's inequality.
  [[nodiscard]] Float slope(const Float& alpha);
  /// An interval that contains J on an interval of arguments.
  [[nodiscard]] Interval over(const Interval& alpha);
  /// An error bound for every value given so far.
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
