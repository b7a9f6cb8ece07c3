#include "verify/verb_options.hpp"

#include <vector>

#include "data/bad_input.hpp"
#include "verify/catalogue.hpp"

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

Selection selection(const CommandLine& line) {
  std::vector<std::string> names = line.words;
  const bool all = names.empty();
  const bool contacts = std::erase(names, "contact") > 0;
  const bool rolling = std::erase(names, "rolling") > 0;
  if (!all && names.empty()) return {{}, contacts, rolling};
  return {select_quantities(names), contacts || all, rolling || all};
}

}  // namespace nipref::verify
