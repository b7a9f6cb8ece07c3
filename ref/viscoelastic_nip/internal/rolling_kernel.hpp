#pragma once
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_material.hpp>

namespace nipref::ref {

/// G(x) = int_0^inf e^{-rate w} J(x - w) dw, J real and analytic for |Im x| < 2, of x in a range that grows as
/// it is asked for: G' + rate G = J is collocated at Chebyshev points of panels of length 1, downstream from
/// where G is known.
class FadingSmoothPart {
 public:
  using Smooth = std::function<Float(const Float&)>;

  FadingSmoothPart(const ComplexFloat& rate, int digits, const ComplexFloat& first_value, long first_panel);

  /// x >= first_panel
  ComplexFloat operator()(const Float& x, const Smooth& smooth);

 private:
  /// Of one panel: real parts, and imaginary ones unless the rate is real.
  struct Coefficients {
    std::vector<Float> re, im;
  };
  void append_panel(const Smooth& smooth);

  long first_panel_;
  bool real_;
  int points_;
  Float scale_;
  Matrix inverse_;  ///< from J at the points, over the scale, and G at the panel's start to coefficients
  std::vector<Float> nodes_;
  ComplexFloat end_value_;
  std::vector<Coefficients> panels_;
};

/// What a unit of pressure, and all that it leaves behind in the sheet's memory, does to the surface of a
/// steadily rolling sheet, x downstream of it: a function that is analytic but for x = 0 and |Im x| < 2, on the
/// scale of x itself however short the memory is. It is interpolated on panels that double away from 0, up to
/// length 1, each made when it is first met; from far() on there are the memories' exponentials alone.
class RollingKernel {
 public:
  RollingKernel(const RollingKernel&) = delete;
  RollingKernel& operator=(const RollingKernel&) = delete;
  virtual ~RollingKernel() = default;

  /// At x, not 0.
  Float operator()(const Float& x);
  /// From where the sheet moves no more by what presses it, but for its memory.
  [[nodiscard]] long far() const { return far_; }
  [[nodiscard]] const std::vector<RollingMemory>& memory() const { return memory_; }
  [[nodiscard]] double nats() const { return nats_; }
  /// How often it was asked for a value.
  [[nodiscard]] long evaluations() const { return evaluations_; }
  /// Radians that memories swing by over a way, as far as they are not forgotten within it.
  [[nodiscard]] double swing(double way) const;
  [[nodiscard]] long kernel_values() const { return smooth_.kernel_values(); }

 protected:
  /// To about `digits` digits of its size.
  RollingKernel(std::vector<RollingMemory> memory, int digits, SmoothKernel smooth);
  /// |x| <= far
  [[nodiscard]] virtual Float direct(const Float& x) = 0;
  [[nodiscard]] virtual Float far_upstream() = 0;
  /// x >= far
  [[nodiscard]] virtual Float far_downstream(const Float& x) = 0;
  [[nodiscard]] SmoothKernel& smooth() { return smooth_; }

 private:
  std::vector<Float> make_panel(const Float& from, const Float& width);

  std::vector<RollingMemory> memory_;
  double nats_;
  long far_, evaluations_ = 0;
  SmoothKernel smooth_;
  std::map<std::pair<int, long>, std::vector<Float>> panels_;  ///< by sign and place
};

/// Displacement towards the middle plane,
///
///     pi K(x) = I1(x) + sum amplitude int_0^inf e^{-rate w} I1(x - w) dw,
///
/// the terms those of N. I1 = J - ln|x|; the logarithm's memory is in closed form.
class NormalRollingKernel : public RollingKernel {
 public:
  NormalRollingKernel(const RollingMaterial& material, int digits);

 private:
  [[nodiscard]] Float direct(const Float& x) override;
  [[nodiscard]] Float far_upstream() override { return 0; }
  [[nodiscard]] Float far_downstream(const Float& x) override;
  /// int_0^inf e^{-rate w} I1(x - w) dw, |x| <= far
  [[nodiscard]] ComplexFloat faded(std::size_t term, const Float& x);

  std::vector<FadingSmoothPart> fading_;
  std::vector<ComplexFloat> left_far_;  ///< of a term, at far()
};

/// Displacement along the sheet, upstream (towards the leading side), up to a constant,
///
///     pi T(x) = theta2 * I2(x) - N * I3(x),
///     theta * I(x) = theta_0 I(x) + sum amplitude int_0^inf e^{-rate w} (I(x - w) - I(-inf)) dw;
///
/// the terms in eta of (thesis 6.23-6.28) are the same at all points, and so is what is taken away by I(-inf),
/// -pi/2 or -pi/4, which would be infinite for a fluid. The sign's memory, I2 = (pi/2) sign, is in closed form, and
/// I3 is analytic.
class TangentialRollingKernel : public RollingKernel {
 public:
  TangentialRollingKernel(const RollingMaterial& material, int digits);

 private:
  [[nodiscard]] Float direct(const Float& x) override;
  [[nodiscard]] Float far_upstream() override { return direct(-Float(far())); }
  [[nodiscard]] Float far_downstream(const Float& x) override { return direct(x); }

  Float theta2_at_once_;
  std::vector<RollingMemory> theta2_;
  std::vector<FadingSmoothPart> fading_;
};

/// The slope of the tangential kernel but for its jump at x = 0,
///
///     pi T'(x) = -I3'(x) - sum amplitude int_0^inf e^{-rate w} I3'(x - w) dw
///                + pi sum amplitude_2 e^{-rate_2 x} where x > 0,
///
/// terms those of N and of theta2: for the surface's strain by one integral, as near to the ends as any. I3' is
/// analytic and even.
class StretchRollingKernel : public RollingKernel {
 public:
  StretchRollingKernel(const RollingMaterial& material, int digits);
  /// Of T.
  [[nodiscard]] const Float& jump() const { return theta2_at_once_; }

 private:
  [[nodiscard]] Float direct(const Float& x) override;
  [[nodiscard]] Float far_upstream() override { return 0; }
  [[nodiscard]] Float far_downstream(const Float& x) override;
  /// pi times what theta2's memory leaves at x > 0.
  [[nodiscard]] Float left_by_theta2(const Float& x) const;
  /// int_0^inf e^{-rate w} I3'(x - w) dw, |x| <= far
  [[nodiscard]] ComplexFloat faded(std::size_t term, const Float& x);

  Float theta2_at_once_;
  std::vector<RollingMemory> theta2_;
  std::vector<FadingSmoothPart> fading_;
};

}  // namespace nipref::ref
