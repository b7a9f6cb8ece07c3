#include <nipref/data/directory.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {
namespace {

/// Escapes a text for roff, which prints a plain hyphen as a typographic one, and takes a dot or an apostrophe at the
/// start of a line for a command.
std::string roff(const std::string& text) {
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

/// The known names that may be words of a verb.
std::vector<std::string> names_for(const VerbText& verb) {
  const std::string words = verb.text("words");
  std::vector<std::string> names;
  if (words == "action") names.assign(golden_actions.begin(), golden_actions.end());
  if (words == "quantity" || words == "file" || words == "action") {
    for (const Quantity& quantity : catalogue()) names.push_back(quantity.name);
  } else if (words == "table") {
    names = replayable_tables();
  } else if (words == "scene") {
    for (const auto& file : std::filesystem::directory_iterator(data::scenes_directory()))
      if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
    std::ranges::sort(names);
  }
  return names;
}

/// "-o,--output output", or the name of a flag.
Json option_json(const OptionText& option) {
  const std::string letter = option.letter().empty() ? "" : "-" + option.letter() + ",";
  return {{"names", letter + "--" + option.name + (option.is_flag ? "" : " " + option.name)},
          {"assigned", option.is_flag ? Json() : Json(option.name)},
          {"meaning", help_of(option)}};
}

/// A verb, and the words that may follow it.
Json verb_json(const VerbText& verb) {
  std::vector<std::string> words = names_for(verb);
  for (const OptionText& option : verb.options) words.push_back("--" + option.name);
  return {{"name", verb.name},
          {"meaning", verb.text("meaning")},
          {"positional", Json::unless_empty(verb.text("words"))},
          {"meaning_of_words", verb.text("meaning_of_words")},
          {"options", json_list(verb.options, option_json)},
          {"examples", json_list(verb.row.words_of("examples"))},
          {"exit_statuses", exit_statuses()},
          {"words", fmt::format("{}", fmt::join(words, " "))}};
}

/// A quantity, and "NAME=" for each of its arguments.
Json arguments_json(const Quantity& quantity) {
  std::string words;
  for (const Argument& argument : quantity.arguments) words += " " + argument.name + "=";
  return {{"name", quantity.name}, {"words", words}};
}

/// All that help, the manual and completions are made of.
Json manual_json() {
  return {{"meaning", program_meaning()},
          {"verbs", json_list(verbs(), verb_json)},
          {"quantities", json_list(catalogue(), arguments_json)},
          {"exit_statuses", exit_statuses()}};
}

}  // namespace

std::string program_help() { return text_of("help.txt", manual_json()); }
std::string help_of(const VerbText& verb) { return text_of("help_verb.txt", verb_json(verb)); }
std::string manual_page() { return text_of("nipref.1", manual_json(), roff); }
std::string completion_for(const std::string& shell) { return text_of("nipref." + shell, manual_json()); }

}  // namespace nipref::verify
