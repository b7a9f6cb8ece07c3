#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/seeds/internal/claim_checks.hpp>
#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/thesis_nip.hpp>
#include <nipref/verify/seeds/internal/thin_standard_solid.hpp>

// The thesis's viscoelastic nips, with the solid as it is defined.

namespace nipref::verify {
namespace {

/// memory: F0 tau, in.
fast::ConvergedViscoelasticNip thesis_rolling(double thickness, double load, double memory) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, memory);
  return fast::converged_for_load({thesis_radius, thickness, solid, 1}, load, claims_accuracy);
}

/// What f is at a place, which it changes with all one way.
Propagated at_place(const Function& f, const Propagated& place) {
  const Propagated below = f(place.value() - place.error()), above = f(place.value() + place.error());
  return below.value() < above.value() ? Propagated::between(below, above)
                                       : Propagated::between(above, below);
}

ClaimOutcome largest_resistance() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  double least = 1, most = 0;
  for (const double thickness : {1.0, 0.25, 0.0625, 0.005}) {
    for (const double load : {50.0, 200.0}) {
      const Propagated memory =
          largest([&](double at) { return thesis_rolling(thickness, load, at).rolling_resistance(); }, 1e-3,
                  1)
              .place;
      const Propagated share = at_place(
          [&](double at) {
            return Propagated::exact(at) / thesis_rolling(thickness, load, at).contact_length();
          },
          memory);
      const std::string where = fmt::format("of the largest mu_R, B = {} in, W = {} lbf/in", thickness, load);
      outcome.numbers.push_back({"F0 tau " + where + ", in", memory});
      outcome.numbers.push_back({"F0 tau/L " + where, share});
      least = std::min(least, memory.value());
      most = std::max(most, memory.value());
    }
  }
  const Largest thinnest =
      largest([](double memory) { return thin_standard_solid(memory).resistance; }, 0.1, 1);
  outcome.numbers.push_back({"F0 tau/L of the largest mu_R, B/L to 0", thinnest.place});
  outcome.numbers.push_back({"largest mu_R R/L, B/L to 0", thinnest.value});
  outcome.numbers.push_back(
      {"L1/L there",
       at_place([](double memory) { return thin_standard_solid(memory).leading_share; }, thinnest.place)});
  outcome.why = fmt::format("it is largest at F0 tau between {:.4f} and {:.4f} in", least, most);
  if (least < 1e-2 || most > 1e-1) outcome.verdict = ClaimVerdict::holds_in_a_range;
  return outcome;
}

ClaimOutcome resistance_of_short_memory() {
  constexpr double memory = 1e-4;
  const Propagated limit = memory / Propagated(2 * thesis_radius);
  ClaimOutcome outcome{ClaimVerdict::holds, "", {{"F0 tau/(2R), the limit of a short memory", limit}}};
  double farthest = 0;
  struct Case {
    const char* table;
    double load;
  };
  for (const Case& one :
       {Case{"thesis-XXIII", 50}, {"thesis-XXIV", 100}, {"thesis-XXV", 150}, {"thesis-XXVI", 200}}) {
    const data::Table table = data::load_table_by_id(one.table);
    const Propagated found = thesis_rolling(0.005, one.load, memory).rolling_resistance();
    outcome.numbers.push_back({fmt::format("mu_R, B = 0.005 in, W = {} lbf/in", one.load), found});
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const auto& key = table.cell(row, "F0_tau").number;
      const auto& printed = table.cell(row, "muR").number;
      if (!key || !printed || std::fabs(key->value / memory - 1) > 1e-6) continue;
      outcome.numbers.push_back(
          {fmt::format("printed in {}", one.table), Propagated::exact(printed->value), true});
      farthest = std::max(farthest, std::fabs(printed->value / found.value() - 1));
    }
  }
  outcome.why = fmt::format("the tables are off by up to {:.0f} %", 100 * farthest);
  if (farthest > 0.01) outcome.verdict = ClaimVerdict::fails;
  return outcome;
}

ClaimOutcome elastic_extremes() {
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  double farthest = 0;
  for (const double thickness : {1.0, 0.005}) {
    for (const double memory : {1e3, 1e-6}) {
      const auto nip = thesis_rolling(thickness, 100, memory);
      const Propagated share = Propagated(nip.leading_length()) / nip.contact_length();
      outcome.numbers.push_back(
          {fmt::format("L1/L, B = {} in, W = 100 lbf/in, F0 tau = {} in", thickness, memory), share});
      farthest = std::max(farthest, std::fabs(share.value() - 0.5));
    }
  }
  constexpr double printed_digits = 1e-3;
  outcome.why = fmt::format("L1/L differs from 1/2 by at most {:.1g}", farthest);
  if (farthest > printed_digits) outcome.verdict = ClaimVerdict::fails;
  return outcome;
}

}  // namespace

ClaimChecks rolling_claims() {
  return {{"thesis-largest-resistance", largest_resistance},
          {"thesis-resistance-of-short-memory", resistance_of_short_memory},
          {"thesis-elastic-extremes", elastic_extremes}};
}

}  // namespace nipref::verify
