#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

struct OptionText {
  std::string name;
  std::string meaning;
};

struct VerbText {
  std::string name;
  std::string meaning;
  std::string words;  ///< what the words that are no name=value pairs name; empty: there are none
  std::vector<OptionText> options;
  bool lists = false;
};

const OptionText path_option{"path", "ref, fast or both (default both)"};
const OptionText digits_option{"digits", "decimal digits of ref's result, 16 to 1000 (default 50)"};
const OptionText solve_path_option{"path", "ref or fast (default fast)"};
const OptionText solve_digits_option{
    "digits", "decimal digits of ref's results, 16 to 100, line loads to 300 (default 30)"};
const OptionText rtol_option{
    "rtol",
    "error that fast may make, as a part of the scale, 4.44e-16 <= rtol < 1 (default: full accuracy)"};
const OptionText form_option{
    "form", "corrected, or printed or table for the seed's own where they differ (default corrected)"};
const OptionText points_text{"points", "points for each quantity (default 20000)"};

const std::array verbs{
    VerbText{"list", "the quantities that can be computed", "", {}},
    VerbText{"eval",
             "one quantity at one argument: eval I1 alpha=0.73",
             "quantity name=value",
             {path_option, digits_option, rtol_option, form_option}},
    VerbText{"solve",
             "what a scene wants of its contact: solve SCENE.toml",
             "scene",
             {solve_path_option, solve_digits_option}},
    VerbText{"tables", "the seeds' tables, replayed", "table", {}, true},
    VerbText{
        "audit", "largest error of fast against ref", "quantity or contacts", {points_text, rtol_option}},
    VerbText{"bench",
             "speed against error, beside other libraries",
             "quantity, elastic-nip, viscoelastic-nip or half-space",
             {}},
    VerbText{"report", "audit, bench and tables on a page or two", "", {points_text}},
};

std::string verb_names() {
  std::vector<std::string_view> names;
  for (const VerbText& verb : verbs) names.push_back(verb.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

const VerbText& find_verb(const std::string& name) {
  const auto found = std::ranges::find(verbs, name, &VerbText::name);
  if (found == verbs.end()) throw BadInput("verb", name, "must be one of " + verb_names());
  return *found;
}

/// The first word decides; a call for help is left to CLI11.
void refuse_unknown_verb(int argc, const char* const* argv) {
  if (argc < 2) throw BadInput("verb", "(missing)", "must be one of " + verb_names());
  const std::string first = argv[1];
  if (first != "-h" && first != "--help" && first != "--version") find_verb(first);
}

struct Raw {
  std::vector<std::string> words;
  std::map<std::string, std::string> options;
  bool json = false;
  bool no_times = false;
  bool list = false;
};

void declare(CLI::App& app, const VerbText& verb, Raw& raw) {
  CLI::App* sub = app.add_subcommand(verb.name, verb.meaning);
  sub->add_option("words", raw.words, verb.words.empty() ? "name=value" : verb.words)->option_text("...");
  for (const OptionText& option : verb.options) {
    sub->add_option("--" + option.name, raw.options[option.name],
                    option.meaning + "; also " + option.name + "=...");
  }
  if (verb.lists) sub->add_flag("--list", raw.list, "only list the tables");
  sub->add_flag("--json", raw.json, "output for machines, errors too");
  sub->add_flag("--no-times", raw.no_times, "with --json: leave out what the clock decides");
}

/// Words with '=' are options of the verb or arguments of the quantity.
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
    if (std::ranges::find(verb.options, name, &OptionText::name) == verb.options.end()) {
      if (verb.name != "eval") {
        throw BadInput(name, value, "unknown argument: " + verb.name + " takes none of that name");
      }
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

bool asks_for_json(int argc, const char* const* argv) {
  return std::any_of(argv, argv + argc, [](std::string_view word) { return word == "--json"; });
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  refuse_unknown_verb(argc, argv);
  CLI::App app(
      "Verification reference for rolling contact: two independent paths, ref (16 to 1000 digits with bounds) "
      "and fast (double).\n"
      "Exit status: 0 all well, 1 a check fell short, 2 bad input, 3 internal error, 4 output could not be written.\n"
      "An error is one line on standard error; with --json it is an answer on standard output as well.",
      "nipref");
  app.require_subcommand(1);
  app.set_version_flag("--version", "", "what it was built from and with; --version --json for machines");
  std::map<std::string, Raw> raws;
  for (const VerbText& verb : verbs) declare(app, verb, raws[verb.name]);

  CommandLine line;
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    line.help = chosen.empty() ? app.help() : chosen.front()->help("nipref");
    return line;
  } catch (const CLI::CallForVersion&) {
    line.version = true;
    line.json = asks_for_json(argc, argv);
    return line;
  } catch (const CLI::ParseError& error) {
    throw BadInput("command line", fmt::format("{}", fmt::join(argv + 1, argv + argc, " ")), error.what());
  }

  line.verb = app.get_subcommands().front()->get_name();
  const Raw& raw = raws[line.verb];
  line.json = raw.json;
  line.no_times = raw.no_times;
  line.list = raw.list;
  if (line.no_times && !line.json)
    throw BadInput("no-times", "(given)", "must be given with --json: there alone times are set apart");
  for (const auto& [name, value] : raw.options) {
    if (app.get_subcommand(line.verb)->count("--" + name) > 0) line.options.emplace(name, value);
  }
  sort_words(find_verb(line.verb), raw, line);
  return line;
}

}  // namespace nipref::verify
