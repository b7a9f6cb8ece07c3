#include <nipref/verify/grade/baseline.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {
namespace {

constexpr auto list_name = "graded";
constexpr double tolerated_factor = 1.5;
constexpr double tolerated_ulps = 0.25;  // so that a tiny error may change a little

/// The texts of a key, as the file names them.
constexpr std::pair<const char*, std::string BaselineKey::*> texts[] = {
    {"what", &BaselineKey::what},         {"quantity", &BaselineKey::quantity},
    {"where", &BaselineKey::where},       {"seed", &BaselineKey::seed},
    {"compiler", &BaselineKey::compiler}, {"instruction_set", &BaselineKey::instruction_set}};

Baseline::Entry entry_of(const TomlTable& table) {
  Baseline::Entry entry{{}, table.number("max_error_ulp"), table.text("reason")};
  for (const auto& [name, member] : texts) entry.key.*member = table.text(name);
  entry.key.points = static_cast<std::size_t>(std::max(0.0, table.number("points")));
  entry.key.sampler = static_cast<int>(table.number("sampler"));
  if (!(entry.max_error_ulp >= 0)) table.refuse("must have a max_error_ulp >= 0");
  return entry;
}

/// TOML writes a text in quotes as JSON does.
std::string text_of(const Baseline::Entry& entry) {
  std::string text = fmt::format("[[{}]]\n", list_name);
  for (const auto& [name, member] : texts)
    text += fmt::format("{} = {}\n", name, Json(entry.key.*member).line());
  return text + fmt::format("points = {}\nsampler = {}\nmax_error_ulp = {}\nreason = {}\n", entry.key.points,
                            entry.key.sampler, entry.max_error_ulp, Json(entry.reason).line());
}

auto find(auto& entries, const BaselineKey& key) {
  return std::ranges::find_if(entries, [&](const Baseline::Entry& entry) { return entry.key == key; });
}

/// The first part in which the keys differ, in words.
std::string difference(const BaselineKey& before, const BaselineKey& now) {
  const auto words = [](std::string_view name, const auto& old_one, const auto& new_one) {
    return fmt::format("{} was {}, is {}", name, old_one, new_one);
  };
  if (before.seed != now.seed) return words("seed", before.seed, now.seed);
  if (before.points != now.points) return words("points", before.points, now.points);
  if (before.sampler != now.sampler) return words("sampler", before.sampler, now.sampler);
  if (before.compiler != now.compiler) return words("compiler", before.compiler, now.compiler);
  return words("instruction set", before.instruction_set, now.instruction_set);
}

}  // namespace

Baseline Baseline::read(const std::string& path) {
  const TomlTable file = read_toml(path, "baseline");
  const std::size_t lists = file.tables.count(list_name);
  if (file.keys.size() > lists) file.refuse(fmt::format("must hold [[{}]] alone", list_name));
  return {lists == 0 ? std::vector<Entry>() : mapped(file.tables.at(list_name), entry_of)};
}

std::string Baseline::text() const {
  std::string text;
  for (const Entry& entry : entries) text += (text.empty() ? "" : "\n") + text_of(entry);
  return text;
}

BaselineComparison compare_with(const Baseline& baseline, const BaselineKey& key, double max_error_ulp) {
  const auto found = find(baseline.entries, key);
  if (found != baseline.entries.end()) {
    const double limit = tolerated_factor * found->max_error_ulp + tolerated_ulps;
    return {
        max_error_ulp <= limit ? "not worse" : "WORSE",
        fmt::format("was {:.4g} ulp, may be {:.4g}, is {:.4g}", found->max_error_ulp, limit, max_error_ulp)};
  }
  const auto other = std::ranges::find_if(baseline.entries, [&](const Baseline::Entry& entry) {
    return entry.key.what == key.what && entry.key.quantity == key.quantity && entry.key.where == key.where;
  });
  return {"not comparable",
          other == baseline.entries.end()
              ? fmt::format("{} as {}, {}, is not in the baseline", key.what, key.quantity, key.where)
              : difference(other->key, key)};
}

bool update(Baseline& baseline, const BaselineKey& key, double max_error_ulp,
            const std::optional<std::string>& reason) {
  const auto found = find(baseline.entries, key);
  if (found == baseline.entries.end()) {
    baseline.entries.push_back({key, max_error_ulp, reason.value_or("")});
    return true;
  }
  if (max_error_ulp > found->max_error_ulp && !reason)
    return compare_with(baseline, key, max_error_ulp).kept();
  if (max_error_ulp > found->max_error_ulp) found->reason = *reason;
  found->max_error_ulp = max_error_ulp;
  return true;
}

}  // namespace nipref::verify
