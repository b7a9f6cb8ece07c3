#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/verbs.hpp>

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
  // The catalogue is made only if need be, because this takes as long as all the rest of a short call.
  const bool is_verb = std::ranges::find(verbs(), words.front(), &VerbText::name) != verbs().end();
  if (!is_verb && known_quantity(words.front()) != nullptr) words.insert(words.begin(), "eval");
  return words;
}

/// Whether the word is an option, and not a negative number or "-", which stands for standard input.
bool is_option(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && word[1] != '.' && (word[1] < '0' || word[1] > '9');
}

/// A word divided into a name and a value. The value stands behind '=', or directly behind the letter of -o.
struct Divided {
  std::string name;
  std::optional<std::string> value;
};

Divided divided(const std::string& word) {
  const bool is_letter = is_option(word) && word[1] != '-';
  const std::size_t end = is_letter ? 2 : word.find('=');
  if (end >= word.size()) return {word, {}};
  return {word.substr(0, end), word.substr(is_letter ? end : end + 1)};
}

/// The option whose name with hyphens is the word's name. BadInput, with the nearest name, if there is none.
const OptionText& option_called(const VerbText& verb, const Divided& word) {
  std::vector<std::string> known{"--help"};
  for (const OptionText& option : verb.options) {
    known.push_back("--" + option.name);
    if (word.name == known.back() || word.name == "-" + option.letter()) return option;
  }
  refuse(word.name, word.value.value_or("(given)"), "unknown option: {}{} takes {}",
         data::did_you_mean(word.name, {known.begin(), known.end()}), verb.name, fmt::join(known, ", "));
}

/// The value of an option, which may be the next word.
std::string value_of(const VerbText& verb, const OptionText& option, const Divided& word,
                     std::span<const std::string> next) {
  if (option.is_flag && word.value) throw BadInput(option.name, *word.value, "must be given without a value");
  if (option.is_flag || word.value) return word.value.value_or("");
  if (next.empty() || is_option(next.front()))
    refuse(option.name, "(missing)", "{} needs it behind --{}", verb.name, option.name);
  return next.front();
}

void add_option(CommandLine& line, const OptionText& option, const std::string& value) {
  if (!line.options.emplace(option.name, value).second && !option.is_flag)
    throw BadInput(option.name, value, "given twice: must be given once");
}

/// Adds a word. With '=' it is an option of the verb, an argument of the quantity or a key of the scene.
void add_word(CommandLine& line, const VerbText& verb, const std::string& word) {
  const auto [name, value] = divided(word);
  if (!value) {
    if (verb.text("words").empty())
      throw BadInput("argument", word, "unexpected: " + verb.name + " takes no names");
    return line.words.push_back(word);
  }
  if (const OptionText* const option = find_option(verb, name); option != nullptr && !option->is_flag)
    return add_option(line, *option, *value);
  if (verb.row.number_or("takes_assignments", 0) == 0)
    refuse(name, *value, "unknown argument: {}{} takes none of that name",
           data::did_you_mean(name, mapped<std::string_view>(verb.options, &OptionText::name)), verb.name);
  line.assignments.emplace_back(name, *value);
}

}  // namespace

std::optional<std::string> CommandLine::option(const std::string& name) const {
  const auto found = options.find(name);
  return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::string CommandLine::option_or_usual(const std::string& name) const {
  if (const auto given = option(name)) return *given;
  const OptionText* const known = find_option(find_verb(verb), name);
  return known == nullptr ? "" : known->usual();
}

std::optional<double> CommandLine::number(const std::string& name) const {
  const std::string text = option_or_usual(name);
  return text.empty() ? std::nullopt : std::optional(parse_real(name, text));
}

std::size_t CommandLine::count(const std::string& name) const {
  return static_cast<std::size_t>(number(name).value_or(0));
}

std::vector<std::string> words_of(const CommandLine& line, const std::set<std::string>& without) {
  std::vector<std::string> words{line.verb};
  words.insert(words.end(), line.words.begin(), line.words.end());
  for (const auto& [name, value] : line.assignments) words.push_back(name + "=" + value);
  for (const auto& [name, value] : line.options)
    if (!without.contains(name)) words.push_back("--" + name + (value.empty() ? "" : "=" + value));
  return words;
}

bool asks_for_json(int argc, const char* const* argv) {
  return std::any_of(argv, argv + argc, [](std::string_view word) { return word == "--json"; });
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  const std::vector<std::string> words = as_meant({argv + std::min(argc, 1), argv + argc});
  CommandLine line;
  line.json = asks_for_json(argc, argv);
  const auto is_help = [](const std::string& word) { return word == "--help" || word == "-h"; };
  const std::string first = words.empty() ? "(missing)" : words.front();
  if (is_help(first)) line.help = program_help();
  line.version = first == "--version";
  if (line.help || line.version) return line;
  const VerbText& verb = find_verb(first);
  line.verb = verb.name;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (is_help(words[i])) {
      line.help = help_of(verb);
      return line;
    }
    if (!is_option(words[i])) {
      add_word(line, verb, words[i]);
      continue;
    }
    const Divided word = divided(words[i]);
    const OptionText& option = option_called(verb, word);
    add_option(line, option, value_of(verb, option, word, std::span(words).subspan(i + 1)));
    if (!option.is_flag && !word.value) ++i;
  }
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
  if (!line.has(name)) return;
  const std::string& value = line.options.at(name);
  throw BadInput(name, value.empty() ? "(given)" : value, why);
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
