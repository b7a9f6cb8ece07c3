#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

std::vector<Statement> statements_in(const std::vector<TomlTable>& list) {
  return mapped(list, [](const TomlTable& one) { return Statement{one.text("id"), &one}; });
}

Json texts_json(const TomlTable& entry, std::initializer_list<const char*> keys) {
  return json_object(mapped(keys, [&](const char* key) { return std::pair(key, entry.text(key)); }));
}

/// Sets the decimals of a number and of its error, and their text for people; all are null without a number.
void set_number(Json& row, const std::string& key, std::string_view error_key,
                const std::optional<Propagated>& number) {
  const Stated decimals = number ? stated(*number) : Stated{};
  row.set(key, number ? Json::number(decimals.value) : Json());
  row.set(error_key, number ? Json::number(decimals.error) : Json());
  row.set("_" + key, number ? Json(stated_text(*number)) : Json());
}

/// In the order of the enumeration.
constexpr std::string_view claim_verdicts[] = {"holds", "false", "holds in a range"};

/// `text` with the values of the formulas in it, {FORMULA:FORMAT}.
std::string with_values(const std::string& text, StatementFormulas& formulas) {
  return with_fields(text, [&](const std::string& formula, const std::string& format) {
    return fmt::format(fmt::runtime("{" + format + "}"), formulas.value(formula).value());
  });
}

Json number_json(const ClaimNumber& one) {
  Json number{{"what", one.what},
              {"value", Json()},
              {"error", Json()},
              {"origin", one.origin()},
              {"_stated", stated_text(one.number) + (one.origin() == "exact" ? ", exactly" : "")}};
  set_number(number, "value", "error", one.number);
  return number;
}

}  // namespace

std::string_view name_of(ClaimVerdict verdict) { return claim_verdicts[static_cast<std::size_t>(verdict)]; }

std::string_view ClaimNumber::origin() const {
  if (is_printed) return "printed";
  return number.error() == 0 ? "exact" : "computed";
}

std::vector<Statement> claims() {
  return statements_in(
      statements_file("claims.toml")
          .list("claim", {"id", "seed", "place", "statement"}, {"setting", "given", "number", "verdict"}));
}

CheckedClaim check(const Statement& claim) {
  const TomlTable& entry = *claim.entry;
  StatementFormulas formulas(statements_file("claims.toml"), entry);
  CheckedClaim checked{claim};
  for (const TomlTable& one : entry.list("number", {"what", "is"}, {"name", "origin"})) {
    const Propagated number = formulas.value(one.text("is"));
    if (const std::string name = one.text_or("name", ""); !name.empty()) formulas.define(name, number);
    checked.numbers.push_back({one.text("what"), number, one.text_or("origin", "") == "printed"});
  }
  for (const TomlTable& one : entry.list("verdict", {"is"}, {"if", "why"})) {
    if (!formulas.is_true(one.text_or("if", "1"))) continue;
    const auto* const verdict = std::ranges::find(claim_verdicts, one.text("is"));
    if (verdict == std::end(claim_verdicts)) one.refuse("must be holds, false or holds in a range");
    checked.verdict = static_cast<ClaimVerdict>(verdict - std::begin(claim_verdicts));
    checked.why = with_values(one.text_or("why", ""), formulas);
    return checked;
  }
  entry.refuse("must have a [[claim.verdict]] whose condition is fulfilled");
}

std::vector<CheckedClaim> check_all(const std::vector<Statement>& claims) {
  return parallel_mapped(claims.size(), [&](std::size_t i) { return check(claims[i]); });
}

Json claims_json(const std::vector<CheckedClaim>& claims) {
  return json_list(claims, [](const CheckedClaim& checked) {
    Json row = texts_json(*checked.claim.entry, {"id", "seed", "place", "statement"});
    row.append({{"verdict", name_of(checked.verdict)},
                {"why", Json::unless_empty(checked.why)},
                {"numbers", json_list(checked.numbers, number_json)},
                {"_fails", checked.verdict == ClaimVerdict::fails}});
    return row;
  });
}

Json verdict_counts_json(const std::vector<CheckedClaim>& claims, const std::vector<ClaimVerdict>& verdicts) {
  return json_list(verdicts, [&](ClaimVerdict verdict) {
    return Json{{"verdict", name_of(verdict)},
                {"count", std::ranges::count(claims, verdict, &CheckedClaim::verdict)}};
  });
}

Propagated LimitSample::distance() const { return fabs(found - limit) / fabs(limit); }

std::optional<Propagated> LimitRow::measured_order() const {
  const LimitSample &before = *std::prev(samples.end(), 2), &last = samples.back();
  if (!last.distance().is_positive()) return {};
  return log(before.distance() / last.distance()) /
         log(Propagated::exact(before.size) / Propagated::exact(last.size));
}

bool LimitRow::approached() const {
  constexpr double agreement = 0.1, faster_than_powers = 4, told_apart = 0.01;
  const Propagated last = samples.back().distance();
  const std::optional<Propagated> measured = measured_order();
  if (order == 0) return !measured || measured->value() > faster_than_powers;
  return measured && last.error() < told_apart * last.value() &&
         std::fabs(measured->value() - order) <= agreement;
}

std::vector<Statement> limits() {
  return statements_in(statements_file("limits.toml")
                           .list("limit", {"id", "statement", "source", "size", "found", "limit"},
                                 {"order", "first", "setting", "given"}));
}

LimitRow approach(const Statement& limit) {
  constexpr int sizes = 3;
  const TomlTable& entry = *limit.entry;
  LimitRow row{limit.id, entry.text("statement"), entry.text("source"), entry.text("size"),
               entry.number("order")};
  StatementFormulas formulas(statements_file("limits.toml"), entry);
  for (int k = 0; k < sizes; ++k) {
    const double size = std::ldexp(entry.number("first"), -k);
    formulas.define("s", Propagated::exact(size));
    row.samples.push_back({size, formulas.value(entry.text("found")), formulas.value(entry.text("limit"))});
  }
  return row;
}

std::vector<LimitRow> approach_all(const std::vector<Statement>& limits) { return mapped(limits, approach); }

Json limits_json(const std::vector<LimitRow>& limits) {
  return json_list(limits, [](const LimitRow& limit) {
    Json row{{"name", limit.name},
             {"statement", limit.statement},
             {"source", limit.source},
             {"size", limit.size},
             {"order", limit.order == 0 ? Json() : Json(limit.order)}};
    const auto measured = limit.measured_order();
    set_number(row, "measured_order", "measured_order_error", measured);
    row.set("approached", limit.approached());
    row.set(
        "samples", json_list(limit.samples, [&](const LimitSample& sample) {
          Json numbers{{"size", sample.size}, {"_size", limit.size}, {"_apart", sample.distance().value()}};
          set_number(numbers, "found", "found_error", sample.found);
          set_number(numbers, "limit", "limit_error", sample.limit);
          set_number(numbers, "distance", "distance_error", sample.distance());
          return numbers;
        }));
    return row;
  });
}

bool Settlement::settled() const {
  const auto are_apart = [&](const Propagated& other) {
    const double allowed = other.error() + truth.error();
    return !(std::fabs(other.value() - truth.value()) <= allowed);
  };
  return !are_apart(right) && (!printed || are_apart(*printed));
}

std::vector<Statement> formula_errata() {
  return statements_in(
      statements_file("errata.toml")
          .list("erratum", {"id", "seed", "equation", "printed", "right", "proof"},
                {"quantity", "setting", "given", "at", "printed_value", "right_value", "truth"}));
}

Settlement settle(const Statement& erratum) {
  const TomlTable& entry = *erratum.entry;
  StatementFormulas formulas(statements_file("errata.toml"), entry);
  if (const std::string quantity = entry.text_or("quantity", ""); !quantity.empty()) {
    const auto by = [&](const char* kind) { return formulas.value(fmt::format("[{} {}]", kind, quantity)); };
    return {quantity, by("printed"), by("fast"), by("ref"), erratum};
  }
  std::optional<Propagated> printed;
  if (const std::string formula = entry.text_or("printed_value", ""); !formula.empty())
    printed = formulas.value(formula);
  return {entry.text("at") + formulas.setting(), printed, formulas.value(entry.text("right_value")),
          formulas.value(entry.text("truth")), erratum};
}

std::vector<Settlement> settle_all(const std::vector<Statement>& errata) { return mapped(errata, settle); }

Json errata_json(const std::vector<Settlement>& errata) {
  return json_list(errata, [](const Settlement& one) {
    Json row = texts_json(*one.erratum.entry, {"id", "seed", "equation", "printed", "right", "proof"});
    row.set("at", one.at);
    set_number(row, "printed_value", "printed_error", one.printed);
    set_number(row, "right_value", "right_error", one.right);
    set_number(row, "truth", "truth_error", one.truth);
    row.set("settled", one.settled());
    return row;
  });
}

}  // namespace nipref::verify
