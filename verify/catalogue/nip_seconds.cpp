#include <algorithm>
#include <cmath>

#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/catalogue/nip_seconds.hpp>

namespace nipref::verify {

double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length, int digits,
                      int most_terms) {
  const int terms = ref::proven_terms(nip, friction, length, digits, most_terms);
  if (terms > 0) return long_time * std::pow(terms / double{terms_in_long_time}, 2);
  const double unknowns = ref::elastic_unknowns(nip, friction, length, digits);
  const double thin = std::min(1.0, length / nip.sheet_thickness / 20);
  return 0.1 + 0.8e-6 * digits * (1 + thin) * unknowns * unknowns;
}

double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits) {
  const double unknowns = ref::rolling_unknowns(nip, length, digits);
  const double thin = std::min(3.0, std::sqrt(length / nip.sheet_thickness / 5));
  return 0.1 + digits * unknowns * (2.5e-4 * (1 + thin) + 0.3e-6 * unknowns);
}

}  // namespace nipref::verify
