#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include <nipref/data/directory.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
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

std::string entry(const std::string& name, const std::string& meaning) {
  return fmt::format(".TP\n.B {}\n{}\n", roff(name), roff(meaning));
}

std::string verb_of_page(const VerbText& verb) {
  std::string text = fmt::format(".SS {}\n{}\n", roff(verb.name), roff(verb.meaning));
  if (!verb.words.empty()) text += entry(verb.words + " ...", verb.meaning_of_words);
  for (const OptionText& option : verb.options)
    text += entry(names_of(option) + " " + option.name, help_of(option));
  for (const OptionText& flag : verb.flags) text += entry("--" + flag.name, flag.meaning);
  text += ".PP\nExamples:\n.PP\n.EX\n";
  for (const std::string& example : verb.examples) text += roff(example) + "\n";
  return text + ".EE\n";
}

/// Names that a verb's words may be, of those that are known here.
std::vector<std::string> names_for(const VerbText& verb) {
  std::vector<std::string> names;
  if (verb.words == "quantity") {
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

std::string case_of_completion(const VerbText& verb) {
  std::vector<std::string> words = names_for(verb);
  for (const auto* const group : {&verb.options, &verb.flags}) {
    for (const OptionText& option : *group) words.push_back("--" + option.name);
  }
  return fmt::format("    {}) words=\"{}\" ;;\n", verb.name, fmt::join(words, " "));
}

}  // namespace

std::string manual_page() {
  std::string text = fmt::format(
      ".TH NIPREF 1\n.SH NAME\nnipref \\- verification reference for rolling contact\n.SH SYNOPSIS\n.B nipref\n"
      ".I verb\n[\n.I name ...\n] [\n.I name=value ...\n] [\n.I options\n]\n.SH DESCRIPTION\n{}\n.PP\n"
      "An option may be given as name=value as well.\n.SH VERBS\n",
      roff(program_meaning()));
  for (const VerbText& verb : verbs()) text += verb_of_page(verb);
  return text + fmt::format(".SH EXIT STATUS\n{}\n", roff(exit_statuses()));
}

std::string bash_completion() {
  std::vector<std::string> first;
  std::string cases;
  for (const VerbText& verb : verbs()) {
    first.push_back(verb.name);
    cases += case_of_completion(verb);
  }
  for (const Quantity& quantity : catalogue()) first.push_back(quantity.name);
  return fmt::format(
      "# bash completion for nipref\n_nipref() {{\n  local word=${{COMP_WORDS[COMP_CWORD]}} words=\n"
      "  case $([ \"$COMP_CWORD\" -gt 1 ] && echo \"${{COMP_WORDS[1]}}\") in\n    \"\") words=\"{} help\" ;;\n{}"
      "    help) words=\"{}\" ;;\n  esac\n  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}}\n"
      "complete -o default -F _nipref nipref\n",
      fmt::join(first, " "), cases,
      fmt::join(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(verbs().size()), " "));
}

}  // namespace nipref::verify
