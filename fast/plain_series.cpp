#include "fast/plain_series.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "data/bad_input.hpp"
#include "fast/argument_checks.hpp"
#include "fast/sheet_roots.hpp"

namespace nipref::fast {
namespace {

constexpr int kLargestTermCount = 500;

/// Names of (AI.8), (AI.9).
struct Term {
  double K;
  double m;
  double A;
  double B;
};

/// A = -2 Re c, B = -2 Im c with the residue coefficient c = tanh^2 z/(2z): (AI.8) in complex form.
Term term(int n) {
  const std::complex<double> z = sheet_root(n);
  const std::complex<double> tanh_z = std::tanh(z);
  const std::complex<double> c = tanh_z * tanh_z / (2.0 * z);
  return {z.imag(), z.real(), -2 * c.real(), -2 * c.imag()};
}

std::vector<Term> all_terms() {
  std::vector<Term> terms;
  for (int n = 1; n <= kLargestTermCount; ++n) terms.push_back(term(n));
  return terms;
}

}  // namespace

double plain_series_I1(double alpha, int terms) {
  internal::check_argument("alpha", alpha, internal::Domain::finite_nonzero);
  if (terms < 1 || terms > kLargestTermCount)
    throw data::BadInput("terms", terms, "must satisfy 1 <= terms <= 500");
  static const std::vector<Term> kTerms = all_terms();
  const double a = std::fabs(alpha);
  double sum = 0;
  for (int n = 0; n < terms; ++n) {
    const Term& t = kTerms[static_cast<std::size_t>(n)];
    sum += std::exp(-t.K * a) * (t.A * std::sin(t.m * a) + t.B * std::cos(t.m * a));
  }
  return std::numbers::pi * sum;
}

}  // namespace nipref::fast
