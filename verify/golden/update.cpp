#include <fmt/format.h>

#include <cmath>
#include <optional>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/golden/update.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

/// Whether the scales differ by more than rounding errors.
bool is_other_scale(double before, double after) {
  return std::fabs(before - after) > 1e-12 * std::max(std::fabs(before), std::fabs(after));
}

/// Why the row has to change; empty if it stays.
std::string reason_to_change(const GoldenRow& before, const GoldenRow& after, bool all) {
  if (!Gap(before.number(), after.number()).is_covered()) return "another value";
  if (before.proven != after.proven) return "another status";
  if (is_other_scale(before.scale, after.scale)) return "another scale";
  return all ? "asked for" : "";
}

struct UpdatedRow {
  std::optional<ChangedRow> changed;
  std::optional<RefusedRow> refused;
};

UpdatedRow updated_row(const Quantity& quantity, const GoldenRow& before, std::size_t number, int digits,
                       bool all) {
  std::optional<ref::Estimate> reference;
  try {
    reference = ref_value(quantity, before.arguments, digits);
  } catch (const data::BadInput& refused) {
    return {{}, RefusedRow{before.arguments, fmt::format("the reference refuses it: {}", refused.what())}};
  }
  GoldenRow after = golden_row(quantity, before.arguments, *reference);
  after.origin = before.origin;
  std::string why = reason_to_change(before, after, all);
  if (why.empty()) return {};
  if (std::string reason = confirm_row(quantity, after); !reason.empty())
    return {{}, RefusedRow{before.arguments, std::move(reason)}};
  return {ChangedRow{number, before, std::move(after), std::move(why)}, {}};
}

}  // namespace

UpdatedGolden update_golden(const Quantity& quantity, const GoldenFile& file, bool all,
                            const Provenance& provenance, const OnProgress& progress) {
  const int digits = file.digits();
  std::vector<UpdatedRow> outcomes(file.rows.size());
  parallel_for(
      file.rows.size(),
      [&](std::size_t i) { outcomes[i] = updated_row(quantity, file.rows[i], i + 1, digits, all); },
      progress);
  UpdatedGolden updated{file, {}, {}};
  for (UpdatedRow& outcome : outcomes) {
    if (outcome.refused) updated.refused.push_back(*std::move(outcome.refused));
    if (!outcome.changed) continue;
    updated.file.rows[outcome.changed->row - 1] = outcome.changed->after;
    updated.changed.push_back(*std::move(outcome.changed));
  }
  if (!updated.changed.empty()) {
    updated.file.set("definition", quantity.definition);
    updated.file.set("unit", quantity.unit);
    updated.file.set("scale", quantity.scale);
    updated.file.set("updated", fmt::format("{} rows by {}, tree {}", updated.changed.size(),
                                            provenance.commit, provenance.clean ? "clean" : "dirty"));
  }
  return updated;
}

}  // namespace nipref::verify
