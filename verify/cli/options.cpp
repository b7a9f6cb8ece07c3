#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/options.hpp>

namespace nipref::verify {

using data::BadInput;

fast::Accuracy accuracy_option(const CommandLine& line) {
  const auto text = line.option("rtol");
  return text ? fast::Accuracy(parse_real("rtol", *text)) : fast::Accuracy();
}

std::size_t points_option(const CommandLine& line, std::size_t otherwise) {
  constexpr long most = 100'000'000;
  const auto text = line.option("points");
  if (!text) return otherwise;
  const long points = parse_integer("points", *text);
  if (points < 1 || points > most)
    throw BadInput("points", *text, "must be a whole number from 1 to 100000000");
  return static_cast<std::size_t>(points);
}

bool Selection::has(std::string_view group) const { return std::ranges::find(groups, group) != groups.end(); }

Selection selection(const CommandLine& line, std::initializer_list<std::string_view> groups) {
  if (line.words.empty()) return {select_quantities({}), groups};
  Selection selected;
  std::vector<std::string> names;
  for (const std::string& word : line.words) {
    const auto* group = std::ranges::find(groups, word);
    if (group == groups.end()) {
      names.push_back(word);
    } else {
      selected.groups.push_back(*group);
    }
  }
  for (const std::string& name : names) {
    if (std::ranges::find(catalogue(), name, &Quantity::name) == catalogue().end())
      throw BadInput("quantity", name,
                     fmt::format("must be one of {}, {}", quantity_names(), fmt::join(groups, ", ")));
  }
  if (!names.empty()) selected.quantities = select_quantities(names);
  return selected;
}

}  // namespace nipref::verify
