#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/verify/seeds/internal/claim_checks.hpp>
#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/thesis_nip.hpp>

// What full friction changes in an elastic nip, by the converged contacts.

namespace nipref::verify {
namespace {

using data::Friction;
using fast::ConvergedElasticNip;

constexpr double third = 1.0 / 3;

std::string ratio_text(double poisson) { return poisson == third ? "1/3" : fmt::format("{}", poisson); }

/// |chi_0| - |chi_inf| over the sum of their sizes.
Propagated creep_excess(double length_over_thickness) {
  const Propagated without = fabs(nip_of_length(length_over_thickness, Friction::none, third).creep_ratio());
  const Propagated with = fabs(nip_of_length(length_over_thickness, Friction::full, third).creep_ratio());
  return (without - with) / (without + with);
}

ClaimOutcome creep_with_friction() {
  ClaimOutcome outcome{ClaimVerdict::fails, "", {}};
  for (const double load : {100.0, 200.0}) {
    for (const Friction friction : {Friction::none, Friction::full})
      outcome.numbers.push_back(
          {fmt::format("chi_{}, B = 0.25 in, W = {} lbf/in", friction == Friction::none ? "0" : "inf", load),
           thesis_nip(0.25, load, friction).creep_ratio()});
  }
  if (!(fabs(outcome.numbers[3].number) - fabs(outcome.numbers[2].number)).is_positive())
    outcome.verdict = ClaimVerdict::holds;
  // Thin, thick and in between, where the two creeps vanish one after the other.
  const Propagated from = sign_change(creep_excess, 0.3, 0.55), to = sign_change(creep_excess, 0.8, 3);
  outcome.why = fmt::format("at nu = 1/3 |chi_inf| is the larger one for L/B between {:.4f} and {:.4f}",
                            from.value(), to.value());
  outcome.numbers.push_back({"L/B from which |chi_inf| is the larger one, nu = 1/3", from});
  outcome.numbers.push_back({"L/B to which it is", to});
  return outcome;
}

/// A result without friction, with it, and by how much friction changes it.
struct Change {
  Propagated without, with;
  [[nodiscard]] Propagated share() const { return (with - without) / without; }
};

using Result = fast::Estimate (ConvergedElasticNip::*)() const;

Change change_of(Result result, double thickness, double load,
                 double poisson = data::seed::sheet_of_the_tables.poisson) {
  return {(thesis_nip(thickness, load, Friction::none, poisson).*result)(),
          (thesis_nip(thickness, load, Friction::full, poisson).*result)()};
}

/// Friction changes the results of a thin sheet by less than `most`, at the thesis's ratio of Poisson and of an
/// incompressible one.
ClaimOutcome changes_less(const std::vector<std::pair<std::string, Result>>& results, double most) {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  bool holds_there = true, holds_everywhere = true;
  for (const auto& [name, result] : results) {
    for (const double poisson : {data::seed::sheet_of_the_tables.poisson, 0.5}) {
      const Propagated share = change_of(result, 0.005, 100, poisson).share();
      outcome.numbers.push_back(
          {fmt::format("change of the {}, B = 0.005 in, W = 100 lbf/in, nu = {}", name, ratio_text(poisson)),
           share});
      (poisson < 0.5 ? holds_there : holds_everywhere) &= std::fabs(share.value()) < most;
    }
  }
  if (!holds_there) {
    outcome.verdict = ClaimVerdict::fails;
    outcome.why = "false at the thesis's own ratio of Poisson";
  } else if (!holds_everywhere) {
    outcome.verdict = ClaimVerdict::holds_in_a_range;
    outcome.why = "holds at nu = 1/3, false where the sheet is incompressible";
  } else {
    outcome.why = "at nu = 1/3 and 1/2";
  }
  return outcome;
}

ClaimOutcome friction_on_length() {
  return changes_less({{"peak pressure", &ConvergedElasticNip::peak_pressure},
                       {"contact length", &ConvergedElasticNip::contact_length}},
                      0.1);
}

ClaimOutcome friction_on_indentation() {
  return changes_less({{"indentation", &ConvergedElasticNip::indentation}}, 0.2);
}

/// Friction changes a result with this sign on all sheets of the tables.
ClaimOutcome changes_with_sign(const std::string& name, Result result, double sign) {
  ClaimOutcome outcome{ClaimVerdict::holds, "on every sheet of the thesis's tables", {}};
  std::string against;
  int agreeing = 0;
  for (const double thickness : {1.0, 0.25, 0.0625, 0.005}) {
    const Change change = change_of(result, thickness, 100);
    outcome.numbers.push_back(
        {fmt::format("change of the {} by full friction, B = {} in, W = 100 lbf/in", name, thickness),
         change.share()});
    if ((sign * change.share()).is_positive())
      ++agreeing;
    else
      against += fmt::format(" B = {} in", thickness);
  }
  if (against.empty()) return outcome;
  outcome.verdict = agreeing > 0 ? ClaimVerdict::holds_in_a_range : ClaimVerdict::fails;
  outcome.why = "false at" + against;
  return outcome;
}

ClaimOutcome length_without_friction() {
  return changes_with_sign("contact length", &ConvergedElasticNip::contact_length, -1);
}

ClaimOutcome peak_without_friction() {
  return changes_with_sign("peak pressure", &ConvergedElasticNip::peak_pressure, 1);
}

ClaimOutcome sign_of_creep() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  for (const double poisson : {0.25, third, 0.45, 0.49}) {
    for (const Friction friction : {Friction::none, Friction::full}) {
      const Propagated zero = sign_change(
          [&](double length) { return nip_of_length(length, friction, poisson).creep_ratio(); }, 0.005, 3);
      outcome.numbers.push_back({fmt::format("L/B at which the creep vanishes, nu = {}, {} friction",
                                             ratio_text(poisson), friction == Friction::none ? "no" : "full"),
                                 zero});
    }
  }
  const Propagated thick = nip_of_length(0.005, Friction::none, third).creep_ratio(),
                   incompressible = nip_of_length(1e-3, Friction::none, 0.5).creep_ratio(),
                   auxetic = nip_of_length(100, Friction::none, -0.5).creep_ratio();
  outcome.numbers.push_back({"creep of a thick sheet, R = 100.5 b, nu = 1/3, L/B = 0.005", thick});
  outcome.numbers.push_back({"the same of an incompressible one, R = 100.1 b, L/B = 0.001", incompressible});
  outcome.numbers.push_back({"creep of a thin sheet, R = 10100 b, nu = -1/2, L/B = 100", auxetic});
  outcome.why = "with one change of sign for nu between 0.25 and 0.49";
  if (!thick.is_negative()) {
    outcome.verdict = ClaimVerdict::fails;
  } else if (incompressible.is_positive() || auxetic.is_negative()) {
    outcome.verdict = ClaimVerdict::holds_in_a_range;
    if (incompressible.is_positive()) outcome.why += "; an incompressible thick sheet creeps forward";
    if (auxetic.is_negative()) outcome.why += "; a thin sheet with nu < 0 creeps backward";
  }
  return outcome;
}

/// d ln W/d ln L of one roller
Propagated load_exponent(double length_over_thickness, Friction friction, double poisson) {
  constexpr double accuracy = 1e-13, step = 0.25;
  const data::ElasticNip nip{100 * (1 + length_over_thickness), 2, {1, poisson}};
  return derivative(
      [&](double log_of_length) {
        const double length = length_over_thickness * std::exp(log_of_length);
        const Propagated load = fast::converged_for_length(nip, friction, 2 * length, accuracy).load();
        // No load grows faster than L^5: what rounding of the length makes of it.
        return log(load) + Propagated(0, 5 * 0x1p-51);
      },
      0, step);
}

ClaimOutcome load_as_cube() {
  struct Sheet {
    double length;
    Friction friction;
    double poisson;
  };
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  double least = 10, most = 0;
  for (const Sheet& sheet : {Sheet{0.01, Friction::none, third},
                             {1, Friction::none, third},
                             {100, Friction::none, third},
                             {100, Friction::full, third},
                             {100, Friction::full, 0.5}}) {
    const Propagated exponent = load_exponent(sheet.length, sheet.friction, sheet.poisson);
    outcome.numbers.push_back(
        {fmt::format("d ln W/d ln L, L/B = {}, nu = {}, {} friction", sheet.length, ratio_text(sheet.poisson),
                     sheet.friction == Friction::none ? "no" : "full"),
         exponent});
    least = std::min(least, exponent.value());
    most = std::max(most, exponent.value());
  }
  outcome.why = fmt::format("the exponent is {:.2f} to {:.2f}: 2 on thick sheets, 3 on springs, 5 in a film",
                            least, most);
  constexpr double agreement = 0.1;
  if (least < 3 - agreement || most > 3 + agreement) outcome.verdict = ClaimVerdict::fails;
  return outcome;
}

}  // namespace

ClaimChecks friction_claims() {
  return {{"thesis-load-as-cube", load_as_cube},
          {"thesis-creep-with-friction", creep_with_friction},
          {"thesis-friction-on-length", friction_on_length},
          {"thesis-friction-on-indentation", friction_on_indentation},
          {"thesis-length-without-friction", length_without_friction},
          {"thesis-peak-without-friction", peak_without_friction},
          {"thesis-sign-of-creep", sign_of_creep}};
}

}  // namespace nipref::verify
