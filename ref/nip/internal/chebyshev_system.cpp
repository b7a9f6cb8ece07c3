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

/// The index of the entry (i, j) or (j, i) in a lower triangle stored by rows.
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

ChebyshevSystem::ChebyshevSystem(const Float& half_length, int size, SmoothKernel& kernel, bool both)
    : half_length_(half_length), size_(size), cosines_(2L * size, working_bits()) {
  for (long k = 0; k < 8L * size; ++k) middles_.push_back(middle_of(cosines_(k)));
  std::vector<Float> places, odd, even;
  for (int i = 0; i < size; ++i) places.push_back(half_length * middles_[at(2L * i + 1)]);
  odd.reserve(place(size - 1, size - 1) + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Float minus = kernel(places[i] - places[j]), plus = kernel(places[i] + places[j]);
      odd.push_back(ldexp(minus - plus, -1));
      if (both) even.push_back(ldexp(minus + plus, -1));
    }
  }
  kernel_error_ = kernel.error();
  parities_.push_back({1, std::move(odd), {}});
  if (both) parities_.push_back({2, std::move(even), {}});
  for (Parity& parity : parities_) eliminate(parity);
}

/// cos(k pi/(4n)) as an interval, or the midpoint of that interval.
template <>
const Interval& ChebyshevSystem::cosine<Interval>(long k) const {
  return cosines_(k);
}
template <>
const Float& ChebyshevSystem::cosine<Float>(long k) const {
  return middles_[at(k % (8L * size_))];
}

void ChebyshevSystem::eliminate(Parity& parity) const {
  const Vector::Index count = unknowns(parity);
  Eigen::MatrixXd cosines(size_, count), kernel(size_, size_);
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) kernel(i, j) = static_cast<double>(parity.part(i, j));
    for (Vector::Index k = 0; k < count; ++k)
      cosines(i, k) = static_cast<double>(cosine<Float>((parity.first + 2 * k) * (2L * i + 1)));
  }
  Eigen::MatrixXd system = cosines.transpose() * (kernel * cosines);
  for (Vector::Index k = 0; k < count; ++k) {
    system.col(k) *= 2 * static_cast<double>(parity.first + 2 * k) / (static_cast<double>(size_) * size_);
    system(k, k) += 1;
  }
  parity.eliminated.compute(system);
}

const Float& ChebyshevSystem::Parity::part(int i, int j) const { return lower_triangle[place(i, j)]; }

/// (1/2) sum_k g_mk k c_k is 2/n^2 times smooth[m]. The system of even m has m = 0 as well.
template <class Number>
ChebyshevSystem::Applied<Number> ChebyshevSystem::applied_to(const Parity& parity,
                                                             const std::vector<Number>& coefficients) const {
  Applied<Number> result{std::vector(at(size_), zero_of<Number>()),
                         std::vector(at(end()), zero_of<Number>())};
  std::vector<Number> weighted(at(end()), zero_of<Number>()), kernel_times(at(size_), zero_of<Number>());
  Number scratch = zero_of<Number>();
  for (long m = parity.first; m < end(); m += 2) weighted[at(m)] = m * coefficients[at(m)];
  for (long i = 0; i < size_; ++i)
    for (long m = parity.first; m < end(); m += 2)
      add_product(result.at_nodes[at(i)], scratch, weighted[at(m)], cosine<Number>(m * (2 * i + 1)));
  for (int i = 0; i < size_; ++i)
    for (int j = 0; j < size_; ++j)
      add_product(kernel_times[at(i)], scratch, result.at_nodes[at(j)], parity.part(i, j));
  for (long m = parity.first % 2; m < end(); m += 2)
    for (long i = 0; i < size_; ++i)
      add_product(result.smooth[at(m)], scratch, kernel_times[at(i)], cosine<Number>(m * (2 * i + 1)));
  return result;
}

std::vector<Float> ChebyshevSystem::solution(const SlopeSeries& right) const {
  std::vector<Float> c(at(end()));
  for (const Parity& parity : parities_) {
    const auto spread = [&](const Vector& x, std::vector<Float>& into) {
      for (Vector::Index k = 0; k < x.size(); ++k) into[at(parity.first + 2 * k)] = x(k);
    };
    const auto apply = [&](const Vector& x) {
      std::vector<Float> here(at(end()));
      spread(x, here);
      const std::vector<Float> smooth = applied_to(parity, here).smooth;
      Vector result = x;
      for (Vector::Index k = 0; k < x.size(); ++k)
        result(k) += 2 * smooth[at(parity.first + 2 * k)] / (Float(size_) * size_);
      return result;
    };
    Vector wanted(unknowns(parity));
    for (Vector::Index k = 0; k < wanted.size(); ++k)
      wanted(k) = middle_of(right.coefficients[at(parity.first + 2 * k)]);
    // No proof relies on this solution: proven() bounds its residual.
    if (const auto found = refined_solution(parity.eliminated, wanted, apply)) spread(*found, c);
  }
  return c;
}

BoundedColumn ChebyshevSystem::proven(const std::vector<Float>& coefficients, const SlopeSeries& right,
                                      const Interval& half_length) const {
  const long n = size_;
  const mpfr_prec_t bits = working_bits();
  std::vector<Interval> c;
  for (const Float& coefficient : coefficients) c.push_back(interval_of(coefficient));
  const Interval zero(bits);
  BoundedColumn result{{half_length, c, zero, zero, zero}, zero};
  const EntryBounds decay = entry_bounds(half_length, size_);
  const Interval lambda = coercivity(half_length, frictionless_stiffness);
  // The arguments of J are rounded, and the system has only one half length of the interval.
  const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
  const Interval entry_error = interval_of(kernel_error_) + argument_units * ((half_length + 1) * unit);
  const Interval length_error = distance_from(half_length_, half_length);
  for (const Parity& parity : parities_) {
    const long uncomputed = 2 * n + parity.first % 2;  // the first m whose row is not computed
    const auto [at_nodes, smooth] = applied_to(parity, c);
    const Interval node_sum = sum_of_magnitudes(at_nodes);
    Interval x_sum(bits), computed_square(bits);  // sum |x_m|, and |r|^2 of the computed rows
    for (long m = parity.first; m < end(); m += 2) {
      x_sum = x_sum + sqrt_of(m) * magnitude_of(c[at(m)]);
      computed_square =
          computed_square + m * square(c[at(m)] + 2 * smooth[at(m)] / (n * n) - right.coefficients[at(m)]);
    }
    // The f_m beyond have sum m f_m^2 <= 4n next^2 and sum m |f_m| <= 8n next, as each is at most half of the one
    // before. Over sum |x_m|: the residuals that another length, folded entries and the rows beyond make.
    const Interval other_length = length_error / half_length;
    const Interval folded = sqrt_of(n) * folded_entries(decay, 2 * n, uncomputed);
    const Interval beyond = decay.amplitude * (decay.power(uncomputed) / sqrt(1 - decay.power(4)));
    const Interval residual = sqrt(computed_square) + 2 * (entry_error * node_sum) +
                              sqrt_of(4 * n) * right.next + x_sum * (other_length + folded + beyond);
    const Interval energy_radius = magnitude_of(residual / lambda);
    const Interval radius =
        n * energy_radius + 8 * n * right.next +
        decay.amplitude * (x_sum * tail(decay.rate, uncomputed) +
                           energy_radius * tail(decay.rate / 2, uncomputed) / sqrt(1 - decay.power(2)));
    result.energy_radius = result.energy_radius + energy_radius;
    result.radius = result.radius + magnitude_of(radius);
    result.quadrature_error =
        result.quadrature_error + magnitude_of(Interval::pi(bits) * decay.amplitude * x_sum *
                                               decay.power(2 * n) / (1 - decay.power(4 * n)));
    if (parity.first == 1) continue;
    const Interval constant_error =
        folded * x_sum + (entry_error + 4 * length_error) * node_sum / n + 4 * half_length * radius;
    result.constant = (-smooth[0] / (n * n)).widened(magnitude_of(constant_error));
  }
  return result;
}

}  // namespace nipref::ref
