#pragma once
#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <nipref/ref/number/interval.hpp>

// The equations of the contact with full friction in double, Float or intervals. (ref/elastic_nip/README.md, Contacts with
// full friction, (2) and (3))

namespace nipref::ref::gripped {

inline std::size_t at(long k) { return static_cast<std::size_t>(k); }

/// x times i^m, over i where m is odd.
template <class Number>
Number with_sign_of(long m, const Number& x) {
  return (m & 2) != 0 ? Number(-x) : x;
}

template <class Number>
Number times(long m, const Number& x) {
  if constexpr (std::is_same_v<Number, double>) return static_cast<double>(m) * x;
  if constexpr (!std::is_same_v<Number, double>) return m * x;
}

/// Numbers of one contact of half length A at the Chebyshev points t_i = cos((2i + 1) pi/(2N)), i < N.
template <class Number>
struct System {
  long size;                    ///< N, even
  Number zero, root, share;     ///< 0, sqrt(1 - beta^2) and 4/N^2
  std::vector<Number> cosines;  ///< cos(k pi/(2N)), k < 4N
  std::vector<Number> powers;   ///< omega_j, over i^j
  /// J, I3 and J - int I3 at A (t_i - t_j), a row for each t_i > 0: at -t_i follows by parity.
  std::vector<Number> normal, coupling, along;

  [[nodiscard]] const Number& cosine(long k) const {
    const long period = 4 * size;
    return cosines[at((k % period + period) % period)];
  }

  /// The coefficient of zeta^n in 4 Omega h, over i^{1 - n}.
  [[nodiscard]] Number outer(const std::vector<Number>& alpha, long n) const {
    Number sum = zero;
    for (long k = std::max(0L, n - 1); k < static_cast<long>(alpha.size()); ++k) {
      const Number term = alpha[at(k)] * powers[at(1 + k - n)];
      sum = k % 2 == 0 ? Number(sum + term) : Number(sum - term);
    }
    for (long k = 0; k <= std::min(1 - n, static_cast<long>(alpha.size()) - 1); ++k)
      sum = sum + alpha[at(k)] * powers[at(1 - n - k)];
    return sum;
  }

  /// Coefficients of sin(m theta) in the tractions over 2A: of odd m in the pressure, of even m in the shear.
  [[nodiscard]] std::vector<Number> sines(const std::vector<Number>& alpha) const {
    std::vector<Number> result(at(size), zero);
    for (long m = 1; m < size; ++m) {
      const Number above = outer(alpha, m), below = outer(alpha, -m);
      const Number both = m % 2 == 0 ? Number(above - below) : Number(above + below);
      result[at(m)] = with_sign_of(m, Number(root * both / 4));
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

  /// sum of m c_m cos(m theta_i) over odd m, or even ones.
  [[nodiscard]] std::vector<Number> slopes(const std::vector<Number>& sines, long first) const {
    std::vector<Number> result(at(size), zero);
    for (long i = 0; i < size; ++i)
      for (long m = first; m < size; m += 2)
        result[at(i)] = result[at(i)] + times(m, sines[at(m)]) * cosine(m * (2 * i + 1));
    return result;
  }

  /// Coefficients of T_m in the slopes that the tractions cause, over -2A^2: of odd m that of u, of even m that of v.
  [[nodiscard]] std::vector<Number> rows(const std::vector<Number>& alpha,
                                         const std::vector<Number>& sines) const {
    const auto [u, v] = smooth(slopes(sines, 1), slopes(sines, 2));
    std::vector<Number> result(at(size), zero);
    for (long m = 0; m < size; ++m) {
      Number sum = zero;
      for (long i = 0; i < size / 2; ++i) sum = sum + (m % 2 == 0 ? v : u)[at(i)] * cosine(m * (2 * i + 1));
      result[at(m)] = with_sign_of(m, Number(root * outer(alpha, m) / 2)) + share * sum;
    }
    result[0] = result[0] / 2;
    return result;
  }
};

template <class Number>
Number converted(const Interval& x) {
  if constexpr (std::is_same_v<Number, double>) return mpfi_get_d(x.get());
  if constexpr (std::is_same_v<Number, Float>) return middle_of(x);
  if constexpr (std::is_same_v<Number, Interval>) return x;
}

template <class Number>
std::vector<Number> all_converted(const std::vector<Interval>& x) {
  std::vector<Number> result;
  result.reserve(x.size());
  for (const Interval& value : x) result.push_back(converted<Number>(value));
  return result;
}

template <class Number>
System<Number> converted(const System<Interval>& from) {
  return {from.size,
          converted<Number>(from.zero),
          converted<Number>(from.root),
          converted<Number>(from.share),
          all_converted<Number>(from.cosines),
          all_converted<Number>(from.powers),
          all_converted<Number>(from.normal),
          all_converted<Number>(from.coupling),
          all_converted<Number>(from.along)};
}

/// Coefficients f_j of ((1 + y)/(1 - y))^{2 i epsilon} (1 - y^2)^{order}, order 0 or 1, over i^j, j < count.
inline std::vector<Interval> power_series(const Interval& epsilon, long order, long count) {
  std::vector<Interval> f{Interval(1L, epsilon.precision()), 4 * epsilon};
  for (long j = 1; j + 1 < count; ++j)
    f.push_back((4 * (epsilon * f[at(j)]) - (j - 1 - 2 * order) * f[at(j - 1)]) / (j + 1));
  return f;
}

}  // namespace nipref::ref::gripped
