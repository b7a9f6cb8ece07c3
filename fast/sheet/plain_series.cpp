#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/sheet/internal/argument_checks.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/sheet/roots.hpp>

namespace nipref::fast {
namespace {

/// One residue term, with the names of (AI.8), (AI.9).
struct Term {
  double K;
  double m;
  ResidueCoefficients I1, I3, I6;
};

Term term(int n) {
  const std::complex<double> z = sheet_root(n);
  const auto of = [n](PlainKernel kernel) -> ResidueCoefficients {
    const ResidueCoefficients one = residue_coefficients(kernel, n);
    return {std::numbers::pi * one.A, std::numbers::pi * one.B};
  };
  return {z.imag(), z.real(), of(PlainKernel::I1), of(PlainKernel::I3), of(PlainKernel::I6_alpha_part)};
}

/// Twice the residue at z, with (sinh 2z + 2z)' = 4 cosh^2 z.
std::complex<double> twice_residue(PlainKernel kernel, int n) {
  // Errors in units of 2^-53: 4 in z, 8 in w, which changes the hyperbolic tangent by 6 and cosh z by 9, as |w| < 0.21.
  // The other operations are products and quotients, with 3 and 5 units each. The sum is 27 at most, for I4.
  const std::complex<double> z = sheet_root(n), w = 0.5 / z, tangent = w + std::sqrt(1.0 + w * w);
  const std::complex<double> cosine = (n % 2 == 0 ? 1.0 : -1.0) * std::sqrt(-z / tangent);
  switch (kernel) {
    case PlainKernel::I1:
      return tangent * tangent / z;
    case PlainKernel::I3:
      return -tangent / z;
    case PlainKernel::I4:
      return tangent / (z * cosine);
    case PlainKernel::I5:
      return 1.0 / cosine;
    case PlainKernel::I6_alpha_part:
      return 1.0 / z;
    case PlainKernel::I6_eta_part:
      return -1.0 / (z * cosine);
    case PlainKernel::I7:
      break;
  }
  return tangent / cosine;
}

const std::vector<Term>& all_terms() {
  static const std::vector<Term> terms = [] {
    std::vector<Term> computed;
    for (int n = 1; n <= most_residue_terms; ++n) computed.push_back(term(n));
    return computed;
  }();
  return terms;
}

std::span<const Term> first_terms(int count) {
  internal::check_range("terms", count, 1, most_residue_terms);
  return std::span(all_terms()).first(static_cast<std::size_t>(count));
}

/// The sums over the terms at one |alpha|.
struct Sums {
  double I1 = 0, I3 = 0, I6 = 0;
};

Sums sum(std::span<const Term> terms, double a) {
  Sums sums;
  for (const Term& t : terms) {
    const double decay = std::exp(-t.K * a);
    const double sine = decay * std::sin(t.m * a);
    const double cosine = decay * std::cos(t.m * a);
    sums.I1 += t.I1.A * sine + t.I1.B * cosine;
    sums.I3 += t.I3.A * sine + t.I3.B * cosine;
    sums.I6 += t.I6.A * sine + t.I6.B * cosine;
  }
  return sums;
}

}  // namespace

ResidueCoefficients residue_coefficients(PlainKernel kernel, int n) {
  const std::complex<double> c = twice_residue(kernel, n);
  const bool odd = kernel == PlainKernel::I3 || kernel == PlainKernel::I4 || kernel == PlainKernel::I5;
  return odd ? ResidueCoefficients{-c.imag(), c.real()} : ResidueCoefficients{-c.real(), -c.imag()};
}

double plain_series_I1(double alpha, int terms) {
  internal::check_argument("alpha", alpha, internal::Domain::finite_nonzero);
  const double a = std::fabs(alpha);
  double sum = 0;
  for (const Term& t : first_terms(terms)) {
    sum += std::exp(-t.K * a) * (t.I1.A * std::sin(t.m * a) + t.I1.B * std::cos(t.m * a));
  }
  return sum;
}

void plain_series(std::span<const double> alpha, int terms, PlainSeriesValues values) {
  const std::span<const Term> wanted = first_terms(terms);
  for (const std::span<double> kernel : {values.I1, values.I3, values.I6_alpha_part})
    if (!kernel.empty())
      internal::check_arguments("alpha", alpha, kernel.size(), internal::Domain::finite_nonzero);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const double a = std::fabs(alpha[i]);
    const Sums sums = sum(wanted, a);
    if (!values.I1.empty()) values.I1[i] = sums.I1;
    if (!values.I3.empty()) values.I3[i] = std::copysign(1.0, alpha[i]) * (std::numbers::pi / 4 + sums.I3);
    if (!values.I6_alpha_part.empty()) values.I6_alpha_part[i] = sums.I6 - std::numbers::pi / 4 * a;
  }
}

}  // namespace nipref::fast
