#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

std::size_t at(long k) { return static_cast<std::size_t>(k); }

// The equations in double, Float or intervals. (ref/elastic_nip/README.md, Contacts with full friction, (2) and (3))
//
// The tractions are gamma = P + i Q = w sum_k alpha_k i^k T_k. Every coefficient below is a real number times a power
// of i, and only real numbers are stored: alpha_k; omega_j/i^j; phi_n/i^{1 - n}; and of the coefficients of sin(m
// theta) in gamma and of T_m in its slopes the real part for odd m, which belongs to P and u, or the imaginary part for
// even m, which belongs to Q and v. (The other parts are 0.)

/// The real or the imaginary part of i^m x, whichever is not 0: plus or minus x. That of i^{1 - m} x has the same sign.
template <class Number>
Number times_power_of_i(long m, const Number& x) {
  return (m & 2) != 0 ? Number(-x) : x;
}

template <class Number>
Number times(long m, const Number& x) {
  if constexpr (std::is_same_v<Number, double>) return static_cast<double>(m) * x;
  if constexpr (!std::is_same_v<Number, double>) return m * x;
}

/// The system of a contact of half length A, with the Chebyshev points t_i = cos((2i + 1) pi/(2N)), i < N.
template <class Number>
struct GrippedSystem {
  long size;                    ///< N, even
  Number zero, root, share;     ///< 0, sqrt(1 - beta^2) and 4/N^2
  std::vector<Number> cosines;  ///< cos(k pi/(2N)), k < 4N
  std::vector<Number> omegas;   ///< omega_j/i^j
  /// J, I3 and J - int I3 at A (t_i - t_j), with a row for each t_i > 0. The rows of -t_i follow by parity.
  std::vector<Number> normal, coupling, along;

  [[nodiscard]] const Number& cosine(long k) const {
    const long period = 4 * size;
    return cosines[at((k % period + period) % period)];
  }

  /// 4 phi_n/i^{1 - n} = sum_k (-1)^k alpha_k omega_{1+k-n}/i^{1+k-n} + sum_k alpha_k omega_{1-k-n}/i^{1-k-n}, where
  /// omega_j = 0 for j < 0.
  [[nodiscard]] Number four_phi(const std::vector<Number>& alpha, long n) const {
    Number sum = zero;
    for (long k = std::max(0L, n - 1); k < static_cast<long>(alpha.size()); ++k) {
      const Number term = alpha[at(k)] * omegas[at(1 + k - n)];
      sum = k % 2 == 0 ? Number(sum + term) : Number(sum - term);
    }
    for (long k = 0; k <= std::min(1 - n, static_cast<long>(alpha.size()) - 1); ++k)
      sum = sum + alpha[at(k)] * omegas[at(1 - n - k)];
    return sum;
  }

  /// c_m, from the coefficients sqrt(1 - beta^2) (phi_m - phi_{-m}) of sin(m theta) in gamma. As a multiple of
  /// i^{1 - m}, phi_{-m} is (-1)^m times the number that is stored for it.
  [[nodiscard]] std::vector<Number> sines(const std::vector<Number>& alpha) const {
    std::vector<Number> result(at(size), zero);
    for (long m = 1; m < size; ++m) {
      const Number plus = four_phi(alpha, m), minus = four_phi(alpha, -m);
      const Number difference = m % 2 == 0 ? Number(plus - minus) : Number(plus + minus);
      result[at(m)] = times_power_of_i(m, Number(root * difference / 4));
    }
    return result;
  }

  /// sum_j J p_j - I3 q_j, and sum_j I3 p_j + (J - int I3) q_j, at the points t_i > 0.
  [[nodiscard]] std::pair<std::vector<Number>, std::vector<Number>> smooth(
      const std::vector<Number>& p, const std::vector<Number>& q) const {
    std::vector<Number> u(at(size / 2), zero), v(at(size / 2), zero);
    for (long i = 0; i < size / 2; ++i) {
      for (long j = 0; j < size; ++j) {
        const std::size_t ij = at(i * size + j);
        u[at(i)] = u[at(i)] + normal[ij] * p[at(j)] - coupling[ij] * q[at(j)];
        v[at(i)] = v[at(i)] + coupling[ij] * p[at(j)] + along[ij] * q[at(j)];
      }
    }
    return {std::move(u), std::move(v)};
  }

  /// sum of m c_m cos(m theta_i) over m = first, first + 2, ..
  [[nodiscard]] std::vector<Number> node_sums(const std::vector<Number>& sines, long first) const {
    std::vector<Number> result(at(size), zero);
    for (long i = 0; i < size; ++i)
      for (long m = first; m < size; m += 2)
        result[at(i)] = result[at(i)] + times(m, sines[at(m)]) * cosine(m * (2 * i + 1));
    return result;
  }

  /// The coefficients of T_m in the slopes that the tractions cause, over -2A^2: those of -D gamma by (2), and the
  /// smooth part by (3).
  [[nodiscard]] std::vector<Number> slopes(const std::vector<Number>& alpha,
                                           const std::vector<Number>& sines) const {
    const auto [u, v] = smooth(node_sums(sines, 1), node_sums(sines, 2));
    std::vector<Number> result(at(size), zero);
    for (long m = 0; m < size; ++m) {
      Number sum = zero;
      for (long i = 0; i < size / 2; ++i) sum = sum + (m % 2 == 0 ? v : u)[at(i)] * cosine(m * (2 * i + 1));
      result[at(m)] = times_power_of_i(m, Number(root * four_phi(alpha, m) / 2)) + share * sum;
    }
    result[0] = result[0] / 2;
    return result;
  }
};

/// The system with the midpoints of its intervals in double or Float.
template <class Number>
GrippedSystem<Number> converted(const GrippedSystem<Interval>& from) {
  const auto one = [](const Interval& x) -> Number {
    if constexpr (std::is_same_v<Number, double>)
      return mpfi_get_d(x.get());
    else
      return middle_of(x);
  };
  const auto all = [&](const std::vector<Interval>& x) {
    std::vector<Number> result;
    for (const Interval& value : x) result.push_back(one(value));
    return result;
  };
  return {from.size,        one(from.zero),   one(from.root),     one(from.share), all(from.cosines),
          all(from.omegas), all(from.normal), all(from.coupling), all(from.along)};
}

/// The coefficients of (iy)^j in ((1 + y)/(1 - y))^{2 i epsilon} (1 - y^2)^{order}, j < count: eta_j/i^j of (6) with
/// the order 0, omega_j/i^j of (2) with the order 1.
std::vector<Interval> power_series(const Interval& epsilon, long order, long count) {
  std::vector<Interval> f{Interval(1L, epsilon.precision()), 4 * epsilon};
  for (long j = 1; j + 1 < count; ++j)
    f.push_back((4 * (epsilon * f[at(j)]) - (j - 1 - 2 * order) * f[at(j - 1)]) / (j + 1));
  return f;
}

/// Lambda of (6), 0 <= epsilon < 1/3.
Interval displacement_under_psi(const Interval& epsilon) {
  const mpfr_prec_t bits = epsilon.precision();
  const Interval ratio = 4 * square(epsilon);
  Interval sum = log(Interval(2L, bits)), power = ratio;  // (2 epsilon)^k
  long k = 2;
  for (; mpfr_cmp_d(power.upper(), std::ldexp(1.0, static_cast<int>(-bits))) > 0; k += 2) {
    Interval zeta(bits);
    mpfr_zeta_ui(&zeta.get()->left, at(k + 1), MPFR_RNDD);
    mpfr_zeta_ui(&zeta.get()->right, at(k + 1), MPFR_RNDU);
    Interval halves(1L, bits);
    mpfi_div_2ui(halves.get(), halves.get(), at(k));
    const Interval term = (2 - halves) * zeta * power;
    sum = (k & 2) != 0 ? sum - term : sum + term;
    power = power * ratio;
  }
  // The remainder, as (2 - 2^-k) zeta(k + 1) < 3.
  return sum.widened(3 * power / (1 - ratio));
}

/// The C' and tau of (3), for the entries of all kernels together; those of entry_bounds() are for J.
EntryBounds gripped_bounds(const Interval& half_length, long size) {
  EntryBounds bounds = entry_bounds(half_length, static_cast<int>(size));
  bounds.amplitude = bounds.amplitude * (half_length * cosh(bounds.rate) + 1);
  return bounds;
}

Interval gripped_coercivity(const Interval& half_length, const Interval& beta) {
  return coercivity(half_length, [&](const Interval& x) { return gripped_stiffness(x, beta); });
}

/// The size of an expansion, and the digits with which it is computed.
struct GrippedPlan {
  long size;
  int kernel_digits, working_digits;
};

/// Tractions and their coefficients are of the order (1 + A)^2. The smooth kernels amplify the residual's part in the
/// error of the tractions. Of all truncation errors, that of the coefficients c_m beyond N falls most slowly.
GrippedPlan plan_of(double half_length, double beta, int digits) {
  constexpr mpfr_prec_t coarse = 64;
  const Interval A(half_length, coarse);
  const auto digits_of = [](const Interval& x) { return std::log10(mpfr_get_d(x.upper(), MPFR_RNDU)); };
  const EntryBounds slow = gripped_bounds(A, 1);
  const double growth =
      digits_of(square(A + 1) * (slow.amplitude * square_tail(slow.rate / 2, 1) + 1) /
                (1 - square(Interval(beta, coarse))) / gripped_coercivity(A, Interval(beta, coarse)));
  const auto left_out = [&](long size) {
    const EntryBounds bounds = gripped_bounds(A, size);
    return digits_of(size * size * size * (bounds.amplitude * square_tail(bounds.rate, size)));
  };
  long size = 8;
  while (left_out(size) + growth > -digits - 2) size += 2 * (1 + size / 64);
  const int kernel = digits + 3 + static_cast<int>(std::ceil(growth + 3 * std::log10(size)));
  return {size, kernel, kernel + 8};
}

class GrippedContact final : public ProvenResults {
 public:
  GrippedContact(const Interval& half_length, const Exact& beta, long size,
                 std::shared_ptr<SheetKernels> kernels)
      : size_(size),
        A_(half_length),
        beta_(beta, working_bits()),
        epsilon_((log(beta_ + 1) - log(1 - beta_)) / (2 * Interval::pi(working_bits()))),
        offset_(working_bits()),
        kernels_(std::move(kernels)) {
    const GrippedSystem<Interval> system = assembled();
    solve(system);
    prove(system);
  }

  [[nodiscard]] const Interval& half_length() const override { return A_; }
  [[nodiscard]] const Interval& offset() const override { return offset_; }
  [[nodiscard]] Interval lever() const override { return offset_; }
  [[nodiscard]] Interval edge_displacement() const override { return edge_displacement_; }
  [[nodiscard]] Interval load() const override { return Interval::pi(working_bits()) * square(A_) * first_; }
  [[nodiscard]] Interval pressure(const SurfacePoint& place) const override { return traction(place, false); }
  [[nodiscard]] Interval shear(const SurfacePoint& place) const override { return traction(place, true); }
  [[nodiscard]] std::optional<Interval> normal(const SurfacePoint& place) const override {
    if (mpfr_sgn(place.before_end.lower()) < 0) return std::nullopt;
    return edge_displacement_ + square(A_) * (place.before_end * (2 - place.before_end));
  }
  [[nodiscard]] std::optional<Interval> tangential(const SurfacePoint& place) const override {
    if (mpfr_sgn(place.before_end.lower()) < 0) return std::nullopt;
    const Interval away = 2 * square(A_) * creep_ * (1 - place.before_end);
    return place.is_trailing ? -away : away;
  }
  [[nodiscard]] std::optional<Interval> strain(const SurfacePoint& place) const override {
    if (mpfr_sgn(place.before_end.lower()) < 0) return std::nullopt;
    return 2 * A_ * creep_;
  }
  [[nodiscard]] std::optional<Interval> peak_pressure() const override { return peak(false); }
  [[nodiscard]] std::optional<Interval> peak_shear() const override { return peak(true); }
  [[nodiscard]] int terms() const override { return static_cast<int>(size_); }
  [[nodiscard]] KernelValues kernel_values() const override { return kernels_->values(); }

 private:
  [[nodiscard]] GrippedSystem<Interval> assembled() {
    const long N = size_;
    const mpfr_prec_t bits = working_bits();
    const Cosines cosines(N, bits);
    GrippedSystem<Interval> system{
        N, Interval(bits), sqrt(1 - square(beta_)), Interval(4L, bits) / (N * N), {}, {}, {}, {}, {}};
    for (long k = 0; k < 4 * N; ++k) system.cosines.push_back(cosines(k));
    system.omegas = power_series(epsilon_, 1, 2 * N);
    const Float A = middle_of(A_);
    std::vector<Float> places;
    for (long i = 0; i < N; ++i) places.push_back(A * middle_of(cosines(2 * i + 1)));
    for (long i = 0; i < N / 2; ++i) {
      for (long j = 0; j < N; ++j) {
        const Float alpha = places[at(i)] - places[at(j)];
        system.normal.push_back(interval_of(kernels_->smooth_normal(alpha)));
        system.coupling.push_back(i == j ? Interval(bits) : interval_of(kernels_->coupling(alpha)));
        system.along.push_back(system.normal.back() + interval_of(kernels_->stretch(alpha)));
      }
    }
    return system;
  }

  /// Solves by iterative refinement in Float. No proof relies on the solution: prove() bounds its residual.
  void solve(const GrippedSystem<Interval>& system) {
    const long unknowns = size_ - 1;
    const auto in_double = converted<double>(system);
    const auto in_float = converted<Float>(system);
    DenseMatrix<double> matrix(unknowns, unknowns);
    for (long k = 0; k < unknowns; ++k) {
      std::vector<double> unit(at(unknowns), 0.0);
      unit[at(k)] = 1;
      const std::vector<double> slopes = in_double.slopes(unit, in_double.sines(unit));
      for (long m = 0; m < unknowns; ++m) matrix(m, k) = slopes[at(m + 1)];
    }
    const auto apply = [&](const Vector& x) {
      const std::vector<Float> alpha(x.data(), x.data() + unknowns);
      const std::vector<Float> slopes = in_float.slopes(alpha, in_float.sines(alpha));
      Vector result(unknowns);
      for (long m = 0; m < unknowns; ++m) result(m) = slopes[at(m + 1)];
      return result;
    };
    Vector right(unknowns);
    right(0) = 1;
    const std::optional<Vector> solution = refined_solution(EliminatedInDouble(matrix), right, apply);
    for (long k = 0; k < unknowns; ++k)
      alpha_.push_back(solution ? interval_of((*solution)(k)) : Interval(working_bits()));
  }

  /// Computes the bounds of (4) and (5): of |dx|, of max |f'|, and of the error of the creep.
  void prove(const GrippedSystem<Interval>& system) {
    const long N = size_;
    const std::vector<Interval> sines = system.sines(alpha_), slopes = system.slopes(alpha_, sines);
    Interval residual(working_bits()), unknowns(working_bits());
    for (long m = 1; m < N; ++m) {
      residual = residual + m * m * magnitude_of(m == 1 ? 1 - slopes[at(m)] : slopes[at(m)]);
      unknowns = unknowns + sqrt(Interval(m, working_bits())) * magnitude_of(sines[at(m)]);
    }
    // The errors of the kernels' values: their own, those of rounded arguments, and those of an A that is an interval.
    const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
    const Interval entry_error =
        kernels_->error() + 3 * (argument_units * ((A_ + 1) * unit) + 4 * distance_from(middle_of(A_), A_));
    const Interval node_sum =
        sum_of_magnitudes(system.node_sums(sines, 1)) + sum_of_magnitudes(system.node_sums(sines, 2));
    const EntryBounds decay = gripped_bounds(A_, N);
    const Interval beyond = 2 * sum_of_magnitudes(alpha_), whole = square_tail(decay.rate, N),
                   half = square_tail(decay.rate / 2, N);
    const Interval in_row = 2 * entry_error * node_sum / N + unknowns * folded_entries(decay, N, N) +
                            decay.amplitude * beyond * whole;
    const Interval missed = N * N * N * in_row + decay.amplitude * (unknowns * whole + beyond * square(half));
    energy_error_ = magnitude_of((residual + missed) / gripped_coercivity(A_, beta_));
    const EntryBounds slow = gripped_bounds(A_, 1);
    slope_error_ = magnitude_of(residual + missed +
                                slow.amplitude * square_tail(slow.rate / 2, 1) * energy_error_ /
                                    sqrt(1 - slow.power(1)));
    first_ = sines[1].widened(energy_error_);
    creep_error_ = missed + (3 * A_ + 1) * energy_error_;
    creep_ = (-slopes[0]).widened(creep_error_);
    find_displacement(system, sines, decay, entry_error);
  }

  /// Computes d1 of (6). Sums over the points are integrals by t, so that all integrands have the factor sin(theta).
  void find_displacement(const GrippedSystem<Interval>& system, const std::vector<Interval>& sines,
                         const EntryBounds& decay, const Interval& entry_error) {
    const long N = size_;
    const std::vector<Interval> eta = power_series(epsilon_, 0, N);
    // P and Q times sin(theta); psi and chi times sin(theta) cosh(pi epsilon).
    std::vector<Interval> P(at(N), system.zero), Q = P, psi = P, chi = P;
    for (long i = 0; i < N; ++i) {
      for (long m = 0; m < N; ++m) {
        const long angle = m * (2 * i + 1);  // m theta_i, of which a right angle is N
        const Interval wave = system.cosine(angle - N) * system.cosine(2 * i + 1 - N);
        Interval& traction = (m % 2 == 0 ? Q : P)[at(i)];
        traction = traction + sines[at(m)] * wave;
        Interval& factor = (m % 2 == 0 ? psi : chi)[at(i)];
        factor = factor + times_power_of_i(m, eta[at(m)] * system.cosine(angle));
      }
    }
    const auto [u, v] = system.smooth(P, Q);
    // As the integrand is even, the points t > 0 give half of the integral Z.
    Interval half = system.zero;
    for (long i = 0; i < N / 2; ++i) half = half + psi[at(i)] * u[at(i)] + chi[at(i)] * v[at(i)];
    const Interval cosh_epsilon = 1 / system.root;  // cosh(pi epsilon)
    const Interval tractions = sum_of_magnitudes(alpha_) + sum_of_magnitudes(sines);
    const Interval by_kernels = entry_error * sum_of_magnitudes(eta) * tractions,
                   beyond = decay.power(N - 1) / (1 - decay.power(1)),
                   by_rule =
                       2 * decay.amplitude * beyond * tractions * (2 * cosh_epsilon + sum_of_magnitudes(eta)),
                   by_tractions = cosh_epsilon * (6 * A_ + 2) * energy_error_;
    const Interval Z = (system.share * half / 2).widened(by_kernels + by_rule + by_tractions);
    const Interval singular = first_ / 2 * (displacement_under_psi(epsilon_) - log(A_));
    edge_displacement_ =
        square(A_) * (2 * (singular + Z - 2 * epsilon_ * creep_) - (4 * square(epsilon_) + 1) / 2);
  }

  /// By (5) |d gamma| <= sqrt(1 - t^2) slope_error/(1 - beta^2).
  [[nodiscard]] Interval traction(const SurfacePoint& place, bool shear) const {
    const mpfr_prec_t bits = working_bits();
    if (mpfr_sgn(place.before_end.upper()) <= 0) return Interval(bits);
    const Interval error = slope_error_ / (1 - square(beta_));
    if (mpfr_sgn(place.before_end.lower()) <= 0) {
      const Interval end = magnitude_of(place.before_end);
      return either_side(2 * A_ * sqrt(end * (2 - end)) * (sum_of_magnitudes(alpha_) + error));
    }
    const Interval ratio = place.before_end / (2 - place.before_end), theta = 2 * atan(sqrt(ratio)),
                   turn = -(epsilon_ * log(ratio)), sine = sqrt(place.before_end * (2 - place.before_end));
    Interval even(bits), odd(bits);
    for (long k = 0; k < static_cast<long>(alpha_.size()); ++k) {
      Interval& sum = k % 2 == 0 ? even : odd;
      sum = sum + times_power_of_i(k, alpha_[at(k)] * cos(k * theta));
    }
    const Interval value = shear ? sin(turn) * even + cos(turn) * odd : cos(turn) * even - sin(turn) * odd;
    const Interval traction = 2 * A_ * (sine * value.widened(error));
    return shear && place.is_trailing ? -traction : traction;
  }

  /// gamma = g sin(theta) h, where g has the modulus 1 and the slope -2 i epsilon g/sin(theta), and h is a polynomial.
  /// As the shear is odd, its largest value is that of its magnitude.
  [[nodiscard]] std::optional<Interval> peak(bool shear) const {
    const mpfr_prec_t bits = working_bits();
    const ComplexInterval zero{Interval(bits), Interval(bits)}, twist{Interval(bits), -(2 * epsilon_)};
    const auto traction_over = [&](const Interval& theta) -> FunctionOver {
      const Interval sine = sin(theta), cosine = cos(theta),
                     turn = -(2 * (epsilon_ * log(sine / (cosine + 1))));
      ComplexInterval h = zero, slope = zero, curvature = zero;
      for (long k = 0; k < static_cast<long>(alpha_.size()); ++k) {
        const auto part = [&](ComplexInterval& x) -> Interval& { return k % 2 == 0 ? x.re : x.im; };
        const Interval alpha = times_power_of_i(k, alpha_[at(k)]), wave = alpha * cos(k * theta);
        part(h) = part(h) + wave;
        part(slope) = part(slope) - k * (alpha * sin(k * theta));
        part(curvature) = part(curvature) - k * k * wave;
      }
      const ComplexInterval g{cos(turn), sin(turn)}, first = twist * h + cosine * h + sine * slope;
      const ComplexInterval second =
          1 / sine * (twist * first) + twist * slope + 2 * cosine * slope + sine * (curvature - h);
      const auto part = [&](const ComplexInterval& x) { return shear ? (g * x).im : (g * x).re; };
      return {part(sine * h), part(first), part(second)};
    };
    const Interval end(0x1p-10, bits), error = slope_error_ / (1 - square(beta_));
    const auto found = largest_value(traction_over, hull(end, Interval::pi(bits) - end), magnitude_of(error),
                                     Interval(bits));
    // Nearer the ends tractions are smaller: |q| <= sin(theta) (|turn| even + odd), |turn| <= 2 epsilon ln(2/theta).
    Interval even(bits), odd(bits);
    for (std::size_t k = 0; k < alpha_.size(); ++k)
      (k % 2 == 0 ? even : odd) = (k % 2 == 0 ? even : odd) + magnitude_of(alpha_[k]);
    const Interval nearer = shear ? 2 * epsilon_ * log(2 / end) * even + odd : even + odd;
    if (!found || mpfr_lessequal_p(found->value.lower(), (end * (nearer + error)).upper()) != 0)
      return std::nullopt;
    return 2 * A_ * found->value;
  }

  long size_;
  Interval A_, beta_, epsilon_, offset_;
  std::shared_ptr<SheetKernels> kernels_;
  std::vector<Interval> alpha_;  ///< coefficients of gamma = w sum_k alpha_k i^k T_k
  Interval first_{working_bits()}, creep_{working_bits()}, edge_displacement_{working_bits()};
  Interval energy_error_{working_bits()}, slope_error_{working_bits()}, creep_error_{working_bits()};
};

}  // namespace

Proof proven_gripped(const Exact& half_length, const Exact& beta, int digits, const GrippedKernels& kernels) {
  const GrippedPlan plan = plan_of(half_length.approximate(), beta.approximate(), digits);
  const WorkingDigits working(plan.working_digits);
  const Interval known(half_length, working_bits());
  return {std::make_shared<const GrippedContact>(known, beta, plan.size,
                                                 std::make_shared<SheetKernels>(plan.kernel_digits, kernels)),
          plan.working_digits};
}

std::optional<Proof> proven_gripped_for_load(const Exact& load, double guess,
                                             const std::function<bool(double half_length)>& is_allowed,
                                             const Exact& beta, int digits, const GrippedKernels& kernels,
                                             int most_terms) {
  // An error of the length changes the contact as much as an error of the kernels, so it is found to as many digits.
  const int known = plan_of(guess, beta.approximate(), digits).kernel_digits;
  const GrippedPlan plan = plan_of(1.5 * guess, beta.approximate(), known);
  if (plan.size > most_terms) return std::nullopt;
  const WorkingDigits working(plan.working_digits);
  const auto smooth = std::make_shared<SheetKernels>(plan.kernel_digits, kernels);
  LengthSearch search{load, Float(guess)};
  const auto contact = search.contact_carrying(
      known, [&](const Lengths& half_lengths) -> std::shared_ptr<const GrippedContact> {
        if (!is_allowed(static_cast<double>(half_lengths.length))) return nullptr;
        return std::make_shared<const GrippedContact>(half_lengths.interval(), beta, plan.size, smooth);
      });
  return contact ? std::optional(Proof{contact, plan.working_digits}) : std::nullopt;
}

int proven_gripped_terms(double half_length, double beta, int digits) {
  return static_cast<int>(plan_of(half_length, beta, digits).size);
}

}  // namespace nipref::ref
