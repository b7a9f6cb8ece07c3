// Viscoelastic nips in steady frictionless rolling, dimensionless.

#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>

namespace nipref::verify {
namespace {

/// The factor by which rounding errors of the kernel are amplified. At the distance L the kernel is about ln(1 + B/L),
/// and a sheet that softens with time has a pressure that is larger by the softening. The errors of random contacts
/// over the whole domain grow like this factor.
double amplification(double L_over_B, double softening) { return 1 + softening * std::log1p(1 / L_over_B); }

constexpr double shortest_rolling = 1e-6;

/// The nip at speed 1 with theta = at_once [delta + (softening - 1)/tau e^(-t/tau)]; in theta2 the misprinted solid has
/// twice the rate.
data::ViscoelasticNip rolling_nip(const NamedPoint& x) {
  const double length = x["L_over_B"], memory = x["memory_over_L"], poisson = x["poisson"],
               softening = x["softening"];
  check_nip_length(length);
  if (!(memory >= 1e-8 && memory <= 1e8))
    throw data::BadInput("memory_over_L", memory, "must be from 1e-8 to 1e8");
  if (!(poisson > -1 && poisson < 0.5))
    throw data::BadInput("poisson", poisson, "must satisfy -1 < poisson < 0.5 where the sheet has a memory");
  if (!(softening > 1 && softening <= 1e6))
    throw data::BadInput("softening", softening, "must be > 1 and at most 1e6");
  const double time = memory * length, theta1 = 1 + poisson, theta2 = theta1 * (1 - 2 * poisson);
  const auto function = [&](double at_once, double rate_factor) {
    return data::MaterialFunction{at_once, {{at_once * (softening - 1) / time, rate_factor / time}}};
  };
  return {nip_roller_radius, 1, {function(theta1, 1), function(theta2, x["material"] == 0 ? 1 : 2)}, 1};
}

/// The exact sum of the material's instantaneous compliances, which are doubles.
mpq_class exact_compliance(const data::ViscoelasticNip& nip) {
  const data::MaterialFunctions& functions = *nip.material.functions();
  return mpq_class(functions.theta1.instantaneous) + mpq_class(functions.theta2.instantaneous);
}

/// The results, dimensionless, in the order of the entries. Compliance and length are doubles or exact.
template <class Number>
auto rolling_numbers_of(const auto& contact, const Number& compliance, const Number& length) {
  const Number slope = nip_roller_radius / length;
  return std::vector{
      in_unit(contact.rolling_resistance(), slope), in_unit(contact.leading_length(), Number(1 / length)),
      in_unit(contact.load(), Number(compliance * slope / length)),
      in_unit(contact.indentation(), Number(slope / length)), in_unit(contact.creep_ratio(), slope)};
}

NipEstimates rolling_by_fast(const NamedPoint& x, fast::Accuracy accuracy) {
  const data::ViscoelasticNip nip = rolling_nip(x);
  const double length = x["L_over_B"];
  return rolling_numbers_of(fast::converged_for_length(nip, length, nip_accuracy(accuracy)),
                            nip.material.functions()->normal_compliance().instantaneous, length);
}

void check_rolling_work(const data::ViscoelasticNip& nip, const NamedPoint& x, int digits) {
  const double length = x["L_over_B"], memory = x["memory_over_L"], softening = x["softening"];
  if (length < shortest_rolling)
    throw data::BadInput("L_over_B", length, "must be at least 1e-6 for rolling on the reference path");
  const int most = most_digits_in_time([&](int some) { return likely_seconds(nip, length, some); });
  if (digits <= most) return;
  const std::string here = fmt::format("L_over_B = {:.6g}, memory_over_L = {:.6g} and softening = {:.6g}",
                                       length, memory, softening);
  if (most > 0)
    refuse("digits", std::to_string(digits), "must be at most {} for {}: more take too long", most, here);
  throw data::BadInput(
      "L_over_B", length,
      "must be smaller, or memory_over_L larger, or softening smaller, on the reference path: " + here +
          " take it too long");
}

NipReferences rolling_by_ref(const NamedPoint& x, int digits) {
  const data::ViscoelasticNip nip = rolling_nip(x);
  check_rolling_work(nip, x, digits);
  return rolling_numbers_of(ref::converged_for_length(nip, x["L_over_B"], digits), exact_compliance(nip),
                            mpq_class(x["L_over_B"]));
}

}  // namespace

std::vector<Quantity> viscoelastic_nip_entries() {
  std::vector<Quantity> entries = nip_entries("rolling_nip", {rolling_by_fast, rolling_by_ref});
  for (Quantity& entry : entries) {
    entry.envelope =
        [least = entry.envelope, value_at = entry.by_fast,
         amplified = of_point(entry, {"L_over_B", "softening"}, amplification)](std::span<const double> x) {
          return amplified(x) * std::max(least(x), std::fabs(value_at(x, {})));
        };
  }
  return entries;
}

}  // namespace nipref::verify
