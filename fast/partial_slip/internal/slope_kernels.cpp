#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/interpolation.hpp>
#include <nipref/fast/partial_slip/internal/slope_kernels.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {
namespace {

using Eigen::ArrayXd, Eigen::Index, Eigen::MatrixXd;
using std::numbers::pi;

struct Rests {
  Eigen::Array3d value, slope;
};

/// The rests and their derivatives for |alpha - middle| < 1/2 by Chebyshev series of 20 terms, which fall like
/// (4 + sqrt 17)^-k. Nothing cancels in them next to 0.
class RestSeries {
 public:
  explicit RestSeries(int middle) : middle_(middle) {
    constexpr auto first = data::Derivative::first;
    for (int i = 0; i < terms; ++i) {
      const double angle = (i + 0.5) * pi / terms, alpha = middle + 0.5 * std::cos(angle);
      const double cauchy = 1 / (pi * alpha);
      const Eigen::Array3d value(un_slope(alpha, first) + cauchy, vn_slope(alpha, first),
                                 vs_slope(alpha, first) + cauchy);
      for (int k = 0; k < terms; ++k)
        coefficients_.col(k) += (k == 0 ? 1.0 : 2.0) / terms * std::cos(k * angle) * value;
    }
  }
  /// T_k' = k U_(k-1).
  [[nodiscard]] Rests at(double alpha) const {
    const double x = 2 * (alpha - middle_);
    double t = 1, next_t = x, u = 0, next_u = 1;
    Rests sum{Eigen::Array3d::Zero(), Eigen::Array3d::Zero()};
    for (int k = 0; k < terms; ++k) {
      sum.value += t * coefficients_.col(k);
      sum.slope += 2 * k * u * coefficients_.col(k);
      t = std::exchange(next_t, 2 * x * next_t - t);
      u = std::exchange(next_u, 2 * x * next_u - u);
    }
    return sum;
  }

 private:
  static constexpr int terms = 20;
  int middle_;
  Eigen::Array<double, 3, terms> coefficients_ = Eigen::Array<double, 3, terms>::Zero();
};

/// U and S are odd, V is even; their derivatives have the opposite parity.
const Eigen::Array3d value_parity(-1, 1, -1);

/// The rests at alpha >= 0.
Rests rests(double alpha) {
  static Cache<int, RestSeries> kept([](const int& middle) { return RestSeries(middle); });
  return kept.at(static_cast<int>(std::lround(alpha)))->at(alpha);
}

/// The points that interpolate the rests on the whole contact to rounding. The singularities 2 i beside the contact are
/// on the ellipse of convergence whose half axes add up to 4/length + sqrt((4/length)^2 + 1) half-lengths.
int points_for(double length) { return 2 + static_cast<int>(std::ceil(37 / std::asinh(4 / length))); }

/// Sets U, V and S between a source and a target in the matrix [U, -V; V, S].
void set(MatrixXd& kernels, Index target, Index source, const Eigen::Array3d& of) {
  const Index points = kernels.cols() / 2;
  kernels(target, source) = of(0);
  kernels(target, points + source) = -of(1);
  kernels(points + target, source) = of(1);
  kernels(points + target, points + source) = of(2);
}

}  // namespace

SlopeKernels::Points::Points(int eighths) : length(std::exp2(eighths / 8.0)) {
  const int count = points_for(length);
  const ArrayXd points = internal::chebyshev_points(length, count);
  values.resize(2 * count, 2 * count);
  slopes.resize(2 * count, 2 * count);
  for (Index a = 0; a < count; ++a) {
    for (Index b = 0; b <= a; ++b) {
      const Rests of = rests(points(a) - points(b));
      set(values, a, b, of.value);
      set(values, b, a, value_parity * of.value);
      set(slopes, a, b, of.slope);
      set(slopes, b, a, -value_parity * of.slope);
    }
  }
}

SlopeKernels::SlopeKernels(double length, const ArrayXd& targets, const ArrayXd& sources) {
  static Cache<int, Points> kept([](const int& eighths) { return Points(eighths); });
  points_ = kept.at(static_cast<int>(std::ceil(8 * std::log2(length))));
  const Index count = points_->values.rows() / 2;
  at_targets_ = internal::interpolation(targets, points_->length, count);
  from_sources_ = internal::interpolation(sources, points_->length, count).transpose();
}

}  // namespace nipref::fast
