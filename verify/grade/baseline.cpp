#define TOML_HEADER_ONLY 1
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/data/toml_obstacle.hpp>
#include <nipref/verify/grade/baseline.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr auto list_name = "graded";
constexpr double tolerated_factor = 1.5;
constexpr double tolerated_ulps = 0.25;  // so that a tiny error may change a little

[[noreturn]] void refuse_entry(const std::string& path, const toml::node& node,
                               const std::string& requirement) {
  throw BadInput("baseline", fmt::format("{}:{}", path, node.source().begin.line), requirement);
}

/// The texts of a key, as the file names them.
constexpr std::pair<std::string_view, std::string BaselineKey::*> texts[] = {
    {"what", &BaselineKey::what},         {"quantity", &BaselineKey::quantity},
    {"where", &BaselineKey::where},       {"seed", &BaselineKey::seed},
    {"compiler", &BaselineKey::compiler}, {"instruction_set", &BaselineKey::instruction_set}};

Baseline::Entry entry_of(const std::string& path, const toml::table& table) {
  const auto get = [&]<class Value>(std::string_view key, Value) {
    const auto value = table[key].value_exact<Value>();
    if (!value)
      refuse_entry(path, table, fmt::format("must have {} of its kind in each [[{}]]", key, list_name));
    return *value;
  };
  Baseline::Entry entry{};
  for (const auto& [name, member] : texts) entry.key.*member = get(name, std::string());
  entry.key.points = static_cast<std::size_t>(std::max<std::int64_t>(0, get("points", std::int64_t{})));
  entry.key.sampler = static_cast<int>(get("sampler", std::int64_t{}));
  entry.max_error_ulp = get("max_error_ulp", double{});
  entry.reason = get("reason", std::string());
  if (!(entry.max_error_ulp >= 0)) refuse_entry(path, table, "must have a max_error_ulp >= 0");
  return entry;
}

toml::table table_of(const Baseline::Entry& entry) {
  toml::table table{{"points", static_cast<std::int64_t>(entry.key.points)},
                    {"sampler", entry.key.sampler},
                    {"max_error_ulp", entry.max_error_ulp},
                    {"reason", entry.reason}};
  for (const auto& [name, member] : texts) table.insert(name, entry.key.*member);
  return table;
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

Baseline Baseline::read(const std::string& path) try {
  Baseline baseline;
  const std::string text = data::text_of_input_file(path, "baseline");
  if (const auto obstacle = data::toml_obstacle(text))
    throw BadInput("baseline", fmt::format("{}:{}", path, obstacle->line), std::string(obstacle->allowed));
  const toml::table file = toml::parse(text);
  for (const auto& [key, node] : file) {
    if (key.str() != list_name || !node.is_array_of_tables())
      refuse_entry(path, node, fmt::format("must hold [[{}]] alone", list_name));
    for (const toml::node& item : *node.as_array())
      baseline.entries.push_back(entry_of(path, *item.as_table()));
  }
  return baseline;
} catch (const toml::parse_error& error) {
  throw BadInput("baseline", fmt::format("{}:{}", path, error.source().begin.line),
                 fmt::format("must be TOML: {}", error.description()));
}

std::string Baseline::text() const {
  toml::array list;
  for (const Entry& entry : entries) list.push_back(table_of(entry));
  std::ostringstream text;
  text << toml::table{{list_name, list}} << "\n";
  return text.str();
}

BaselineComparison compare_with(const Baseline& baseline, const BaselineKey& key, double max_error_ulp) {
  const auto found = find(baseline.entries, key);
  if (found != baseline.entries.end()) {
    const double limit = tolerated_factor * found->max_error_ulp + tolerated_ulps;
    return {
        max_error_ulp <= limit ? Comparison::not_worse : Comparison::worse,
        fmt::format("was {:.4g} ulp, may be {:.4g}, is {:.4g}", found->max_error_ulp, limit, max_error_ulp)};
  }
  const auto other = std::ranges::find_if(baseline.entries, [&](const Baseline::Entry& entry) {
    return entry.key.what == key.what && entry.key.quantity == key.quantity && entry.key.where == key.where;
  });
  return {Comparison::not_comparable,
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
    return compare_with(baseline, key, max_error_ulp).comparison == Comparison::not_worse;
  if (max_error_ulp > found->max_error_ulp) found->reason = *reason;
  found->max_error_ulp = max_error_ulp;
  return true;
}

}  // namespace nipref::verify
