#include <nipref/verify/seeds/render.hpp>

namespace nipref::verify {
namespace {

Json claim_number_json(const ClaimNumber& number) {
  return {{"what", number.what}, {"value", number.value}, {"error", number.error}};
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
  return {{"size", sample.size},
          {"found", sample.found.value},
          {"found_error", sample.found.error},
          {"limit", sample.limit},
          {"distance", sample.distance()}};
}

Json limit_json(const LimitRow& row) {
  return {{"name", row.name},
          {"statement", row.statement},
          {"source", row.source},
          {"size", row.size},
          {"order", row.order == 0 ? Json() : Json(row.order)},
          {"measured_order", row.measured_order()},
          {"approached", row.approached()},
          {"samples", json_list(row.samples, sample_json)}};
}

Json erratum_json(const SettledErratum& one) {
  const auto& [erratum, settlement] = one;
  return {{"id", erratum.id},
          {"seed", erratum.seed},
          {"equation", erratum.equation},
          {"printed", erratum.printed},
          {"right", erratum.right},
          {"proof", erratum.proof},
          {"at", settlement.at},
          {"printed_value", settlement.printed ? Json(*settlement.printed) : Json()},
          {"right_value", settlement.right},
          {"truth", settlement.truth},
          {"allowed", settlement.allowed},
          {"settled", settlement.settled()}};
}

}  // namespace

Json claims_json(const std::vector<CheckedClaim>& claims) { return json_list(claims, claim_json); }
Json limits_json(const std::vector<LimitRow>& limits) { return json_list(limits, limit_json); }
Json errata_json(const std::vector<SettledErratum>& errata) { return json_list(errata, erratum_json); }

}  // namespace nipref::verify
