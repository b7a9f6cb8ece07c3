#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include <nipref/data/directory.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {
namespace {

/// For roff, which takes a hyphen for one that is to be read, and a dot or an apostrophe at a line's start for a
/// command.
std::string roff(std::string_view text) {
  std::string escaped;
  for (char before = '\n'; const char letter : text) {
    if (before == '\n' && (letter == '.' || letter == '\'')) escaped += "\\&";
    if (letter == '-') {
      escaped += "\\-";
    } else if (letter == '\\') {
      escaped += "\\e";
    } else {
      escaped += letter;
    }
    before = letter;
  }
  return escaped;
}

Json entry_json(const std::string& name, const std::string& meaning) {
  return {{"name", roff(name)}, {"meaning", roff(meaning)}};
}

Json verb_json(const VerbText& verb) {
  std::vector<Json> entries;
  if (!verb.words.empty()) entries.push_back(entry_json(verb.words + " ...", verb.meaning_of_words));
  for (const OptionText& option : verb.options)
    entries.push_back(entry_json(names_of(option) + " " + option.name, help_of(option)));
  for (const OptionText& flag : verb.flags) entries.push_back(entry_json("--" + flag.name, flag.meaning));
  return {{"name", roff(verb.name)},
          {"meaning", roff(verb.meaning)},
          {"entries", entries},
          {"examples", json_list(verb.examples, roff)}};
}

/// Names that a verb's words may be, of those that are known here.
std::vector<std::string> names_for(const VerbText& verb) {
  std::vector<std::string> names;
  if (verb.words == "action") names.assign(golden_actions.begin(), golden_actions.end());
  if (verb.words == "quantity" || verb.words == "file" || verb.words == "action") {
    for (const Quantity& quantity : catalogue()) names.push_back(quantity.name);
  } else if (verb.words == "table") {
    names = replayable_tables();
  } else if (verb.words == "scene") {
    for (const auto& file : std::filesystem::directory_iterator(data::scenes_directory()))
      if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
    std::ranges::sort(names);
  }
  return names;
}

/// A verb and the words that may follow it.
Json completion_json(const VerbText& verb) {
  std::vector<std::string> words = names_for(verb);
  for (const auto* const group : {&verb.options, &verb.flags}) {
    for (const OptionText& option : *group) words.push_back("--" + option.name);
  }
  return {{"name", verb.name}, {"words", fmt::format("{}", fmt::join(words, " "))}};
}

/// A quantity and its arguments, as they are begun.
Json arguments_json(const Quantity& quantity) {
  std::string words;
  for (const Argument& argument : quantity.arguments) words += " " + argument.name + "=";
  return {{"name", quantity.name}, {"words", words}};
}

}  // namespace

std::string manual_page() {
  return text_of("nipref.1", {{"meaning", roff(program_meaning())},
                              {"verbs", json_list(verbs(), verb_json)},
                              {"exit_statuses", roff(exit_statuses())}});
}

std::string completion_for(const std::string& shell) {
  return text_of("nipref." + shell, {{"verbs", json_list(verbs(), completion_json)},
                                     {"quantities", json_list(catalogue(), arguments_json)}});
}

}  // namespace nipref::verify
