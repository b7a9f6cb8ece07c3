#include <algorithm>
#include <cmath>

#include <nipref/ref/elastic_nip/gripped.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/catalogue/nip_seconds.hpp>

namespace nipref::verify {

double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length, int digits) {
  if (friction == data::Friction::full)
    return 5.6 * std::pow(ref::gripped_unknowns(nip, length, digits) / 532.0, 2.1);
  return 10 * std::pow(length / nip.sheet_thickness * (digits + 20) / 1250, 2);
}

double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits) {
  const double unknowns = ref::rolling_unknowns(nip, length, digits);
  const double thin = std::min(1.0, length / nip.sheet_thickness / 5);
  return (0.5 + unknowns / 500 + unknowns * unknowns / 47000) * (1 + 0.4 * thin) * (1 + (digits - 16) / 24.0);
}

}  // namespace nipref::verify
