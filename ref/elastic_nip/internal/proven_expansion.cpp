#include <nipref/ref/elastic_nip/internal/proven_expansion.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

/// sum over m >= size of mu e^{-mu tau/halves}
Interval tail(const EntryBounds& decay, long size, long halves) {
  const Interval rate = decay.rate / halves;
  const Interval first = exp(-((2 * size + 1) * rate));
  const Interval gap = -expm1(-(2 * rate));
  return first * ((2 * size + 1) / gap + 2 / square(gap));
}

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

ProvenExpansion prove(const ChebyshevSystem& system, const Vector& coefficients,
                      const Interval& half_length) {
  const long n = system.size();
  const mpfr_prec_t precision = working_bits();
  const Residual residual = residual_of(system, coefficients);
  const EntryBounds decay = entry_bounds(half_length, system.size());
  // Arguments of J are rounded; and the system's own half length is not all of the interval.
  const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
  const Interval entry_error =
      interval_of(system.kernel_error()) + argument_units * ((half_length + 1) * unit);
  const Interval moved = distance_from(system.half_length(), half_length) / half_length;
  const Interval first = decay.power(2 * n + 1);
  const Interval folded = 8 * (sqrt_of(n, precision) * first / square(1 - decay.power(2 * n)));
  const Interval beyond = first / sqrt(1 - decay.power(4));
  const Interval norm = residual.norm + 2 * (entry_error * residual.node_sum) +
                        residual.size * (moved + decay.amplitude * (folded + beyond));
  const Interval energy_radius = magnitude_of(norm / coercivity(half_length));
  const Interval radius =
      n * energy_radius + decay.amplitude * (residual.size * tail(decay, n, 1) +
                                             energy_radius * tail(decay, n, 2) / sqrt(1 - decay.power(2)));
  const Interval quadrature_error = Interval::pi(precision) * decay.amplitude * residual.size *
                                    decay.power(2 * n) / (1 - decay.power(4 * n));
  ProvenExpansion result{
      half_length, {}, magnitude_of(radius), energy_radius, magnitude_of(quadrature_error)};
  for (long m = 0; m < n; ++m) {
    result.coefficients.emplace_back(precision);
    result.coefficients.push_back(interval_of(coefficients(m)));
  }
  return result;
}

}  // namespace nipref::ref
