#include <algorithm>
#include <utility>

#include <nipref/ref/nip/internal/contact_bounds.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/viscoelastic_nip/internal/bounded_columns.hpp>

namespace nipref::ref {
namespace {

using Index = Matrix::Index;

void add_product(Float& sum, Float& scratch, const Float& x, const Float& y) {
  mpfr_mul(raw(scratch), raw(x), raw(y), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(scratch), MPFR_RNDN);
}
void add_product(Interval& sum, Interval& scratch, const Interval& x, const Float& y) {
  mpfi_mul_fr(scratch.get(), x.get(), raw(y));
  mpfi_add(sum.get(), sum.get(), scratch.get());
}
void add_product(Interval& sum, Interval& scratch, const Interval& x, const Interval& y) {
  mpfi_mul(scratch.get(), x.get(), y.get());
  mpfi_add(sum.get(), sum.get(), scratch.get());
}

template <class Number>
Number zero() {
  if constexpr (std::is_same_v<Number, Float>) return {};
  if constexpr (std::is_same_v<Number, Interval>) return Interval(working_bits());
}

Interval sqrt_of(long x) { return sqrt(Interval(x, working_bits())); }

}  // namespace

BoundedColumns::BoundedColumns(const Interval& half_length, int points, SmoothKernel& kernel)
    : half_length_(half_length),
      points_(points),
      cosines_(points, working_bits()),
      values_(static_cast<std::size_t>(points * points)) {
  for (long k = 0; k < 4L * points; ++k) middles_.push_back(middle_of(cosines_(k)));
  const Float A = middle_of(half_length);
  std::vector<Float> places;
  for (int i = 0; i < points; ++i) places.push_back(A * middle_of(cosines_(2L * i + 1)));
  // The matrix is symmetric about both of its diagonals.
  const int last = points - 1;
  for (int i = 0; i < points; ++i) {
    for (int j = i; i + j <= last; ++j) {
      const Float here = kernel(places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]);
      for (const auto& [row, column] :
           {std::pair(i, j), std::pair(j, i), std::pair(last - j, last - i), std::pair(last - i, last - j)})
        values_[static_cast<std::size_t>(row * points + column)] = here;
    }
  }
  const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
  entry_error_ = upper_end(interval_of(kernel.error()) + argument_units * ((half_length + 1) * unit) +
                           4 * distance_from(A, half_length));
}

/// sum_j J_ij y_j
template <class Number>
std::vector<Number> BoundedColumns::operator_on(const std::vector<Number>& at_nodes) const {
  std::vector<Number> result;
  Number scratch = zero<Number>();
  for (int i = 0; i < points_; ++i) {
    Number sum = zero<Number>();
    for (int j = 0; j < points_; ++j)
      add_product(sum, scratch, at_nodes[static_cast<std::size_t>(j)], value(i, j));
    result.push_back(sum);
  }
  return result;
}

/// cos(k pi/(2N)) in intervals, or their middles.
template <>
const Interval& BoundedColumns::cosine<Interval>(long k) const {
  return cosines_(k);
}
template <>
const Float& BoundedColumns::cosine<Float>(long k) const {
  return middles_[static_cast<std::size_t>(k % static_cast<long>(middles_.size()))];
}

/// sum_m cos(m theta_i) x_m, i = 0 .. N-1.
template <class Number>
std::vector<Number> BoundedColumns::at_nodes(const std::vector<Number>& x) const {
  std::vector<Number> result;
  Number scratch = zero<Number>();
  for (long i = 0; i < points_; ++i) {
    Number sum = zero<Number>();
    for (long m = 0; m < points_; ++m)
      add_product(sum, scratch, x[static_cast<std::size_t>(m)], cosine<Number>(m * (2 * i + 1)));
    result.push_back(sum);
  }
  return result;
}

/// sum_i cos(m theta_i) z_i, m = 0 .. N-1.
template <class Number>
std::vector<Number> BoundedColumns::coefficients_of(const std::vector<Number>& z) const {
  std::vector<Number> result;
  Number scratch = zero<Number>();
  for (long m = 0; m < points_; ++m) {
    Number sum = zero<Number>();
    for (long i = 0; i < points_; ++i)
      add_product(sum, scratch, z[static_cast<std::size_t>(i)], cosine<Number>(m * (2 * i + 1)));
    result.push_back(sum);
  }
  return result;
}

std::vector<BoundedColumn> BoundedColumns::solved(const std::vector<SlopeSeries>& right) const {
  constexpr int most_rounds = 60;
  const int n = points_;
  // In double, with unknowns sqrt(m) c_m, so that it is symmetric and positive definite.
  DenseMatrix<double> transform(n, n - 1), kernel(n, n);
  for (int i = 0; i < n; ++i) {
    for (int m = 1; m < n; ++m)
      transform(i, m - 1) = std::sqrt(m) * mpfi_get_d(cosines_(m * (2L * i + 1)).get());
    for (int j = 0; j < n; ++j) kernel(i, j) = static_cast<double>(value(i, j)) * 2 / (double(n) * n);
  }
  const Eigen::MatrixXd form =
      Eigen::MatrixXd::Identity(n - 1, n - 1) + Eigen::MatrixXd(transform.transpose()) * kernel * transform;
  const Eigen::LLT<Eigen::MatrixXd> factor(form);
  std::vector<BoundedColumn> columns;
  for (const SlopeSeries& series : right) {
    std::vector<Float> c(static_cast<std::size_t>(n));
    Float last_size = -1;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<Float> weighted;
      for (int m = 0; m < n; ++m) weighted.push_back(m * c[static_cast<std::size_t>(m)]);
      const std::vector<Float> smooth = coefficients_of(operator_on(at_nodes(weighted)));
      std::vector<Float> rest;
      Float size = 0;
      for (int m = 0; m < n; ++m) {
        const auto at = static_cast<std::size_t>(m);
        rest.push_back(
            m == 0 ? Float(0)
                   : Float(middle_of(series.coefficients[at]) - c[at] - 2 * smooth[at] / (Float(n) * n)));
        size = std::max<Float>(size, abs(rest.back()));
      }
      if (size == 0 || (round > 0 && !(size < last_size / 2))) break;
      last_size = size;
      Eigen::VectorXd scaled(n - 1);
      for (int m = 1; m < n; ++m)
        scaled(m - 1) = std::sqrt(m) * static_cast<double>(rest[static_cast<std::size_t>(m)] / size);
      factor.solveInPlace(scaled);
      for (int m = 1; m < n; ++m) c[static_cast<std::size_t>(m)] += size * scaled(m - 1) / std::sqrt(m);
    }
    columns.push_back(proven(c, series));
  }
  return columns;
}

BoundedColumn BoundedColumns::proven(const std::vector<Float>& coefficients, const SlopeSeries& right) const {
  const long n = points_;
  const mpfr_prec_t bits = working_bits();
  std::vector<Interval> weighted;
  Interval unknowns(bits);  // sum |x_m|, x_m = sqrt(m) c_m
  for (long m = 0; m < n; ++m) {
    const Interval c = interval_of(coefficients[static_cast<std::size_t>(m)]);
    weighted.push_back(m * c);
    unknowns = unknowns + sqrt_of(m) * magnitude_of(c);
  }
  const std::vector<Interval> slopes = at_nodes(weighted);
  Interval node_sum(bits);
  for (const Interval& y : slopes) node_sum = node_sum + magnitude_of(y);
  const std::vector<Interval> smooth = coefficients_of(operator_on(slopes));
  Interval sum(bits);
  for (long m = 1; m < n; ++m) {
    const auto at = static_cast<std::size_t>(m);
    const Interval row = interval_of(coefficients[at]) + 2 * smooth[at] / (n * n) - right.coefficients[at];
    sum = sum + m * square(row);
  }
  // The bounds (2) of the elastic contact, C and e^{-k tau}.
  const EntryBounds bounds = entry_bounds(half_length_, points_ / 2);
  const Interval first = bounds.power(n), gap = 1 - bounds.power(1), entry_error = interval_of(entry_error_);
  const Interval folded = 8 * bounds.amplitude * first / square(1 - first);
  const Interval beyond = bounds.amplitude * first / sqrt(1 - bounds.power(2));
  const Interval norm = sqrt(sum) + 2 * (entry_error * node_sum) + unknowns * (sqrt_of(n) * folded + beyond) +
                        sqrt_of(2 * n) * right.next;
  const Interval energy_radius = magnitude_of(norm / coercivity(half_length_));
  // sum over m >= N of m e^{-m tau}, and of m e^{-m tau/2}
  const Interval half_power = sqrt(bounds.power(1)), half_first = sqrt(first), half_gap = 1 - half_power;
  const Interval tail = first * (n / gap + 1 / square(gap)),
                 half_tail = half_first * (n / half_gap + 1 / square(half_gap));
  const Interval radius = n * energy_radius + 4 * n * right.next +
                          bounds.amplitude * (unknowns * tail + energy_radius * half_tail / sqrt(gap));
  const Interval known = smooth[0] / (n * n);
  const Interval constant_error = folded * unknowns + entry_error * node_sum / n + 4 * half_length_ * radius;
  return {coefficients, energy_radius, magnitude_of(radius), (-known).widened(magnitude_of(constant_error))};
}

}  // namespace nipref::ref
