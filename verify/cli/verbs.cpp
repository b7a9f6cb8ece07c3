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
  if (const std::string meaning = options.text_or(key, ""); !meaning.empty())
    return {key, is_flag, {options.what, options.where, {{"meaning", meaning}}}};
  const TomlTable& row = options.table(key);
  return {row.text_or("name", key), is_flag, row};
}

VerbText verb_of(const TomlTable& row) {
  VerbText verb{row.text("name"), handlers.at(row.text("name")), row, {}};
  for (const std::string& name : row.words_of("options")) verb.options.push_back(option_of(name, false));
  for (const std::string& name : row.words_of("flags")) verb.options.push_back(option_of(name, true));
  return verb;
}

/// "a whole number from 1 to 100", "ref, fast or both"; empty if the table has no domain for it.
std::string domain_of(const TomlTable& option) {
  if (option.number_or("positive", 0) != 0) return "a number > 0";
  if (const std::vector<std::string> range = option.words_of("range"); !range.empty())
    return fmt::format("a {} from {} to {}", option.number_or("whole", 1) != 0 ? "whole number" : "number",
                       range.at(0), range.at(1));
  const std::vector<std::string> choices = option.words_of("choices");
  if (choices.empty()) return "";
  return fmt::format("{} or {}", fmt::join(choices.begin(), choices.end() - 1, ", "), choices.back());
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
  const std::string domain = domain_of(option.row), usual = option.usual();
  return option.row.text("meaning") + (domain.empty() ? "" : "; " + domain) +
         (usual.empty() ? "" : " (default " + usual + ")");
}

void check_option(const OptionText& option, const std::string& value) {
  const auto real = [&](const std::string& text) { return parse_real(option.name, text); };
  const std::vector<std::string> choices = option.row.words_of("choices"),
                                 range = option.row.words_of("range");
  bool allowed = choices.empty() || std::ranges::find(choices, value) != choices.end();
  if (option.row.number_or("positive", 0) != 0) allowed = real(value) > 0;
  if (!range.empty()) {
    const double number = real(value);
    allowed = number >= real(range.at(0)) && number <= real(range.at(1)) &&
              (option.row.number_or("whole", 1) == 0 || number == std::floor(number));
  }
  if (!allowed) throw BadInput(option.name, value, "must be " + domain_of(option.row));
}

void check_company(const VerbText& verb, const CommandLine& line) {
  const std::string missing = verb.text("missing"), too_many = verb.text("too_many");
  if (line.words.empty() && !missing.empty()) throw BadInput(verb.text("words"), "(missing)", missing);
  if (line.words.size() > 1 && !too_many.empty())
    throw BadInput("argument", line.words[1], "unexpected: " + too_many);
  for (const OptionText& option : verb.options) {
    for (const auto& [other, why] : option.row.texts_of("needs"))
      if (!line.has(other)) refuse_option(line, option.name, why);
    for (const auto& [other, why] : option.row.texts_of("without"))
      if (line.has(other)) refuse_option(line, option.name, why);
    const std::vector<std::string> actions = option.row.words_of("actions");
    if (!actions.empty() && !line.words.empty() && std::ranges::count(actions, line.words.front()) == 0)
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
