#include <algorithm>
#include <cmath>
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

namespace {

/// From 1 to `most`; `unsaid` if the option is not there.
std::size_t count_option(const CommandLine& line, const std::string& name, long most, std::size_t unsaid) {
  const auto text = line.option(name);
  if (!text) return unsaid;
  const double count = parse_real(name, *text);
  if (count < 1 || count > static_cast<double>(most) || count != std::floor(count))
    throw BadInput(name, *text, "must be a whole number from 1 to " + std::to_string(most));
  return static_cast<std::size_t>(count);
}

}  // namespace

std::size_t points_option(const CommandLine& line) { return count_option(line, "points", 100'000'000, 0); }

std::size_t scenes_option(const CommandLine& line) { return count_option(line, "scenes", 1'000'000, 300); }

std::string seed_option(const CommandLine& line) { return line.option("seed").value_or("1"); }

void refuse_option(const CommandLine& line, const std::string& name, const std::string& why) {
  if (line.option(name) || line.has(name)) throw BadInput(name, line.option(name).value_or("(given)"), why);
}

bool Selection::has(std::string_view group) const { return std::ranges::find(groups, group) != groups.end(); }

Selection selection(const CommandLine& line, const std::vector<std::string_view>& groups) {
  if (line.words.empty()) return {select_quantities({}), groups};
  Selection selected;
  for (const std::string& word : line.words) {
    const auto group = std::ranges::find(groups, word);
    const Quantity* const quantity = known_quantity(word);
    if (quantity == nullptr && group == groups.end()) refuse_quantity(word, groups);
    if (quantity != nullptr) {
      if (std::ranges::find(selected.quantities, quantity) == selected.quantities.end())
        selected.quantities.push_back(quantity);
    } else if (!selected.has(*group)) {
      selected.groups.push_back(*group);
    }
  }
  return selected;
}

}  // namespace nipref::verify
