#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

/// `nipref help eval` means `nipref eval --help`, `nipref help scene` means `nipref list scene`, and `nipref I1
/// alpha=0.73` means `nipref eval I1 alpha=0.73`.
std::vector<std::string> as_meant(std::vector<std::string> words) {
  if (words.empty()) return words;
  if (words.size() == 2 && words.front() == "help" && words.back() == "scene") return {"list", "scene"};
  if (words.front() == "help") {
    words.erase(words.begin());
    words.insert(words.empty() ? words.end() : words.begin() + 1, "--help");
  }
  if (known_quantity(words.front()) != nullptr) words.insert(words.begin(), "eval");
  return words;
}

/// The first word decides; a call for help is left to CLI11.
void refuse_what_is_unknown(const std::vector<std::string>& words) {
  const std::string first = words.empty() ? "(missing)" : words.front();
  if (first == "-h" || first == "--help" || first == "--version") return;
  const VerbText& verb = find_verb(first);
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (word.starts_with("--"))
      refuse_unknown_option(verb, word.substr(0, equals),
                            equals == std::string::npos ? "(given)" : word.substr(equals + 1));
  }
}

struct Raw {
  std::vector<std::string> words;
  std::map<std::string, std::string> options;
  std::map<std::string, bool> flags;
};

std::string footer_of(const VerbText& verb) {
  return fmt::format("\nExamples:\n  {}\n\n{}", fmt::join(verb.examples, "\n  "), exit_statuses());
}

void declare(CLI::App& app, const VerbText& verb, Raw& raw) {
  CLI::App* sub = app.add_subcommand(verb.name, verb.meaning);
  // A name with '=' in it is none to CLI11 from 2.4 on.
  sub->add_option(verb.words.empty() ? "option" : verb.words, raw.words, verb.meaning_of_words)
      ->option_text(verb.words.empty() ? "name=value ..." : "...");
  for (const OptionText& option : verb.options) {
    sub->add_option(names_of(option), raw.options[option.name],
                    help_of(option) + "; also " + option.name + "=...");
  }
  for (const OptionText& flag : verb.flags)
    sub->add_flag("--" + flag.name, raw.flags[flag.name], flag.meaning);
  sub->footer(footer_of(verb));
}

[[noreturn]] void refuse_assignment(const VerbText& verb, const std::string& name, const std::string& value) {
  const auto known = mapped<std::string_view>(verb.options, &OptionText::name);
  throw BadInput(name, value,
                 fmt::format("unknown argument: {}{} takes none of that name",
                             data::did_you_mean(name, known), verb.name));
}

/// Words with '=' are options of the verb, arguments of the quantity or keys of the scene.
void sort_words(const VerbText& verb, const Raw& raw, CommandLine& line) {
  for (const std::string& word : raw.words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      if (verb.words.empty())
        throw BadInput("argument", word, "unexpected: " + verb.name + " takes no names");
      line.words.push_back(word);
      continue;
    }
    const std::string name = word.substr(0, equals);
    const std::string value = word.substr(equals + 1);
    if (find_option(verb, name) == nullptr) {
      if (!verb.takes_assignments) refuse_assignment(verb, name, value);
      line.assignments.emplace_back(name, value);
    } else if (!line.options.emplace(name, value).second) {
      throw BadInput(name, value, "given twice: must be given once");
    }
  }
}

}  // namespace

std::optional<std::string> CommandLine::option(const std::string& name) const {
  const auto found = options.find(name);
  return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::string CommandLine::option_or_usual(const std::string& name) const {
  if (const auto given = option(name)) return *given;
  const OptionText* const known = find_option(find_verb(verb), name);
  return known == nullptr ? "" : known->usual;
}

std::optional<double> CommandLine::number(const std::string& name) const {
  const std::string text = option_or_usual(name);
  return text.empty() ? std::nullopt : std::optional(parse_real(name, text));
}

std::size_t CommandLine::count(const std::string& name) const {
  return static_cast<std::size_t>(number(name).value_or(0));
}

bool CommandLine::has(const std::string& flag) const { return flags.contains(flag); }

bool asks_for_json(int argc, const char* const* argv) {
  return std::any_of(argv, argv + argc, [](std::string_view word) { return word == "--json"; });
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  std::vector<std::string> words = as_meant({argv + std::min(argc, 1), argv + argc});
  refuse_what_is_unknown(words);
  CLI::App app(std::string(program_meaning()), "nipref");
  app.require_subcommand(1);
  app.set_version_flag("--version", "", "what it was built from and with; --version --json for machines");
  app.footer(std::string("\nExamples:\n  nipref I1 alpha=0.73\n  nipref solve thick-full-friction\n\n") +
             std::string(exit_statuses()));
  std::map<std::string, Raw> raws;
  for (const VerbText& verb : verbs()) declare(app, verb, raws[verb.name]);

  CommandLine line;
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // from the back, as CLI11 has it
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    line.help = chosen.empty() ? app.help() : chosen.front()->help("nipref");
    return line;
  } catch (const CLI::CallForVersion&) {
    line.version = true;
    line.json = asks_for_json(argc, argv);
    return line;
  } catch (const CLI::ParseError& error) {
    throw BadInput("command line", fmt::format("{}", fmt::join(words, " ")), error.what());
  }

  line.verb = app.get_subcommands().front()->get_name();
  const Raw& raw = raws[line.verb];
  for (const auto& [name, given] : raw.flags) {
    if (given) line.flags.insert(name);
  }
  line.json = line.has("json");
  line.no_times = line.has("no-times");
  for (const auto& [name, value] : raw.options) {
    if (app.get_subcommand(line.verb)->count("--" + name) > 0) line.options.emplace(name, value);
  }
  const VerbText& verb = find_verb(line.verb);
  sort_words(verb, raw, line);
  for (const auto& [name, value] : line.options) check_option(*find_option(verb, name), value);
  check_company(verb, line);
  return line;
}

fast::Accuracy accuracy_option(const CommandLine& line) {
  const auto rtol = line.number("rtol");
  return rtol ? fast::Accuracy(*rtol) : fast::Accuracy();
}

SceneRequest scene_request(const CommandLine& line) {
  const bool by_ref = line.option_or_usual("path") == "ref";
  if (!by_ref)
    refuse_option(line, "digits", "has no effect with path=fast: must be left out, or path=ref given");
  return {data::read_scene_or_example(line.words.front()), by_ref ? digits_option(line) : std::nullopt};
}

std::optional<double> max_slowdown_option(const CommandLine& line) {
  const auto text = line.option("max-slowdown");
  if (!text) return std::nullopt;
  const bool percent = text->ends_with('%');
  const double slowdown =
      parse_real("max-slowdown", percent ? text->substr(0, text->size() - 1) : *text) / (percent ? 100 : 1);
  if (slowdown < 0) throw BadInput("max-slowdown", *text, "must be a number >= 0: 10% and 0.1 are the same");
  return slowdown;
}

std::optional<int> digits_option(const CommandLine& line) {
  const auto digits = line.number("digits");
  return digits ? std::optional(static_cast<int>(*digits)) : std::nullopt;
}

void refuse_option(const CommandLine& line, const std::string& name, const std::string& why) {
  if (line.is_given(name)) throw BadInput(name, line.option(name).value_or("(given)"), why);
}

bool Selection::has(std::string_view group) const { return std::ranges::find(groups, group) != groups.end(); }

Selection selection(std::span<const std::string> words, const std::vector<std::string_view>& groups) {
  if (words.empty()) return {mapped(catalogue(), [](const Quantity& quantity) { return &quantity; }), groups};
  Selection selected;
  for (const std::string& word : words) {
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
