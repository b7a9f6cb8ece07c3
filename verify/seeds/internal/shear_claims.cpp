#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/verify/seeds/internal/claim_checks.hpp>
#include <nipref/verify/seeds/internal/thesis_nip.hpp>

// How shear goes along an elastic nip with full friction, by the converged contact.

namespace nipref::verify {
namespace {

using data::Friction;
using fast::ConvergedElasticNip;

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

/// Distance from the end over L.
double place_of_largest_shear(const std::vector<Station>& all) {
  const auto largest =
      std::ranges::max_element(all, {}, [](const Station& here) { return std::fabs(here.shear); });
  return (1 - largest->share) / 2;
}

/// Steps of a twentieth through L/B from 0.5 to 20 at nu = 1/3: the first and the last at which `is_so`.
std::pair<double, double> range_where(const std::function<bool(const std::vector<Station>&)>& is_so) {
  std::pair<double, double> range{0, 0};
  for (double length = 0.5; length < 20; length *= 1.05) {
    if (!is_so(stations(nip_of_length(length, Friction::full, 1.0 / 3)))) continue;
    if (range.first == 0) range.first = length;
    range.second = length;
  }
  return range;
}

ClaimOutcome outcome_outside(const std::pair<double, double>& broken, const char* what) {
  if (broken.first == 0) return {ClaimVerdict::holds, "at nu = 1/3 for L/B from 0.5 to 20", {}};
  return {ClaimVerdict::holds_in_a_range,
          fmt::format("at nu = 1/3 {} for L/B from {:.2f} to {:.2f}", what, broken.first, broken.second),
          {}};
}

ClaimOutcome one_reversal() {
  ClaimOutcome outcome =
      outcome_outside(range_where([](const auto& all) { return reversal(all) > 0; }),
                      "there is another one on each side, farther than L/800 from the end,");
  const ConvergedElasticNip nip = thesis_nip(0.0625, 100, Friction::full);
  const double half = nip.contact_length().value / 2;
  for (const double share : {0.45, 0.95})
    outcome.numbers.push_back(number_of(
        fmt::format("q at 2Y/L = {}, B = 0.0625 in, W = 100 lbf/in, psi", share), nip.shear(share * half)));
  outcome.numbers.push_back(
      {"2Y/L at which q vanishes there",
       sign_change([&](double share) { return nip.shear(share * half).value; }, 0.45, 0.95)});
  return outcome;
}

ClaimOutcome shear_over_pressure() {
  ClaimOutcome outcome =
      outcome_outside(range_where([](const auto& all) { return !ratio_rises(all); }), "it falls somewhere");
  const ConvergedElasticNip nip = thesis_nip(0.0625, 100, Friction::full);
  const double half = nip.contact_length().value / 2;
  for (const double share : {0.45, 0.8})
    outcome.numbers.push_back({fmt::format("|q|/p at 2Y/L = {}, B = 0.0625 in, W = 100 lbf/in", share),
                               std::fabs(nip.shear(share * half).value) / nip.pressure(share * half).value});
  return outcome;
}

ClaimOutcome place_of_largest() {
  struct Sheet {
    double thickness, load;
  };
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  double least = 1, most = 0;
  for (const Sheet& sheet : {Sheet{1, 100}, {0.25, 100}, {0.005, 25}, {0.005, 100}, {0.005, 200}}) {
    const double place =
        place_of_largest_shear(stations(thesis_nip(sheet.thickness, sheet.load, Friction::full)));
    outcome.numbers.push_back(
        {fmt::format("distance from the end over L, B = {} in, W = {} lbf/in", sheet.thickness, sheet.load),
         place});
    least = std::min(least, place);
    most = std::max(most, place);
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
  std::vector<double> shares;
  for (const double thickness : {1.0, 0.0625, 0.005}) {
    const ConvergedElasticNip nip = thesis_nip(thickness, 25, Friction::full);
    shares.push_back(nip.peak_shear().value / nip.peak_pressure().value);
    outcome.numbers.push_back(
        {fmt::format("peak shear over peak pressure, B = {} in, W = 25 lbf/in", thickness), shares.back()});
  }
  outcome.numbers.push_back(number_of("peak shear, B = 0.0625 in, W = 25 lbf/in, psi",
                                      thesis_nip(0.0625, 25, Friction::full).peak_shear()));
  const bool smallest = shares[1] < shares[0] && shares[1] < shares[2];
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
