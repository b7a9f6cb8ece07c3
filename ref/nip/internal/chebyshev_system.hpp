#pragma once
#include <vector>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// A right-hand side f_0 .. f_{2n-1}. `next` bounds |f_{2n}|, and each further bound is half of the one before.
struct SlopeSeries {
  std::vector<Interval> coefficients;
  Interval next;

  /// f_1 = 1 and all others 0: the elastic contact.
  static SlopeSeries line(int size);
};

/// The solution for a right-hand side: the pressure, and the constant by which its slope differs from the given one.
struct BoundedColumn : ProvenExpansion {
  Interval constant;
};

/// The system for the pressure 2A sum c_m sin(m theta) of an elastic contact of half length A. The pressure is 0 at
/// both ends and causes a slope of the surface that is a given function of t = cos(theta) up to a constant. The rule
/// has the 2n Chebyshev points theta_i = (2i + 1) pi/(4n):
///
///     (1/pi) int_{-1}^{1} I1(A (t - s)) q(s) ds = constant - sum f_m T_m(t),    q = p'/(2A),   all m >= 1,
///     c_m + (1/2) sum_k g_mk k c_k = f_m,    J(A(t - s)) = sum g_mk T_m(t) T_k(s).
///
/// Odd and even m form two systems at the n points t > 0, with the odd and the even part of J as their kernels. Proofs:
/// ref/elastic_nip/README.md, Contacts without friction.
class ChebyshevSystem {
 public:
  /// The system of odd m, and if `both` that of even m too. `half_length` is A, with the working precision.
  ChebyshevSystem(const Float& half_length, int size, SmoothKernel& kernel, bool both);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const Float& half_length() const { return half_length_; }
  /// cos(k pi/(4n)).
  [[nodiscard]] const Cosines& cosines() const { return cosines_; }
  /// The system of m = 1, 3, .. or that of m = 2, 4, .., with the matrix [J(A (t_i - t_j)) -+ J(A (t_i + t_j))]/2. Its
  /// entries have the error of the kernel and that of rounded arguments.
  struct Parity {
    long first;
    std::vector<Float> lower_triangle;
    EliminatedInDouble eliminated;

    [[nodiscard]] const Float& part(int i, int j) const;
  };
  [[nodiscard]] const std::vector<Parity>& parities() const { return parities_; }

  /// c_0 .. c_{2n-1} to about the working precision; c_m = 0 if no system has the parity of m.
  [[nodiscard]] std::vector<Float> solution(const SlopeSeries& right) const;
  /// Encloses the solutions for all half lengths of an interval around half_length().
  [[nodiscard]] BoundedColumn proven(const std::vector<Float>& coefficients, const SlopeSeries& right,
                                     const Interval& half_length) const;

 private:
  /// The sums sum_k k c_k cos(k theta) at the nodes t > 0, and the coefficients of the kernel times these sums.
  template <class Number>
  struct Applied {
    std::vector<Number> at_nodes, smooth;
  };

  [[nodiscard]] long end() const { return 2L * size_; }
  [[nodiscard]] Vector::Index unknowns(const Parity& parity) const { return (end() - parity.first + 1) / 2; }
  void eliminate(Parity& parity) const;
  template <class Number>
  [[nodiscard]] const Number& cosine(long k) const;
  template <class Number>
  [[nodiscard]] Applied<Number> applied_to(const Parity& parity,
                                           const std::vector<Number>& coefficients) const;

  Float half_length_;
  int size_;
  Cosines cosines_;
  std::vector<Float> middles_;  ///< midpoints of the cosines
  Float kernel_error_;
  std::vector<Parity> parities_;
};

}  // namespace nipref::ref
