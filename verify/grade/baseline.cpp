#define TOML_HEADER_ONLY 1
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
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

/// Reads the keys of one entry.
struct EntryReader {
  const std::string& path;
  const toml::table& table;

  template <class Value>
  [[nodiscard]] Value get(std::string_view key) const {
    const auto value = table[key].value_exact<Value>();
    if (!value)
      refuse_entry(path, table, fmt::format("must have {} of its kind in each [[{}]]", key, list_name));
    return *value;
  }

  [[nodiscard]] Baseline::Entry entry() const {
    const auto error = get<double>("max_error_ulp");
    if (!(error >= 0)) refuse_entry(path, table, "must have a max_error_ulp >= 0");
    return {{get<std::string>("what"), get<std::string>("quantity"), get<std::string>("where"),
             get<std::string>("seed"),
             static_cast<std::size_t>(std::max<std::int64_t>(0, get<std::int64_t>("points"))),
             static_cast<int>(get<std::int64_t>("sampler")), get<std::string>("compiler"),
             get<std::string>("instruction_set")},
            error,
            get<std::string>("reason")};
  }
};

toml::table table_of(const Baseline::Entry& entry) {
  const BaselineKey& key = entry.key;
  return toml::table{{"what", key.what},
                     {"quantity", key.quantity},
                     {"where", key.where},
                     {"seed", key.seed},
                     {"points", static_cast<std::int64_t>(key.points)},
                     {"sampler", key.sampler},
                     {"compiler", key.compiler},
                     {"instruction_set", key.instruction_set},
                     {"max_error_ulp", entry.max_error_ulp},
                     {"reason", entry.reason}};
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
      baseline.entries.push_back(EntryReader{path, *item.as_table()}.entry());
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
