#include <optional>

#include <nipref/verify/seeds/claims.hpp>
#include <nipref/verify/seeds/errata.hpp>
#include <nipref/verify/seeds/limits.hpp>

namespace nipref::verify {
namespace {

/// The decimals of a number and of its error.
struct StatedJson {
  Json value, error;

  explicit StatedJson(const Propagated& number) : StatedJson(stated(number)) {}
  explicit StatedJson(const Stated& number)
      : value(Json::number(number.value)), error(Json::number(number.error)) {}
};

Json claim_number_json(const ClaimNumber& one) {
  const StatedJson number(one.number);
  return {{"what", one.what}, {"value", number.value}, {"error", number.error}, {"origin", one.origin()}};
}

Json claim_json(const CheckedClaim& checked) {
  const auto& [claim, outcome] = checked;
  return {{"id", claim.id},
          {"seed", claim.seed},
          {"place", claim.place},
          {"statement", claim.statement},
          {"verdict", name_of(outcome.verdict)},
          {"why", Json::unless_empty(outcome.why)},
          {"numbers", json_list(outcome.numbers, claim_number_json)}};
}

Json sample_json(const LimitSample& sample) {
  const StatedJson found(sample.found), limit(sample.limit), distance(sample.distance());
  return {{"size", sample.size},
          {"found", found.value},
          {"found_error", found.error},
          {"limit", limit.value},
          {"limit_error", limit.error},
          {"distance", distance.value},
          {"distance_error", distance.error}};
}

Json limit_json(const LimitRow& row) {
  std::optional<StatedJson> measured;
  if (const auto order = row.measured_order()) measured.emplace(*order);
  return {{"name", row.name},
          {"statement", row.statement},
          {"source", row.source},
          {"size", row.size},
          {"order", row.order == 0 ? Json() : Json(row.order)},
          {"measured_order", measured ? measured->value : Json()},
          {"measured_order_error", measured ? measured->error : Json()},
          {"approached", row.approached()},
          {"samples", json_list(row.samples, sample_json)}};
}

Json erratum_json(const SettledErratum& one) {
  const auto& [erratum, settlement] = one;
  std::optional<StatedJson> printed;
  if (settlement.printed) printed.emplace(*settlement.printed);
  const StatedJson right(settlement.right), truth(settlement.truth);
  return {{"id", erratum.id},
          {"seed", erratum.seed},
          {"equation", erratum.equation},
          {"printed", erratum.printed},
          {"right", erratum.right},
          {"proof", erratum.proof},
          {"at", settlement.at},
          {"printed_value", printed ? printed->value : Json()},
          {"printed_error", printed ? printed->error : Json()},
          {"right_value", right.value},
          {"right_error", right.error},
          {"truth", truth.value},
          {"truth_error", truth.error},
          {"settled", settlement.settled()}};
}

}  // namespace

Json claims_json(const std::vector<CheckedClaim>& claims) { return json_list(claims, claim_json); }
Json limits_json(const std::vector<LimitRow>& limits) { return json_list(limits, limit_json); }
Json errata_json(const std::vector<SettledErratum>& errata) { return json_list(errata, erratum_json); }

}  // namespace nipref::verify
