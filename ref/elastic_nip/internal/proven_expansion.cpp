#include <cmath>
#include <numbers>

#include <nipref/ref/elastic_nip/internal/proven_expansion.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

/// A sinh(tau) that makes C e^{-2n tau} smallest, or nearly so.
double strip_height(double half_length, int size) { return std::max(1.0, 2 - half_length / size); }

double log_of_Q(double y) { return std::log(2 / (2 - y) + 4 / ((2 - y) * (2 - y))); }

/// The bounds (2) for one tau.
class Decay {
 public:
  Decay(const Interval& half_length, int size)
      : size_(size), amplitude_(half_length.precision()), rate_(amplitude_) {
    const Interval bound = upper(half_length);
    const Interval height(strip_height(mpfr_get_d(bound.upper(), MPFR_RNDU), size), half_length.precision());
    const Interval slope = height / bound;
    const Interval cosh_tau = sqrt(square(slope) + 1);
    const Interval left = 2 - height;
    amplitude_ = 2 * (bound * cosh_tau * (2 / left + 4 / square(left)));
    rate_ = log(slope + cosh_tau);
  }

  [[nodiscard]] const Interval& amplitude() const { return amplitude_; }
  /// e^{-k tau}
  [[nodiscard]] Interval power(long k) const { return exp(-(k * rate_)); }
  /// sum over m >= size of mu e^{-mu tau/halves}
  [[nodiscard]] Interval tail(long halves) const {
    const Interval rate = rate_ / halves;
    const Interval first = exp(-((2L * size_ + 1) * rate));
    const Interval gap = -expm1(-(2 * rate));
    return first * ((2L * size_ + 1) / gap + 2 / square(gap));
  }

 private:
  static Interval upper(const Interval& x) { return interval_of(upper_end(x)); }

  int size_;
  Interval amplitude_;
  Interval rate_;
};

Interval sqrt_of(long x, mpfr_prec_t precision) { return sqrt(Interval(x, precision)); }

struct Residual {
  Interval norm;      ///< in l2, of the rows m < n with the values at the nodes taken as exact
  Interval node_sum;  ///< sum_i |y_i|
  Interval size;      ///< sum_m |x_m|
};

/// sum += x y
void add_product(Interval& sum, Interval& scratch, const Interval& x, const Interval& y) {
  mpfi_mul(scratch.get(), x.get(), y.get());
  mpfi_add(sum.get(), sum.get(), scratch.get());
}
void add_product(Interval& sum, Interval& scratch, const Interval& x, const Float& y) {
  mpfi_mul_fr(scratch.get(), x.get(), raw(y));
  mpfi_add(sum.get(), sum.get(), scratch.get());
}

/// sum_m cos(mu theta_i) x_m, its own inverse but for a factor n/2.
std::vector<Interval> cosine_transform(const ChebyshevSystem& system, const std::vector<Interval>& x) {
  const long n = system.size();
  std::vector<Interval> result;
  Interval scratch(working_bits());
  for (long i = 0; i < n; ++i) {
    Interval sum(working_bits());
    for (long m = 0; m < n; ++m) {
      add_product(sum, scratch, x[static_cast<std::size_t>(m)], system.cosines()((2 * m + 1) * (2 * i + 1)));
    }
    result.push_back(sum);
  }
  return result;
}

std::vector<Interval> odd_part_times(const ChebyshevSystem& system, const std::vector<Interval>& y) {
  std::vector<Interval> result;
  Interval scratch(working_bits());
  for (int i = 0; i < system.size(); ++i) {
    Interval sum(working_bits());
    for (int j = 0; j < system.size(); ++j) {
      add_product(sum, scratch, y[static_cast<std::size_t>(j)], system.odd_part(i, j));
    }
    result.push_back(sum);
  }
  return result;
}

Residual residual_of(const ChebyshevSystem& system, const Vector& coefficients) {
  const mpfr_prec_t precision = working_bits();
  const long n = system.size();
  Residual result{Interval(precision), Interval(precision), Interval(precision)};
  std::vector<Interval> weighted;
  for (long m = 0; m < n; ++m) {
    const Interval c = interval_of(coefficients(m));
    weighted.push_back((2 * m + 1) * c);
    result.size = result.size + sqrt_of(2 * m + 1, precision) * magnitude_of(c);
  }
  const std::vector<Interval> at_nodes = cosine_transform(system, weighted);
  for (const Interval& y : at_nodes) result.node_sum = result.node_sum + magnitude_of(y);
  const std::vector<Interval> smooth = cosine_transform(system, odd_part_times(system, at_nodes));
  Interval sum(precision);
  for (long m = 0; m < n; ++m) {
    Interval row = interval_of(coefficients(m)) + 2 * smooth[static_cast<std::size_t>(m)] / (n * n);
    if (m == 0) row = row - 1;
    sum = sum + (2 * m + 1) * square(row);
  }
  result.norm = sqrt(sum);
  return result;
}

}  // namespace

Interval coercivity(const Interval& half_length) {
  constexpr int steps = 16;
  Interval best(half_length.precision());
  for (int k = 1; k < steps; ++k) {
    const Interval z = Interval(2L * k, half_length.precision()) / steps;
    const Interval twice = 2 * z / half_length;
    const Interval kept = (cosh(twice) - 1) / (sinh(twice) + twice);
    const Interval value = kept * (1 - square(z) / 4);
    if (mpfr_greater_p(value.lower(), best.lower()) != 0) best = value;
  }
  return best;
}

Interval entry_bound(const Interval& half_length, int size, long mu) {
  const Decay decay(half_length, size);
  return decay.amplitude() * decay.power(mu);
}

ProvenExpansion prove(const ChebyshevSystem& system, const Vector& coefficients,
                      const Interval& half_length) {
  const long n = system.size();
  const mpfr_prec_t precision = working_bits();
  const Residual residual = residual_of(system, coefficients);
  const Decay decay(half_length, system.size());
  // Arguments of J are rounded; and the system's own half length is not all of the interval.
  const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
  const Interval entry_error =
      interval_of(system.kernel_error()) + argument_units * ((half_length + 1) * unit);
  const Interval moved = distance_from(system.half_length(), half_length) / half_length;
  const Interval first = decay.power(2 * n + 1);
  const Interval folded = 8 * (sqrt_of(n, precision) * first / square(1 - decay.power(2 * n)));
  const Interval beyond = first / sqrt(1 - decay.power(4));
  const Interval norm = residual.norm + 2 * (entry_error * residual.node_sum) +
                        residual.size * (moved + decay.amplitude() * (folded + beyond));
  const Interval energy_radius = magnitude_of(norm / coercivity(half_length));
  const Interval radius =
      n * energy_radius + decay.amplitude() * (residual.size * decay.tail(1) +
                                               energy_radius * decay.tail(2) / sqrt(1 - decay.power(2)));
  const Interval quadrature_error = Interval::pi(precision) * decay.amplitude() * residual.size *
                                    decay.power(2 * n) / (1 - decay.power(4 * n));
  ProvenExpansion result{
      half_length, {}, magnitude_of(radius), energy_radius, magnitude_of(quadrature_error)};
  for (long m = 0; m < n; ++m) result.coefficients.push_back(coefficients(m));
  return result;
}

int size_for(double half_length, int digits) {
  const double wanted = digits * std::numbers::ln10;
  // lambda is about 1/(1 + 3 A), the sum of the unknowns about 1 + A.
  const double size = std::log((1 + 3 * half_length) * (1 + half_length) * 2 * half_length);
  int n = 3;
  while (true) {
    const double height = strip_height(half_length, n);
    const double tau = std::asinh(height / half_length);
    const double reached = 2 * n * tau - size - log_of_Q(height) - std::log(std::cosh(tau)) -
                           1.5 * std::log(n) - std::log(8 / std::pow(-std::expm1(-2 * n * tau), 2));
    if (reached >= wanted) return n;
    n += 1 + n / 64;
  }
}

}  // namespace nipref::ref
