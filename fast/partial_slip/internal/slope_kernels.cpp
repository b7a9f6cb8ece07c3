#include <cmath>
#include <numbers>

#include <nipref/fast/partial_slip/internal/slope_kernels.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {
namespace {

using std::numbers::pi;

SlopeKernels::Values regular(double alpha) {
  constexpr auto first = data::Derivative::first;
  const double cauchy = 1 / (pi * alpha);
  return {un_slope(alpha, first) + cauchy, vn_slope(alpha, first), vs_slope(alpha, first) + cauchy, 0};
}

/// sum of c_k T_k(t), c_0 halved.
template <class Series>
SlopeKernels::Values sum(const Series& c, double t) {
  SlopeKernels::Values last = SlopeKernels::Values::Zero(), before = last;
  for (std::size_t k = c.size() - 1; k > 0; --k) {
    const SlopeKernels::Values next = c[k] + 2 * t * last - before;
    before = last;
    last = next;
  }
  return 0.5 * c[0] + t * last - before;
}

}  // namespace

SlopeKernels::SlopeKernels(double longest) {
  for (int middle = 0; middle <= std::ceil(longest); ++middle) {
    Series series, slopes;
    series.fill(Values::Zero());
    for (int i = 0; i < terms; ++i) {
      const double angle = (i + 0.5) * pi / terms;
      const Values value = regular(middle + 0.5 * std::cos(angle));
      for (int k = 0; k < terms; ++k)
        series[static_cast<std::size_t>(k)] += 2.0 / terms * std::cos(k * angle) * value;
    }
    slopes.fill(Values::Zero());
    for (std::size_t k = terms - 1; k > 0; --k)
      slopes[k - 1] =
          (k + 1 < terms ? slopes[k + 1] : Values::Zero()) + 4.0 * static_cast<double>(k) * series[k];
    values_.push_back(series);
    derivatives_.push_back(slopes);
  }
}

SlopeKernels::Values SlopeKernels::at(double alpha) const {
  const double size = std::fabs(alpha), middle = std::round(size), cauchy = 1 / (pi * alpha);
  const double sign = std::copysign(1, alpha);
  return Values(sign, 1, sign, 0) * sum(values_[static_cast<std::size_t>(middle)], 2 * (size - middle)) -
         Values(cauchy, 0, cauchy, 0);
}

SlopeKernels::Values SlopeKernels::derivatives(double alpha) const {
  const double size = std::fabs(alpha), middle = std::round(size), cauchy = 1 / (pi * alpha * alpha);
  const double sign = std::copysign(1, alpha);
  return Values(1, sign, 1, 0) * sum(derivatives_[static_cast<std::size_t>(middle)], 2 * (size - middle)) +
         Values(cauchy, 0, cauchy, 0);
}

}  // namespace nipref::fast
