#include <limits>
#include <stdexcept>
#include <utility>

#include <nipref/ref/elastic_nip/internal/end_shear.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {
namespace {

constexpr int faster_waves = 2;

Float slowest_rate(const Float& k) {
  const auto zero = bracketed_root<Float>([&](const Float& x) -> Float { return k * sin(x) - x; },
                                          Float(sqrt(6 * (1 - 1 / k)) * 99 / 100), pi(),
                                          4 * std::numeric_limits<Float>::epsilon());
  if (!zero) throw std::logic_error("a slowest wave that is not found");
  return *zero / 2;
}

/// By Newton's method from where sin x is about e^(-i x) i/2.
ComplexFloat faster_rate(const Float& k, int number) {
  const Float start = (2 * number + Float(0.5)) * pi();
  ComplexFloat x(start, log(2 * start / k));
  for (int step = 0; step < 100; ++step) {
    const Float up = cosh(x.im), down = sinh(x.im);
    const ComplexFloat sine(sin(x.re) * up, cos(x.re) * down), cosine(cos(x.re) * up, -sin(x.re) * down);
    const ComplexFloat change = (sine * k - x) / (cosine * k - ComplexFloat(1));
    x = x - change;
    if (abs(change) < sqrt(std::numeric_limits<Float>::epsilon())) return x / Float(2);
  }
  throw std::logic_error("a fast wave that is not found");
}

}  // namespace

GripWaves::GripWaves(const Float& poisson) : slowest(slowest_rate(3 - 4 * poisson)) {
  for (int i = 1; i <= faster_waves; ++i) faster.push_back(faster_rate(3 - 4 * poisson, i));
}

EndShear::EndShear(GripExpansion contact, double half_length, const Float& poisson, const GripWaves& waves)
    : contact_(std::move(contact)),
      half_length_(half_length),
      slope_(-4 * poisson * (1 - poisson) / (1 - 2 * poisson)),
      waves_(waves) {
  // The shear less the slope of the strip between the ends, at points close enough to the end to separate the waves.
  const long count = 1 + 2 * faster_waves;
  Matrix matrix(count, count);
  Vector right(count);
  for (long i = 0; i < count; ++i) {
    const double y = 0.5 * static_cast<double>(i + 1);
    const std::vector<Float> near = waves_at(half_length_ - y), far = waves_at(half_length_ + y);
    for (long k = 0; k < count; ++k)
      matrix(i, k) = near[static_cast<std::size_t>(k)] - far[static_cast<std::size_t>(k)];
    right(i) = in_contact(y) - slope_ * y;
  }
  const Vector solved = solve(matrix, right);
  for (long k = 0; k < count; ++k) sizes_.push_back(solved(k));
}

Float EndShear::in_contact(double y) const { return contact_.traction(1 - y / Float(half_length_)).shear; }

std::vector<Float> EndShear::waves_at(const Float& distance) const {
  std::vector<Float> waves{exp(-waves_.slowest * distance)};
  for (const ComplexFloat& rate : waves_.faster) {
    const ComplexFloat wave = exp(-(rate * distance));
    waves.push_back(wave.re);
    waves.push_back(wave.im);
  }
  return waves;
}

Float EndShear::sum_of_waves_at(const Float& distance) const {
  const std::vector<Float> waves = waves_at(distance);
  Float sum = 0;
  for (std::size_t k = 0; k < waves.size(); ++k) sum += sizes_[k] * waves[k];
  return sum;
}

Float EndShear::slow_wave_at(const Float& distance) const {
  return sizes_[0] * exp(-waves_.slowest * distance);
}

Float EndShear::at(double s) const {
  if (s < half_length_ - 1)
    return in_contact(half_length_ - s) + sum_of_waves_at(2 * Float(half_length_) - s);
  return slope_ * (half_length_ - Float(s)) + sum_of_waves_at(s);
}

}  // namespace nipref::ref
