#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/verify/seeds/internal/claim_checks.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>

// What the papers on half-spaces say, by the catalogue's quantities, whose formulas are the corrected ones.

namespace nipref::verify {
namespace {

/// A quantity by the reference, for a claim.
ClaimNumber row(const std::string& name, const Assignments& given, const std::string& what) {
  return {what, SettledRow(name, given).by_ref};
}

/// To more digits than a result has.
constexpr const char* one_third = "0.3333333333333333333333333";

ClaimOutcome circle_without_friction() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  for (const char* speed : {"0.1", "0.6"}) {
    const Assignments here{{"poisson", one_third}, {"speed", speed}};
    Assignments smooth = here;
    smooth.emplace_back("friction", "0");
    outcome.numbers.push_back(
        row("die.span_ratio", smooth, fmt::format("L2/L1 by the paper's rule, nu = 1/3, c = {}", speed)));
    outcome.numbers.push_back(
        row("ellipse.axis_ratio", here, fmt::format("axes of the exact contact, nu = 1/3, c = {}", speed)));
  }
  const bool kept = std::ranges::all_of(outcome.numbers, [](const ClaimNumber& one) {
    return std::fabs(one.number.value() - 1) <= one.number.error();
  });
  outcome.why =
      kept ? "at c = 0.1 and 0.6" : "at rest only: the paper's own rule (35) and the exact contact say so";
  if (!kept) outcome.verdict = ClaimVerdict::holds_in_a_range;
  return outcome;
}

ClaimOutcome ellipse_at_rest() {
  constexpr double curvature_ratio = 4;
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  outcome.numbers.push_back(row("ellipse.axis_ratio",
                                {{"poisson", "0.3"}, {"speed", "0"}, {"curvature_ratio", "4"}},
                                "axes of the exact contact, curvatures 4 to 1"));
  outcome.numbers.push_back({"axes of the profile's section", sqrt(1 / Propagated(curvature_ratio))});
  outcome.numbers.push_back({"L2/L1 = C1/C2 of (35)", 1 / Propagated(curvature_ratio)});
  const double exact = outcome.numbers[0].number.value(), section = outcome.numbers[1].number.value();
  const bool more_slender = exact < section, as_printed = std::fabs(exact * curvature_ratio - 1) < 1e-3;
  if (!more_slender) {
    outcome.verdict = ClaimVerdict::fails;
  } else if (!as_printed) {
    outcome.verdict = ClaimVerdict::holds_in_a_range;
    outcome.why = "more slender it is, but by far not C1/C2";
  }
  return outcome;
}

ClaimOutcome speed_makes_slender() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  for (const char* speed : {"0", "0.3", "0.6", "0.9"}) {
    outcome.numbers.push_back(
        row("ellipse.axis_ratio", {{"poisson", one_third}, {"speed", speed}},
            fmt::format("axes of the exact contact of a sphere, nu = 1/3, c = {}", speed)));
  }
  const bool falls = std::ranges::is_sorted(outcome.numbers, std::greater(),
                                            [](const ClaimNumber& one) { return one.number.value(); });
  if (!falls) outcome.verdict = ClaimVerdict::fails;
  const ClaimNumber by_rule =
      row("die.span_ratio", {{"poisson", one_third}, {"speed", "0.6"}, {"friction", "0"}},
          "L2/L1 by the paper's rule, c = 0.6");
  outcome.why = fmt::format("the paper's rule overstates 1 - L2/L1 {:.1f} times at c = 0.6",
                            (1 - by_rule.number.value()) / (1 - outcome.numbers[2].number.value()));
  outcome.numbers.push_back(by_rule);
  return outcome;
}

ClaimOutcome friction_and_symmetry() {
  ClaimOutcome outcome{
      ClaimVerdict::holds,
      "the leading part of the span on a diameter is 1 + Omega of it, Omega + 1/2 is odd along the motion",
      {}};
  for (const char* psi : {"0", "45", "89"}) {
    outcome.numbers.push_back(
        row("die.exponent", {{"poisson", one_third}, {"speed", "0"}, {"friction", "0.3"}, {"psi_deg", psi}},
            fmt::format("Omega, nu = 1/3, c = 0, friction 0.3, {} degrees from the motion", psi)));
  }
  // Symmetric about the axis across it would be -1/2.
  const bool skewed = fabs(outcome.numbers[0].number + 0.5).is_positive();
  if (!skewed) {
    outcome.verdict = ClaimVerdict::fails;
    outcome.why = "it is symmetric about both axes";
  }
  return outcome;
}

ClaimOutcome strip_of_oscillation() {
  constexpr double said = 1e-9, order_of_magnitude = 10;
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  std::string last_true;
  for (const char* speed : {"0.01", "0.1", "0.2", "0.3", "0.5", "0.9"}) {
    const Propagated index =
        row("rolling.index", {{"poisson", one_third}, {"speed", speed}, {"psi_deg", "0"}}, "P").number;
    const Propagated strip = exp(-Propagated::pi() / (2 * index));
    outcome.numbers.push_back({fmt::format("exp(-pi/2P), nu = 1/3, c = {}", speed), strip});
    if (strip.value() < order_of_magnitude * said)
      last_true = speed;
    else
      outcome.verdict = ClaimVerdict::holds_in_a_range;
  }
  outcome.why = fmt::format("within a factor of ten up to c = {}", last_true);
  return outcome;
}

bool rounds_to(double value, double printed, double unit) { return std::fabs(value - printed) <= unit / 2; }

ClaimOutcome rayleigh_roots() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  outcome.numbers.push_back(row("ti.rayleigh", {{"axis", "normal"}}, "root of M, the graphite epoxy"));
  outcome.numbers.push_back(row("halfspace.rayleigh", {{"poisson", "0.29529"}}, "root of M0, the steel"));
  const double of_m = outcome.numbers[0].number.value(), of_m0 = outcome.numbers[1].number.value();
  constexpr double near = 1e-3;
  if (rounds_to(of_m, 0.9268, near) && rounds_to(of_m0, 0.6387, near)) return outcome;
  outcome.verdict = ClaimVerdict::fails;
  if (rounds_to(of_m0, 0.9268, near) && rounds_to(of_m, 0.6387, near))
    outcome.why = "the two are interchanged, and their last digits are off";
  return outcome;
}

/// c0 of steel's shear waves to m/s, as the paper has it.
constexpr double steel_shear_speed = 3133.99;

ClaimOutcome subcritical_limit(const Assignments& where, const Propagated& said, const std::string& why_not) {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  outcome.numbers.push_back(row("ti.critical", where, "smallest speed at which some line is critical, c0"));
  const Propagated limit = outcome.numbers[0].number;
  outcome.numbers.push_back({"the same, m/s", limit * steel_shear_speed});
  outcome.numbers.push_back({"said, c0", said, true});
  if (!rounds_to(limit.value(), said.value(), 1e-3)) {
    outcome.verdict = ClaimVerdict::fails;
    outcome.why = why_not;
  }
  return outcome;
}

ClaimOutcome limit_with_normal_axis() {
  return subcritical_limit(
      {{"axis", "normal"}}, Propagated::exact(0.4595),
      "the branch point is that of waves which have no part in the normal displacement; the limit is "
      "the surface wave's");
}

ClaimOutcome limit_at_45() {
  return subcritical_limit({{"axis", "in-plane"}, {"theta_deg", "45"}}, 1769 / Propagated(steel_shear_speed),
                           "other lines than the one of the motion are critical before");
}

ClaimOutcome no_root_below_branch() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  outcome.numbers.push_back(
      row("ti.rayleigh", {{"axis", "in-plane"}}, "Rayleigh root at theta = psi = 0, c0"));
  outcome.numbers.push_back(row("ti.branch", {{"which", "56"}}, "(c0)56 at theta = 0"));
  if ((outcome.numbers[1].number - outcome.numbers[0].number).is_positive()) {
    outcome.verdict = ClaimVerdict::fails;
    outcome.why = "the motion is in a plane of isotropy there, with a Rayleigh wave below the shear wave";
  }
  return outcome;
}

}  // namespace

ClaimChecks half_space_claims() {
  return {{"brock2012-circle", circle_without_friction}, {"brock2012-ellipse-at-rest", ellipse_at_rest},
          {"brock2012-speed", speed_makes_slender},      {"brock2012-friction", friction_and_symmetry},
          {"brock2012-strip", strip_of_oscillation},     {"brock2013-rayleigh-roots", rayleigh_roots},
          {"brock2013-limit", limit_with_normal_axis},   {"brock2013-no-root", no_root_below_branch},
          {"brock2013-limit-at-45", limit_at_45}};
}

}  // namespace nipref::verify
