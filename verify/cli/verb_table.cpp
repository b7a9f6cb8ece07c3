#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

/// The text of verbs.toml, put here by the build so that help needs no file.
constexpr std::string_view definitions =
#include <nipref_verbs.inc>
    ;

const std::map<std::string, Verb*> handlers{
    {"list", list_verb},       {"eval", eval_verb},     {"solve", solve_verb},   {"balance", balance_verb},
    {"tables", tables_verb},   {"limits", limits_verb}, {"claims", claims_verb}, {"errata", errata_verb},
    {"figures", figures_verb}, {"audit", audit_verb},   {"merge", merge_verb},   {"points", points_verb},
    {"grade", grade_verb},     {"golden", golden_verb}, {"bench", bench_verb},   {"report", report_verb}};

std::string text_of(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}

std::vector<std::string> list_of(const toml::table& table, std::string_view key) {
  std::vector<std::string> list;
  if (const toml::array* const items = table[key].as_array()) {
    for (const toml::node& item : *items) list.push_back(item.value<std::string>().value());
  }
  return list;
}

std::map<std::string, std::string> messages_in(const toml::table& table, std::string_view key) {
  std::map<std::string, std::string> messages;
  if (const toml::table* const found = table[key].as_table()) {
    for (const auto& [option, message] : *found)
      messages.emplace(option.str(), message.value<std::string>().value());
  }
  return messages;
}

OptionText option_of(const std::string& key, const toml::node& node) {
  const toml::table table =
      node.is_table() ? *node.as_table() : toml::table{{"meaning", node.value<std::string>().value()}};
  const std::vector<std::string> limits = list_of(table, "range");
  std::optional<NumberRange> range;
  if (!limits.empty()) range = {limits.at(0), limits.at(1), table["whole"].value_or(true)};
  return {table["name"].value_or(key),
          text_of(table, "meaning"),
          text_of(table, "letter"),
          text_of(table, "default"),
          std::move(range),
          table["positive"].value_or(false),
          list_of(table, "choices"),
          messages_in(table, "needs"),
          messages_in(table, "without"),
          list_of(table, "actions")};
}

VerbText verb_of(const toml::table& table, const toml::table& options) {
  const auto options_in = [&](std::string_view key) {
    return mapped(list_of(table, key),
                  [&](const std::string& name) { return option_of(name, options.at(name)); });
  };
  const std::string name = text_of(table, "name");
  return {name,
          handlers.at(name),
          text_of(table, "meaning"),
          text_of(table, "words"),
          text_of(table, "meaning_of_words"),
          text_of(table, "too_many"),
          text_of(table, "missing"),
          options_in("options"),
          options_in("flags"),
          list_of(table, "examples"),
          table["takes_assignments"].value_or(false)};
}

/// "a whole number from 1 to 100", "ref, fast or both"; empty if the table has no domain for it.
std::string domain_of(const OptionText& option) {
  if (option.positive) return "a number > 0";
  if (option.range)
    return fmt::format("a {} from {} to {}", option.range->whole ? "whole number" : "number",
                       option.range->least, option.range->most);
  if (option.choices.empty()) return "";
  const auto last = option.choices.end() - 1;
  return fmt::format("{} or {}", fmt::join(option.choices.begin(), last, ", "), *last);
}

}  // namespace

std::string_view program_meaning() {
  return "Verification reference for rolling contact: two independent paths, ref (16 to 1000 digits with bounds) and "
         "fast (double).\n'nipref help VERB' says what a verb takes.";
}

std::string_view exit_statuses() {
  return "Exit status: 0 all well, 1 a check fell short, 2 bad input, 3 incomplete, 4 output could not be written, 70 "
         "internal error, 130 interrupted.\n"
         "An error is one line on standard error; with --json it is an answer on standard output as well.";
}

std::string help_of(const OptionText& option) {
  const std::string domain = domain_of(option);
  return option.meaning + (domain.empty() ? "" : "; " + domain) +
         (option.usual.empty() ? "" : " (default " + option.usual + ")");
}

void check_option(const OptionText& option, const std::string& value) {
  bool allowed = option.choices.empty() || std::ranges::find(option.choices, value) != option.choices.end();
  if (option.positive) allowed = parse_real(option.name, value) > 0;
  if (const auto& range = option.range) {
    const double number = parse_real(option.name, value);
    allowed = number >= parse_real(option.name, range->least) &&
              number <= parse_real(option.name, range->most) &&
              (!range->whole || number == std::floor(number));
  }
  if (!allowed) throw BadInput(option.name, value, "must be " + domain_of(option));
}

void check_company(const VerbText& verb, const CommandLine& line) {
  if (line.words.empty() && !verb.missing.empty()) throw BadInput(verb.words, "(missing)", verb.missing);
  if (line.words.size() > 1 && !verb.too_many.empty())
    throw BadInput("argument", line.words[1], "unexpected: " + verb.too_many);
  for (const auto* const group : {&verb.options, &verb.flags}) {
    for (const OptionText& option : *group) {
      for (const auto& [other, why] : option.needs) {
        if (!line.is_given(other)) refuse_option(line, option.name, why);
      }
      for (const auto& [other, why] : option.without) {
        if (line.is_given(other)) refuse_option(line, option.name, why);
      }
      const bool suits = option.actions.empty() || line.words.empty() ||
                         std::ranges::find(option.actions, line.words.front()) != option.actions.end();
      if (!suits)
        refuse_option(line, option.name,
                      fmt::format("{} {} has no such option", verb.name, line.words.front()));
    }
  }
}

const OptionText* find_option(const VerbText& verb, std::string_view name) {
  const auto found = std::ranges::find(verb.options, name, &OptionText::name);
  return found == verb.options.end() ? nullptr : &*found;
}

std::string names_of(const OptionText& option) {
  return (option.letter.empty() ? "" : "-" + option.letter + ",") + "--" + option.name;
}

const std::vector<VerbText>& verbs() {
  static const std::vector<VerbText> all = [] {
    const toml::table defined = toml::parse(definitions);
    const toml::table& options = *defined["options"].as_table();
    return mapped(*defined["verbs"].as_array(),
                  [&](const toml::node& verb) { return verb_of(*verb.as_table(), options); });
  }();
  return all;
}

const VerbText& find_verb(const std::string& name) {
  const auto found = std::ranges::find(verbs(), name, &VerbText::name);
  if (found != verbs().end()) return *found;
  const auto known = mapped<std::string_view>(verbs(), &VerbText::name);
  auto near = known;
  for (const Quantity& quantity : catalogue()) near.push_back(quantity.name);
  throw BadInput(
      "verb", name,
      fmt::format("{}must be one of {}", data::did_you_mean(name, near, 3), fmt::join(known, ", ")));
}

void refuse_unknown_option(const VerbText& verb, const std::string& name, const std::string& value) {
  std::vector<std::string> known{"--help"};
  for (const auto* const group : {&verb.options, &verb.flags}) {
    for (const OptionText& option : *group) known.push_back("--" + option.name);
  }
  if (std::ranges::find(known, name) != known.end()) return;
  throw BadInput(
      name, value,
      fmt::format("unknown option: {}{} takes {}", data::did_you_mean(name, {known.begin(), known.end()}),
                  verb.name, fmt::join(known, ", ")));
}

}  // namespace nipref::verify
