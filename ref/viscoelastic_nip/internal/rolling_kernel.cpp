#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/viscoelastic_nip/internal/fading_logarithm.hpp>
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

/// Where I1, and what I3 differs from its limit by, is below e^{-nats}: they decay faster than e^{-2.1 |x|}.
long far_ahead(double nats) { return std::lround(std::ceil(nats / 2.1)) + 2; }

/// What the slope of an interpolation loses of its values' digits, see SmoothKernel::slope().
constexpr int digits_of_slope = 4;

/// int_0^x e^{-rate w} dw
ComplexFloat fading_way(const ComplexFloat& rate, const Float& x) {
  if (rate.re == 0) return x;
  return (ComplexFloat(1) - exp(-(rate * x))) / rate;
}

}  // namespace

FadingSmoothPart::FadingSmoothPart(const ComplexFloat& rate, int digits, const ComplexFloat& first_value,
                                   long first_panel)
    : first_panel_(first_panel),
      real_(rate.is_real()),
      // J is analytic in an ellipse whose semi-axes sum to 8.1 half panels.
      points_(static_cast<int>(digits * std::numbers::ln10 / 2.05) + 8),
      scale_(1 + abs(rate)),
      nodes_(chebyshev_zeros_here(points_)),
      end_value_(first_value) {
  // The unknowns are the real parts of the coefficients and, below them, their imaginary parts.
  const int each = points_ + 1, all = real_ ? each : 2 * each;
  Matrix matrix(all, all);
  const auto set = [&](int i, int j, const Float& re, const Float& im) {
    matrix(i, j) = re;
    if (real_) return;
    matrix(i + each, j + each) = re;
    matrix(i + each, j) = im;
    matrix(i, j + each) = -im;
  };
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
      set(i, j, (2 * slope + rate.re * now) / scale_, rate.im * now / scale_);
    }
  }
  for (int j = 0; j <= points_; ++j) set(points_, j, j % 2 == 0 ? 1 : -1, 0);
  inverse_ = matrix.inverse();
}

void FadingSmoothPart::append_panel(const Smooth& smooth) {
  const long left = first_panel_ + static_cast<long>(panels_.size());
  const int each = points_ + 1;
  Vector right(inverse_.rows());
  for (int i = 0; i < points_; ++i)
    right(i) = smooth(left + (1 + nodes_[static_cast<std::size_t>(i)]) / 2) / scale_;
  right(points_) = end_value_.re;
  if (!real_) right(points_ + each) = end_value_.im;
  const Vector solution = inverse_ * right;
  Coefficients coefficients;
  end_value_ = {};
  for (int j = 0; j < each; ++j) {
    coefficients.re.push_back(solution(j));
    end_value_.re += solution(j);
    if (real_) continue;
    coefficients.im.push_back(solution(j + each));
    end_value_.im += solution(j + each);
  }
  panels_.push_back(std::move(coefficients));
}

ComplexFloat FadingSmoothPart::operator()(const Float& x, const Smooth& smooth) {
  const long panel = std::lround(std::floor(static_cast<double>(x)));
  const auto place = static_cast<std::size_t>(panel - first_panel_);
  while (panels_.size() <= place) append_panel(smooth);
  const Float inside = 2 * (x - panel) - 1;
  const auto& [re, im] = panels_[place];
  return {chebyshev_sum(re, inside), real_ ? Float(0) : chebyshev_sum(im, inside)};
}

RollingKernel::RollingKernel(std::vector<RollingMemory> memory, int digits, SmoothKernel smooth)
    : memory_(std::move(memory)),
      nats_(digits * std::numbers::ln10),
      far_(far_ahead(nats_)),
      smooth_(std::move(smooth)) {}

double RollingKernel::swing(double way) const {
  double radians = 0;
  for (const RollingMemory& term : memory_) {
    const auto fading = static_cast<double>(term.rate.re);
    radians = std::max(radians, static_cast<double>(term.rate.im) * std::min(way, nats_ / fading));
  }
  return radians;
}

std::vector<Float> RollingKernel::make_panel(const Float& from, const Float& width) {
  // Singular at 0, a panel's width away at least: semi-axes that sum to 5.8, within which a memory that swings
  // grows by e^{1.4 times its swing}.
  const int points =
      static_cast<int>((nats_ + 1.4 * swing(std::fabs(static_cast<double>(width)))) / 1.75) + 8;
  std::vector<Float> values;
  for (const Float& node : chebyshev_zeros_here(points))
    values.push_back(direct(from + width * (1 + node) / 2));
  std::vector<Float> coefficients = interpolate_at_zeros(values);
  // Panels far from 0, where the function is smoother, need fewer.
  Float largest = 0;
  for (const Float& c : coefficients) largest = std::max(largest, abs(c));
  const Float least = largest * exp(Float(-nats_ - 2));
  while (coefficients.size() > 1 && abs(coefficients.back()) < least) coefficients.pop_back();
  return coefficients;
}

Float RollingKernel::operator()(const Float& x) {
  ++evaluations_;
  if (x <= -far_) return far_upstream();
  if (x >= far_) return far_downstream(x);
  const int sign = x > 0 ? 1 : -1;
  const long exponent = mpfr_get_exp(raw(x));  // |x| from 2^{exponent - 1} to 2^exponent
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

NormalRollingKernel::NormalRollingKernel(const RollingMaterial& material, int digits)
    : RollingKernel(material.normal, digits, SmoothKernel(I1_interval, digits)) {
  for (const RollingMemory& term : memory())
    fading_.emplace_back(term.rate, digits, fading_logarithm(term.rate, Float(-far())), -far());
}

ComplexFloat NormalRollingKernel::faded(std::size_t term, const Float& x) {
  return fading_[term](x, [&](const Float& at) { return smooth()(at); }) -
         fading_logarithm(memory()[term].rate, x);
}

Float NormalRollingKernel::direct(const Float& x) {
  Float sum = smooth()(x) - log(abs(x));
  for (std::size_t r = 0; r < memory().size(); ++r) sum += (memory()[r].amplitude * faded(r, x)).re;
  return sum / pi();
}

Float NormalRollingKernel::far_downstream(const Float& x) {
  const Float from(far());
  Float sum = 0;
  for (std::size_t r = 0; r < memory().size(); ++r) {
    const auto& [amplitude, rate] = memory()[r];
    if (left_far_.size() <= r) left_far_.push_back(amplitude * faded(r, from));
    sum += (left_far_[r] * exp(-(rate * (x - from)))).re;
  }
  return sum / pi();
}

TangentialRollingKernel::TangentialRollingKernel(const RollingMaterial& material, int digits)
    : RollingKernel(material.normal, digits, SmoothKernel(I3_interval, digits, I3_shape)),
      theta2_at_once_(material.theta2_at_once),
      theta2_(material.theta2) {
  for (const RollingMemory& term : memory()) fading_.emplace_back(term.rate, digits, ComplexFloat(), -far());
}

Float TangentialRollingKernel::direct(const Float& x) {
  const auto I3 = [&](const Float& at) { return at < 0 ? -smooth()(at) : smooth()(at); };
  const auto above_limit = [&](const Float& at) { return I3(at) + pi() / 4; };
  // Nothing of the sheet's own changes beyond.
  const Float within = std::min(x, Float(far())), beyond = x - within;
  Float sum = -I3(within);
  for (std::size_t r = 0; r < memory().size(); ++r) {
    const auto& [amplitude, rate] = memory()[r];
    ComplexFloat faded = fading_[r](within, above_limit);
    if (beyond > 0) faded = faded * exp(-(rate * beyond)) + fading_way(rate, beyond) * (pi() / 2);
    sum -= (amplitude * faded).re;
  }
  const Float half_pi = pi() / 2;
  if (x < 0) return (sum - half_pi * theta2_at_once_) / pi();
  sum += half_pi * theta2_at_once_;
  for (const auto& [amplitude, rate] : theta2_) sum += pi() * (amplitude * fading_way(rate, x)).re;
  return sum / pi();
}

StretchRollingKernel::StretchRollingKernel(const RollingMaterial& material, int digits)
    : RollingKernel(material.normal, digits, SmoothKernel(I3_interval, digits + digits_of_slope, I3_shape)),
      theta2_at_once_(material.theta2_at_once),
      theta2_(material.theta2) {
  for (const RollingMemory& term : memory()) fading_.emplace_back(term.rate, digits, ComplexFloat(), -far());
}

ComplexFloat StretchRollingKernel::faded(std::size_t term, const Float& x) {
  return fading_[term](x, [&](const Float& at) { return smooth().slope(at); });
}

Float StretchRollingKernel::left_by_theta2(const Float& x) const {
  Float sum = 0;
  for (const auto& [amplitude, rate] : theta2_) sum += (amplitude * exp(-(rate * x))).re;
  return pi() * sum;
}

Float StretchRollingKernel::direct(const Float& x) {
  Float sum = x > 0 ? left_by_theta2(x) : Float(0);
  sum -= smooth().slope(x);
  for (std::size_t r = 0; r < memory().size(); ++r) sum -= (memory()[r].amplitude * faded(r, x)).re;
  return sum / pi();
}

Float StretchRollingKernel::far_downstream(const Float& x) {
  const Float from(far());
  Float sum = left_by_theta2(x);
  for (std::size_t r = 0; r < memory().size(); ++r) {
    const auto& [amplitude, rate] = memory()[r];
    sum -= (amplitude * faded(r, from) * exp(-(rate * (x - from)))).re;
  }
  return sum / pi();
}

}  // namespace nipref::ref
