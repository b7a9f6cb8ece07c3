// Elastic nips, dimensionless.

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>

namespace nipref::verify {
namespace {

bool is_gripped(const NamedPoint& x) { return x["friction"] != 0; }
data::Friction friction_of(const NamedPoint& x) {
  return is_gripped(x) ? data::Friction::full : data::Friction::none;
}

data::ElasticNip unit_nip(const NamedPoint& x) {
  check_nip_length(x["L_over_B"]);
  return {nip_roller_radius, 1, {1, x["poisson"]}};
}

/// The results, dimensionless, in the order of the entries. Compliance and length are doubles or exact.
template <class Number>
auto numbers_of(const auto& contact, const Number& compliance, const Number& length) {
  const Number stress = compliance * nip_roller_radius / length, slope = nip_roller_radius / length;
  return std::vector{in_unit(contact.load(), Number(stress / length)),
                     in_unit(contact.indentation(), Number(slope / length)),
                     in_unit(contact.creep_ratio(), slope), in_unit(contact.peak_pressure(), stress),
                     in_unit(contact.peak_shear(), stress)};
}

NipEstimates nip_by_fast(const NamedPoint& x, fast::Accuracy accuracy) {
  const data::ElasticNip nip = unit_nip(x);
  const double length = x["L_over_B"];
  const auto contact = fast::converged_for_length(nip, friction_of(x), length, nip_accuracy(accuracy));
  return numbers_of(contact, nip.material.normal_compliance(), length);
}

/// Frictionless contacts are proven where that does not take too long; all others are estimated.
ref::ConvergedNip solved_nip(const data::ElasticNip& nip, double length, data::Friction friction,
                             int digits) {
  const int most = most_digits_in_time(
      [&](int some) { return likely_seconds(nip, friction, length, some, terms_in_long_time); });
  if (digits > most)
    refuse("digits", std::to_string(digits), "must be at most {} for L_over_B = {:.6g}{}: more take too long",
           most, length, friction == data::Friction::full ? " with full friction" : "");
  return ref::converged_for_length(nip, friction, length, digits, terms_in_long_time);
}

NipReferences nip_by_ref(const NamedPoint& x, int digits) {
  const ref::ConvergedNip contact = solved_nip(unit_nip(x), x["L_over_B"], friction_of(x), digits);
  const mpq_class length = x["L_over_B"], poisson = x["poisson"];
  return numbers_of(contact, mpq_class(2 * (1 - poisson * poisson)), length);
}

}  // namespace

std::vector<Quantity> elastic_nip_entries() {
  std::vector<Quantity> entries = nip_entries("nip", {nip_by_fast, nip_by_ref});
  for (Quantity& entry : entries) {
    // The longer a contact with full friction and the less compressible its sheet, the more the system amplifies
    // rounding errors. The scale of long ones makes the promise equal the stated error, as an ulp is at least 2^-53 of
    // it.
    entry.envelope = [least = entry.envelope, promise = entry.promise, error_of = entry.fast_error,
                      amplifies = of_point(entry, [](const NamedPoint& x) {
                        return is_gripped(x) && x["L_over_B"] > 7;
                      })](std::span<const double> x) {
      return amplifies(x) ? std::max(least(x), std::ldexp(error_of(x, {}) / promise, 53)) : least(x);
    };
  }
  return entries;
}

}  // namespace nipref::verify
