#include <algorithm>
#include <complex>
#include <string>

#include <nipref/fast/material/internal/partial_fractions.hpp>

namespace nipref::fast::internal {
namespace {

using Roots = std::vector<OctupleComplex>;

bool is_near(const OctupleComplex& a, const OctupleComplex& b, double tolerance) {
  return abs(a - b) <= tolerance * std::max<Octuple>(abs(a), abs(b));
}

void cancel(Roots& zeros, Roots& poles, double shared) {
  std::erase_if(poles, [&](const OctupleComplex& pole) {
    const auto zero =
        std::ranges::find_if(zeros, [&](const OctupleComplex& z) { return is_near(z, pole, shared); });
    if (zero == zeros.end()) return false;
    zeros.erase(zero);
    return true;
  });
}

void check_simple(const Roots& poles, std::string_view name) {
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (is_near(poles[i], poles[j], 1e-6))
        throw data::NoMaterial(
            name, rounded(poles[i]).real(),
            "must not be a repeated root of the operators: t e^(-rate t) is not among the terms");
    }
  }
}

/// gain prod (pole - z)/prod (pole - other pole)
OctupleComplex residue(const Octuple& gain, const Roots& zeros, const Roots& poles, std::size_t k) {
  const auto from_zero = [&](std::size_t j) {
    return j < zeros.size() ? poles[k] - zeros[j] : OctupleComplex(1);
  };
  OctupleComplex value = gain * from_zero(k);
  for (std::size_t j = 0; j < poles.size(); ++j) {
    if (j != k) value *= from_zero(j) / (poles[k] - poles[j]);
  }
  return value;
}

}  // namespace

Compliances compliances_of(const Operators& shear, const Operators& bulk) {
  const Polynomial six = 6 * bulk.q, two = 2 * shear.q;
  // A factor p that both moduli have is cancelled at once, as rounding would split its double root.
  if (shear.p == bulk.p) return {{{shear.p}, {two}}, {{{3}, shear.p}, {sum(six, two)}}};
  return {{{shear.p}, {two}}, {{{3}, shear.p, bulk.p}, {sum(six * shear.p, two * bulk.p)}}};
}

data::MaterialFunction partial_fractions(const Rational& transform, std::string_view name, double shared) {
  const Polynomial denominator = product(transform.denominator);
  if (denominator.is_zero()) throw data::NoMaterial(name, "0", "must leave a modulus that is not 0");
  Octuple gain = 1 / denominator.data().back();
  Roots zeros;
  std::size_t degree = 0;
  for (const Polynomial& factor : transform.numerator) {
    gain *= factor.data().back();
    degree += factor.size() - 1;
    const Roots roots = paired_roots_of(factor);
    zeros.insert(zeros.end(), roots.begin(), roots.end());
  }
  const std::size_t most = denominator.size() - 1;
  if (degree > most || degree + 1 < most) {
    throw data::NoMaterial(
        name, "of degree " + std::to_string(most),
        "must make the compliance's denominator of the numerator's degree, " + std::to_string(degree) +
            ", or one more: the material gives way not without bound, and at once or by a dashpot");
  }
  Roots poles = paired_roots_of(denominator);
  if (zeros.size() != degree || poles.size() != most)
    throw data::NoMaterial(name, "(its roots)",
                           "must come in conjugate pairs: some are repeated or nearly so");
  cancel(zeros, poles, shared);
  check_simple(poles, name);
  data::MaterialFunction function{degree < most ? 0 : static_cast<double>(gain), {}};
  for (std::size_t k = 0; k < poles.size(); ++k) {
    std::complex<double> amplitude = rounded(residue(gain, zeros, poles, k));
    if (poles[k].imag() == 0) amplitude = amplitude.real();
    function.terms.push_back({amplitude, 0.0 - rounded(poles[k])});  // no -0
  }
  // Without this, rounding could make the amplitudes of a conjugate pair differ.
  for (data::RelaxationTerm& term : function.terms) {
    if (term.rate.imag() <= 0) continue;
    const auto other = std::ranges::find(function.terms, std::conj(term.rate), &data::RelaxationTerm::rate);
    other->amplitude = std::conj(term.amplitude);
  }
  return function;
}

}  // namespace nipref::fast::internal
