#pragma once
#include <vector>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// A right-hand side f_0 .. f_{2n-1}; and a bound of f_{2n} that each further one is at most half of the one before.
struct SlopeSeries {
  std::vector<Interval> coefficients;
  Interval next;

  /// f_1 = 1: the elastic contact.
  static SlopeSeries line(int size);
};

/// What solves a system: a pressure, and the constant beside the given slope.
struct BoundedColumn : ProvenExpansion {
  Interval constant;
};

/// The pressure 2A sum c_m sin(m theta) that is 0 at both ends and makes the slope of an elastic contact of half length A a
/// given function of t = cos(theta) but for a constant, at 2n Chebyshev points theta_i = (2i + 1) pi/(4n):
///
///     (1/pi) int_{-1}^{1} I1(A (t - s)) q(s) ds = constant - sum f_m T_m(t),    q = p'/(2A),   all m >= 1,
///     c_m + (1/2) sum_k g_mk k c_k = f_m,    J(A(t - s)) = sum g_mk T_m(t) T_k(s).
///
/// Odd and even m are two systems, whose kernels at the n points t > 0 are the odd and the even part of J. Proofs, and (1) to
/// (3) in the code: ref/elastic_nip/README.md, Contacts without friction.
class ChebyshevSystem {
 public:
  /// Of odd m, and with `both` of even m too. A to the working precision.
  ChebyshevSystem(const Float& half_length, int size, SmoothKernel& kernel, bool both);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const Float& half_length() const { return half_length_; }
  /// cos(k pi/(4n)).
  [[nodiscard]] const Cosines& cosines() const { return cosines_; }
  /// Of m = 1, 3, .. or m = 2, 4, ..: a system, with [J(A (t_i - t_j)) -+ J(A (t_i + t_j))]/2, to the kernel's error and what
  /// rounding the arguments does.
  struct Parity {
    long first;
    std::vector<Float> lower_triangle;
    EliminatedInDouble eliminated;

    [[nodiscard]] const Float& part(int i, int j) const;
  };
  [[nodiscard]] const std::vector<Parity>& parities() const { return parities_; }

  /// c_0 .. c_{2n-1} to about the working precision, 0 where m is not of a parity of the system.
  [[nodiscard]] std::vector<Float> solution(const SlopeSeries& right) const;
  /// What solves the system, for all half lengths of the interval, about half_length().
  [[nodiscard]] BoundedColumn proven(const std::vector<Float>& coefficients, const SlopeSeries& right,
                                     const Interval& half_length) const;

 private:
  /// What of sum_k k c_k cos(k theta) at the nodes t > 0, and of the kernel times that.
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
  std::vector<Float> middles_;  ///< of the cosines
  Float kernel_error_;
  std::vector<Parity> parities_;
};

}  // namespace nipref::ref
