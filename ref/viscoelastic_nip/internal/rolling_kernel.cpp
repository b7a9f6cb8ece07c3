#include <cmath>
#include <numbers>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_kernel.hpp>

namespace nipref::ref {
namespace {

/// Chebyshev points of -1 .. 1.
std::vector<Float> chebyshev_zeros_here(int points) {
  std::vector<Float> zeros;
  for (int i = 0; i < points; ++i) zeros.push_back(cos((2 * i + 1) * pi() / (2 * points)));
  return zeros;
}

/// Coefficients of the polynomial with these values at the points.
std::vector<Float> interpolate_at_zeros(const std::vector<Float>& values) {
  const int n = static_cast<int>(values.size());
  std::vector<Float> cosine;
  for (int k = 0; k < 4 * n; ++k) cosine.push_back(cos(k * pi() / (2 * n)));
  std::vector<Float> coefficients;
  for (int j = 0; j < n; ++j) {
    Float sum = 0;
    for (int i = 0; i < n; ++i)
      sum +=
          values[static_cast<std::size_t>(i)] * cosine[static_cast<std::size_t>(j * (2 * i + 1) % (4 * n))];
    coefficients.push_back((j == 0 ? 1 : 2) * sum / n);
  }
  return coefficients;
}

/// e^{-x} Ei(x), x not 0.
Float scaled_exponential_integral(const Float& x) {
  Float result;
  mpfr_eint(result.get(), x.get(), MPFR_RNDN);
  return exp(-x) * result;
}

/// int_0^inf e^{-rate w} ln|x - w| dw
Float fading_logarithm(const Float& rate, const Float& x) {
  return (log(abs(x)) - scaled_exponential_integral(rate * x)) / rate;
}

/// Where I1 < e^{-nats}: it decays faster than e^{-2.1 |x|}.
long far_ahead(double nats) { return std::lround(std::ceil(nats / 2.1)) + 2; }

}  // namespace

FadingSmoothPart::FadingSmoothPart(Float rate, int digits, const Float& first_value, long first_panel)
    : first_panel_(first_panel),
      // J is analytic in an ellipse whose semi-axes sum to 8.1 half panels.
      points_(static_cast<int>(digits * std::numbers::ln10 / 2.05) + 8),
      scale_(1 + rate),
      nodes_(chebyshev_zeros_here(points_)),
      end_value_(first_value) {
  Matrix matrix(points_ + 1, points_ + 1);
  for (int i = 0; i < points_; ++i) {
    const Float& x = nodes_[static_cast<std::size_t>(i)];
    Float last = x, now = 1, last_slope = 0, slope = 0;
    for (int j = 0; j <= points_; ++j) {
      if (j == 1) {
        last = 1, now = x, last_slope = 0, slope = 1;
      } else if (j > 1) {
        const Float next = 2 * x * now - last;
        const Float next_slope = 2 * now + 2 * x * slope - last_slope;
        last = now, now = next, last_slope = slope, slope = next_slope;
      }
      matrix(i, j) = (2 * slope + rate * now) / scale_;
    }
  }
  for (int j = 0; j <= points_; ++j) matrix(points_, j) = j % 2 == 0 ? 1 : -1;
  inverse_ = matrix.inverse();
}

void FadingSmoothPart::append_panel(SmoothKernel& kernel) {
  const long left = first_panel_ + static_cast<long>(panels_.size());
  Vector right(points_ + 1);
  for (int i = 0; i < points_; ++i)
    right(i) = kernel(left + (1 + nodes_[static_cast<std::size_t>(i)]) / 2) / scale_;
  right(points_) = end_value_;
  const Vector solution = inverse_ * right;
  std::vector<Float> coefficients;
  end_value_ = 0;
  for (int j = 0; j <= points_; ++j) {
    coefficients.push_back(solution(j));
    end_value_ += solution(j);
  }
  panels_.push_back(std::move(coefficients));
}

Float FadingSmoothPart::operator()(const Float& x, SmoothKernel& kernel) {
  const long panel = std::lround(std::floor(static_cast<double>(x)));
  if (panel < first_panel_) return 0;
  const auto place = static_cast<std::size_t>(panel - first_panel_);
  while (panels_.size() <= place) append_panel(kernel);
  return chebyshev_sum(panels_[place], 2 * (x - panel) - 1);
}

RollingKernel::RollingKernel(std::vector<RollingMemory> memory, int digits)
    : memory_(std::move(memory)), nats_(digits * std::numbers::ln10), smooth_(I1_interval, digits) {
  const long far = far_ahead(nats_);
  for (const RollingMemory& term : memory_)
    fading_.emplace_back(term.rate, digits, fading_logarithm(term.rate, Float(-far)), -far);
}

Float RollingKernel::direct(const Float& x) {
  if (static_cast<double>(x) < -static_cast<double>(far_ahead(nats_))) return 0;
  Float sum = smooth_(x) - log(abs(x));
  for (std::size_t r = 0; r < memory_.size(); ++r)
    sum += memory_[r].amplitude * (fading_[r](x, smooth_) - fading_logarithm(memory_[r].rate, x));
  return sum / pi();
}

std::vector<Float> RollingKernel::make_panel(const Float& from, const Float& width) {
  // Singular at 0, a panel's width away at least: semi-axes that sum to 5.8.
  const int points = static_cast<int>(nats_ / 1.75) + 8;
  std::vector<Float> values;
  for (const Float& node : chebyshev_zeros_here(points))
    values.push_back(direct(from + width * (1 + node) / 2));
  return interpolate_at_zeros(values);
}

Float RollingKernel::operator()(const Float& x) {
  const int sign = x > 0 ? 1 : -1;
  const long exponent = mpfr_get_exp(x.get());  // |x| from 2^{exponent - 1} to 2^exponent
  Float near, width = 1;
  long place = exponent;
  if (exponent > 1) {
    place = std::lround(std::floor(std::fabs(static_cast<double>(x))));
    near = place;
  } else {
    near = ldexp(Float(1), exponent - 1);
    width = near;
  }
  auto found = panels_.find({sign, place});
  if (found == panels_.end())
    found = panels_.emplace(std::pair(sign, place), make_panel(sign * near, sign * width)).first;
  return chebyshev_sum(found->second, 2 * (abs(x) - near) / width - 1);
}

}  // namespace nipref::ref
