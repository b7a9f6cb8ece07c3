#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/ref/nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>

namespace nipref::ref {
namespace {

using ref::add_product;
void add_product(Interval& sum, Interval& scratch, const Interval& x, const Float& y) {
  mpfi_mul_fr(scratch.get(), x.get(), raw(y));
  mpfi_add(sum.get(), sum.get(), scratch.get());
}
void add_product(Interval& sum, Interval& scratch, const Interval& x, const Interval& y) {
  mpfi_mul(scratch.get(), x.get(), y.get());
  mpfi_add(sum.get(), sum.get(), scratch.get());
}

template <class Number>
Number zero_of() {
  if constexpr (std::is_same_v<Number, Float>) return {};
  if constexpr (std::is_same_v<Number, Interval>) return Interval(working_bits());
}

Interval sqrt_of(long x) { return sqrt(Interval(x, working_bits())); }

std::size_t at(long m) { return static_cast<std::size_t>(m); }

/// The place of an entry in a lower triangle.
std::size_t place(int i, int j) {
  const auto [low, high] = std::minmax(i, j);
  return at(high) * at(high + 1) / 2 + at(low);
}

}  // namespace

SlopeSeries SlopeSeries::line(int size) {
  SlopeSeries series{std::vector(at(2L * size), Interval(working_bits())), Interval(working_bits())};
  series.coefficients[1] = Interval(1L, working_bits());
  return series;
}

std::vector<ChebyshevSystem> ChebyshevSystem::of_half_length(const Float& half_length, int size,
                                                             SmoothKernel& kernel, bool both) {
  Nodes nodes{Cosines(2L * size, working_bits()), {}};
  for (long k = 0; k < 8L * size; ++k) nodes.middles.push_back(middle_of(nodes.cosines(k)));
  std::vector<Float> places, odd, even;
  for (int i = 0; i < size; ++i) places.push_back(half_length * nodes.middles[at(2L * i + 1)]);
  odd.reserve(place(size - 1, size - 1) + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Float minus = kernel(places[i] - places[j]), plus = kernel(places[i] + places[j]);
      odd.push_back(ldexp(minus - plus, -1));
      if (both) even.push_back(ldexp(minus + plus, -1));
    }
  }
  const auto shared = std::make_shared<const Nodes>(std::move(nodes));
  std::vector<ChebyshevSystem> systems;
  systems.push_back(ChebyshevSystem(true, half_length, size, shared, std::move(odd), kernel.error()));
  if (both)
    systems.push_back(ChebyshevSystem(false, half_length, size, shared, std::move(even), kernel.error()));
  return systems;
}

/// cos(k pi/(4n)) in intervals, or their middles.
template <>
const Interval& ChebyshevSystem::cosine<Interval>(long k) const {
  return nodes_->cosines(k);
}
template <>
const Float& ChebyshevSystem::cosine<Float>(long k) const {
  return nodes_->middles[at(k % (8L * size_))];
}

ChebyshevSystem::ChebyshevSystem(bool is_odd, const Float& half_length, int size,
                                 std::shared_ptr<const Nodes> nodes, std::vector<Float> part,
                                 const Float& kernel_error)
    : is_odd_(is_odd),
      half_length_(half_length),
      size_(size),
      nodes_(std::move(nodes)),
      part_(std::move(part)),
      kernel_error_(kernel_error) {
  Eigen::MatrixXd cosines(size, unknowns()), kernel(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) kernel(i, j) = static_cast<double>(this->part(i, j));
    for (Vector::Index k = 0; k < unknowns(); ++k)
      cosines(i, k) = static_cast<double>(cosine<Float>((first() + 2 * k) * (2L * i + 1)));
  }
  Eigen::MatrixXd system = cosines.transpose() * (kernel * cosines);
  for (Vector::Index k = 0; k < unknowns(); ++k) {
    system.col(k) *= 2 * static_cast<double>(first() + 2 * k) / (static_cast<double>(size) * size);
    system(k, k) += 1;
  }
  eliminated_.compute(system);
}

const Float& ChebyshevSystem::part(int i, int j) const { return part_[place(i, j)]; }

/// (1/2) sum_k g_mk k c_k is 2/n^2 of `smooth`, whose m = 0 is there of even m.
template <class Number>
ChebyshevSystem::Applied<Number> ChebyshevSystem::applied_to(const std::vector<Number>& coefficients) const {
  Applied<Number> result{std::vector(at(size_), zero_of<Number>()),
                         std::vector(at(end()), zero_of<Number>())};
  std::vector<Number> weighted(at(end()), zero_of<Number>()), kernel_times(at(size_), zero_of<Number>());
  Number scratch = zero_of<Number>();
  for (long m = first(); m < end(); m += 2) weighted[at(m)] = m * coefficients[at(m)];
  for (long i = 0; i < size_; ++i)
    for (long m = first(); m < end(); m += 2)
      add_product(result.at_nodes[at(i)], scratch, weighted[at(m)], cosine<Number>(m * (2 * i + 1)));
  for (int i = 0; i < size_; ++i)
    for (int j = 0; j < size_; ++j)
      add_product(kernel_times[at(i)], scratch, result.at_nodes[at(j)], part(i, j));
  for (long m = is_odd_ ? 1 : 0; m < end(); m += 2)
    for (long i = 0; i < size_; ++i)
      add_product(result.smooth[at(m)], scratch, kernel_times[at(i)], cosine<Number>(m * (2 * i + 1)));
  return result;
}

std::vector<Float> ChebyshevSystem::solution(const SlopeSeries& right) const {
  const auto spread = [&](const Vector& x) {
    std::vector<Float> c(at(end()));
    for (Vector::Index k = 0; k < x.size(); ++k) c[at(first() + 2 * k)] = x(k);
    return c;
  };
  const auto apply = [&](const Vector& x) {
    const std::vector<Float> smooth = applied_to(spread(x)).smooth;
    Vector result = x;
    for (Vector::Index k = 0; k < x.size(); ++k)
      result(k) += 2 * smooth[at(first() + 2 * k)] / (Float(size_) * size_);
    return result;
  };
  Vector wanted(unknowns());
  for (Vector::Index k = 0; k < wanted.size(); ++k)
    wanted(k) = middle_of(right.coefficients[at(first() + 2 * k)]);
  // No proof relies on it, as proven() bounds what it leaves.
  return spread(refined_solution(eliminated_, wanted, apply).value_or(Vector(unknowns())));
}

BoundedColumn ChebyshevSystem::proven(const std::vector<Float>& coefficients, const SlopeSeries& right,
                                      const Interval& half_length) const {
  const long n = size_, rest = is_odd_ ? 2 * n + 1 : 2 * n;  // the first m of the rows that are not computed
  const mpfr_prec_t bits = working_bits();
  std::vector<Interval> c;
  Interval unknowns(bits), sum(bits);  // sum |x_m|
  for (long m = 0; m < end(); ++m) {
    c.push_back(interval_of(coefficients[at(m)]));
    unknowns = unknowns + sqrt_of(m) * magnitude_of(c.back());
  }
  const auto [at_nodes, smooth] = applied_to(c);
  const Interval node_sum = sum_of_magnitudes(at_nodes);
  for (long m = first(); m < end(); m += 2)
    sum = sum + m * square(c[at(m)] + 2 * smooth[at(m)] / (n * n) - right.coefficients[at(m)]);
  // Arguments of J are rounded; and the system's own half length is not all of the interval.
  const EntryBounds decay = entry_bounds(half_length, size_);
  const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
  const Interval entry_error = interval_of(kernel_error_) + argument_units * ((half_length + 1) * unit);
  const Interval apart = distance_from(half_length_, half_length);
  const Interval first_power = decay.power(rest);
  const Interval folded = sqrt_of(n) * folded_entries(decay, 2 * n, rest);
  const Interval beyond = first_power / sqrt(1 - decay.power(4));
  const Interval norm = sqrt(sum) + 2 * (entry_error * node_sum) + sqrt_of(4 * n) * right.next +
                        unknowns * (apart / half_length + folded + decay.amplitude * beyond);
  const Interval energy_radius = magnitude_of(norm / coercivity(half_length, frictionless_stiffness));
  const Interval radius =
      n * energy_radius + 8 * n * right.next +
      decay.amplitude * (unknowns * tail(decay.rate, rest) +
                         energy_radius * tail(decay.rate / 2, rest) / sqrt(1 - decay.power(2)));
  const Interval quadrature_error =
      Interval::pi(bits) * decay.amplitude * unknowns * decay.power(2 * n) / (1 - decay.power(4 * n));
  const Interval constant_error =
      folded * unknowns + (entry_error + 4 * apart) * node_sum / n + 4 * half_length * radius;
  const Interval constant =
      is_odd_ ? Interval(bits) : (-smooth[0] / (n * n)).widened(magnitude_of(constant_error));
  return {{half_length, std::move(c), magnitude_of(radius), energy_radius, magnitude_of(quadrature_error)},
          constant};
}

std::vector<BoundedColumn> solved(const std::vector<ChebyshevSystem>& systems,
                                  const std::vector<SlopeSeries>& right, const Interval& half_length) {
  std::vector<BoundedColumn> columns;
  for (const SlopeSeries& series : right) {
    BoundedColumn column = systems[0].proven(systems[0].solution(series), series, half_length);
    const BoundedColumn even = systems[1].proven(systems[1].solution(series), series, half_length);
    for (std::size_t m = 0; m < column.coefficients.size(); m += 2)
      column.coefficients[m] = even.coefficients[m];
    column.radius = column.radius + even.radius;
    column.energy_radius = column.energy_radius + even.energy_radius;
    column.quadrature_error = column.quadrature_error + even.quadrature_error;
    column.constant = even.constant;
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace nipref::ref
