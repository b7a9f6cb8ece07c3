#include <nipref/data/closest_name.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

const std::map<std::string, Verb*> handlers{
    {"list", list_verb},       {"eval", eval_verb},     {"solve", solve_verb},   {"balance", balance_verb},
    {"tables", tables_verb},   {"limits", limits_verb}, {"claims", claims_verb}, {"errata", errata_verb},
    {"figures", figures_verb}, {"audit", audit_verb},   {"merge", merge_verb},   {"points", points_verb},
    {"grade", grade_verb},     {"golden", golden_verb}, {"bench", bench_verb},   {"report", report_verb}};

/// verbs.toml, whose text the build puts here so that help needs no file.
const TomlTable& definitions() {
  static const TomlTable all = parse_toml(
#include <nipref_verbs.inc>
      , "table of verbs", "verbs.toml");
  return all;
}

OptionText option_of(const std::string& key, bool is_flag) {
  const TomlTable& options = definitions().table("options");
  if (const std::string meaning = options.text_or(key, ""); !meaning.empty()) return {key, meaning, is_flag};
  const TomlTable& table = options.table(key);
  const std::vector<std::string> limits = table.words_of("range");
  std::optional<NumberRange> range;
  if (!limits.empty()) range = {limits.at(0), limits.at(1), table.number_or("whole", 1) != 0};
  return {table.text_or("name", key),          table.text("meaning"),        is_flag,
          table.text_or("letter", ""),         table.text_or("default", ""), std::move(range),
          table.number_or("positive", 0) != 0, table.words_of("choices"),    table.texts_of("needs"),
          table.texts_of("without"),           table.words_of("actions")};
}

VerbText verb_of(const TomlTable& table) {
  std::vector<OptionText> options;
  for (const std::string& name : table.words_of("options")) options.push_back(option_of(name, false));
  for (const std::string& name : table.words_of("flags")) options.push_back(option_of(name, true));
  return VerbText(table.text("name"), handlers.at(table.text("name")), table.text("meaning"),
                  table.text_or("words", ""), table.text_or("meaning_of_words", ""),
                  table.text_or("too_many", ""), table.text_or("missing", ""), std::move(options),
                  table.words_of("examples"), table.number_or("takes_assignments", 0) != 0);
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

constexpr int status_bad_input = 2;
constexpr int status_not_written = 4;
constexpr int status_internal = 70;  // EX_SOFTWARE of sysexits.h

Answer answer_to(const CommandLine& line) {
  if (line.help) return {0, folded(*line.help)};
  if (line.version) return {0, version_answer_text(line.json)};
  if (const auto isa = line.option("isa")) fast::use_instruction_set(*isa);
  const VerbAnswer found = find_verb(line.verb).run(line);
  return {found.all_well ? 0 : 1, written(found, line)};
}

}  // namespace

const std::string& program_meaning() { return definitions().text("meaning"); }
const std::string& exit_statuses() { return definitions().text("exit_statuses"); }

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
  for (const OptionText& option : verb.options) {
    for (const auto& [other, why] : option.needs)
      if (!line.has(other)) refuse_option(line, option.name, why);
    for (const auto& [other, why] : option.without)
      if (line.has(other)) refuse_option(line, option.name, why);
    const bool suits = option.actions.empty() || line.words.empty() ||
                       std::ranges::find(option.actions, line.words.front()) != option.actions.end();
    if (!suits)
      refuse_option(line, option.name,
                    fmt::format("{} {} has no such option", verb.name, line.words.front()));
  }
}

const OptionText* find_option(const VerbText& verb, std::string_view name) {
  return item_with(verb.options, &OptionText::name, name);
}

const std::vector<VerbText>& verbs() {
  static const std::vector<VerbText> all = mapped(definitions().tables.at("verbs"), verb_of);
  return all;
}

const VerbText& find_verb(const std::string& name) {
  if (const VerbText* const found = item_with(verbs(), &VerbText::name, name)) return *found;
  const auto known = mapped<std::string_view>(verbs(), &VerbText::name);
  auto near = known;
  for (const Quantity& quantity : catalogue()) near.push_back(quantity.name);
  refuse("verb", name, "{}must be one of {}", data::did_you_mean(name, near, 3), fmt::join(known, ", "));
}

Answer answer(int argc, const char* const* argv) {
  const bool json = asks_for_json(argc, argv);
  try {
    return answer_to(parse_command_line(argc, argv));
  } catch (const data::BadInput& error) {
    const std::string message = in_one_line(error.what());
    if (!json) return {status_bad_input, {}, message};
    return {status_bad_input, error_answer_text(message, error.argument(), error.value(), error.allowed()),
            message};
  } catch (const OutputError& error) {
    return {status_not_written, {}, in_one_line(error.what())};
  } catch (const std::exception& error) {
    const std::string message = in_one_line(std::string("internal error: ") + error.what());
    return {status_internal, json ? error_answer_text(message) : "", message};
  }
}

}  // namespace nipref::verify
