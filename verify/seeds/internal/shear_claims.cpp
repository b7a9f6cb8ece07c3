#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include <nipref/verify/seeds/internal/claim_checks.hpp>
#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/thesis_nip.hpp>

// How shear goes along an elastic nip with full friction, by the converged contact.

namespace nipref::verify {
namespace {

using data::Friction;
using fast::ConvergedElasticNip;

constexpr double shear_poisson = 1.0 / 3;

/// Nearer to an end than one step the end's own oscillation, r^(1/2) cos(eps ln r), may turn the shear once more, but at
/// a size that nobody sees.
constexpr int steps = 400;

/// What is at Y = i/steps of the half contact.
struct Station {
  double share;  ///< 2 Y/L
  double pressure, shear, error;
};

std::vector<Station> stations(const ConvergedElasticNip& nip) {
  const double half = nip.contact_length().value / 2;
  std::vector<Station> all;
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const fast::Estimate shear = nip.shear(share * half);
    all.push_back({share, nip.pressure(share * half).value, shear.value, shear.error});
  }
  return all;
}

/// Share of the half contact at which the shear changes its sign beside the middle, beyond its error; 0 if nowhere.
double reversal(const std::vector<Station>& all) {
  double last = 0;
  for (const Station& here : all) {
    if (std::fabs(here.shear) <= here.error) continue;
    if (last * here.shear < 0) return here.share;
    last = here.shear;
  }
  return 0;
}

bool ratio_rises(const std::vector<Station>& all) {
  return std::ranges::is_sorted(all, {},
                                [](const Station& here) { return std::fabs(here.shear) / here.pressure; });
}

using Property = std::function<bool(const std::vector<Station>&)>;

/// L/B between one where `is_so` and one where it is not.
Propagated border_between(const Property& is_so, double with, double without) {
  constexpr int halvings = 7;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(with, without);
    (is_so(stations(nip_of_length(middle, Friction::full, shear_poisson))) ? with : without) = middle;
  }
  return Propagated::between(Propagated::exact(std::min(with, without)),
                             Propagated::exact(std::max(with, without)));
}

/// From the first to the last L/B at which `is_so`, nu = 1/3, of those looked at in steps of a twentieth from 0.5 to 20.
struct Range {
  Propagated first, last;
};
std::optional<Range> range_where(const Property& is_so) {
  constexpr double lowest = 0.5, highest = 20, factor = 1.05;
  double first = 0, last = 0;
  for (double length = lowest; length < highest * factor; length *= factor) {
    const double here = std::min(length, highest);
    if (!is_so(stations(nip_of_length(here, Friction::full, shear_poisson)))) continue;
    if (first == 0) first = here;
    last = here;
  }
  if (first == 0) return {};
  return Range{first == lowest ? Propagated::exact(lowest) : border_between(is_so, first, first / factor),
               last == highest ? Propagated::exact(highest) : border_between(is_so, last, last * factor)};
}

ClaimOutcome outcome_outside(const std::optional<Range>& broken, const char* what) {
  if (!broken) return {ClaimVerdict::holds, "at nu = 1/3 for L/B from 0.5 to 20", {}};
  return {ClaimVerdict::holds_in_a_range,
          fmt::format("at nu = 1/3 {} for L/B from {:.2g} to {:.2g}, of 0.5 to 20", what,
                      broken->first.value(), broken->last.value()),
          {{"L/B from which it is so", broken->first}, {"L/B to which it is so", broken->last}}};
}

ClaimOutcome one_reversal() {
  ClaimOutcome outcome =
      outcome_outside(range_where([](const auto& all) { return reversal(all) > 0; }),
                      "there is another one on each side, farther than L/800 from the end,");
  const ConvergedElasticNip nip = thesis_nip(0.0625, 100, Friction::full);
  const double half = nip.contact_length().value / 2;
  for (const double share : {0.45, 0.95})
    outcome.numbers.push_back(
        {fmt::format("q at 2Y/L = {}, B = 0.0625 in, W = 100 lbf/in, psi", share), nip.shear(share * half)});
  outcome.numbers.push_back(
      {"2Y/L at which q vanishes there", 2 * Propagated(nip.shear_zeros().at(1)) / nip.contact_length()});
  return outcome;
}

ClaimOutcome shear_over_pressure() {
  ClaimOutcome outcome =
      outcome_outside(range_where([](const auto& all) { return !ratio_rises(all); }), "it falls somewhere");
  const ConvergedElasticNip nip = thesis_nip(0.0625, 100, Friction::full);
  const double half = nip.contact_length().value / 2;
  for (const double share : {0.45, 0.8})
    outcome.numbers.push_back({fmt::format("|q|/p at 2Y/L = {}, B = 0.0625 in, W = 100 lbf/in", share),
                               fabs(nip.shear(share * half)) / nip.pressure(share * half)});
  return outcome;
}

ClaimOutcome place_of_largest() {
  struct Sheet {
    double thickness, load;
  };
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  double least = 1, most = 0;
  for (const Sheet& sheet : {Sheet{1, 100}, {0.25, 100}, {0.005, 25}, {0.005, 100}, {0.005, 200}}) {
    const ConvergedElasticNip nip = thesis_nip(sheet.thickness, sheet.load, Friction::full);
    const Propagated place = 0.5 - Propagated(nip.peak_shear_position()) / nip.contact_length();
    outcome.numbers.push_back(
        {fmt::format("distance from the end over L, B = {} in, W = {} lbf/in", sheet.thickness, sheet.load),
         place});
    least = std::min(least, place.value());
    most = std::max(most, place.value());
  }
  outcome.why = fmt::format(
      "it lies between {:.3f} and {:.3f} of L; the tables' twenty elements can say 1/8 or its neighbours",
      least, most);
  constexpr double eighth = 0.125, about = 0.2;
  if (least < (1 - about) * eighth || most > (1 + about) * eighth) outcome.verdict = ClaimVerdict::fails;
  return outcome;
}

ClaimOutcome intermediate_shear() {
  ClaimOutcome outcome{ClaimVerdict::holds, "smallest over the peak pressure on the sheet in between", {}};
  std::vector<Propagated> shares;
  for (const double thickness : {1.0, 0.0625, 0.005}) {
    const ConvergedElasticNip nip = thesis_nip(thickness, 25, Friction::full);
    shares.push_back(Propagated(nip.peak_shear()) / nip.peak_pressure());
    outcome.numbers.push_back(
        {fmt::format("peak shear over peak pressure, B = {} in, W = 25 lbf/in", thickness), shares.back()});
  }
  outcome.numbers.push_back(
      {"peak shear, B = 0.0625 in, W = 25 lbf/in, psi", thesis_nip(0.0625, 25, Friction::full).peak_shear()});
  const bool smallest = (shares[0] - shares[1]).is_positive() && (shares[2] - shares[1]).is_positive();
  if (!smallest) {
    outcome.verdict = ClaimVerdict::fails;
    outcome.why = "it is not the smallest of the three sheets'";
  }
  return outcome;
}

}  // namespace

ClaimChecks shear_claims() {
  return {{"thesis-one-reversal", one_reversal},
          {"thesis-shear-over-pressure", shear_over_pressure},
          {"thesis-place-of-largest-shear", place_of_largest},
          {"thesis-intermediate-shear", intermediate_shear}};
}

}  // namespace nipref::verify
