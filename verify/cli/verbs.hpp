#pragma once
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

namespace nipref::verify {

/// A verb of the command line. BadInput for bad input.
using Verb = VerbAnswer(const CommandLine& line);

Verb list_verb, eval_verb, solve_verb, balance_verb, tables_verb, limits_verb, claims_verb, errata_verb,
    figures_verb, audit_verb, merge_verb, points_verb, grade_verb, golden_verb, bench_verb, report_verb;
inline constexpr std::array<std::string_view, 5> golden_actions{"make", "check", "update", "list", "export"};

/// An option of a verb, with its row in verbs.toml, which describes the keys.
struct OptionText {
  std::string name;
  bool is_flag;  ///< whether it has no value
  TomlTable row;

  /// The default; empty if there is none or `meaning` states it.
  [[nodiscard]] std::string usual() const { return row.text_or("default", ""); }
  /// "o" if the option may be written as -o.
  [[nodiscard]] std::string letter() const { return row.text_or("letter", ""); }
};

/// The help of an option: its meaning, its domain and its default.
std::string help_of(const OptionText& option);

/// BadInput that names the option if `value` is outside its range or none of its choices.
void check_option(const OptionText& option, const std::string& value);

/// A verb of the command line, with its row in verbs.toml.
struct VerbText {
  std::string name;
  Verb* run;
  TomlTable row;
  std::vector<OptionText> options;  ///< --name value, or name=value; flags behind the others

  [[nodiscard]] std::string text(const std::string& key) const { return row.text_or(key, ""); }
};

const std::vector<VerbText>& verbs();

/// What the program is, and what its exit statuses mean.
const std::string& program_meaning();
const std::string& exit_statuses();

/// The verb called `name`. BadInput, with the nearest names, if there is none.
const VerbText& find_verb(const std::string& name);

/// The option of this name. Null if the verb has none.
const OptionText* find_option(const VerbText& verb, std::string_view name);

/// Throws BadInput for a missing or extra word, and for an option without those it needs or beside those it excludes.
void check_company(const VerbText& verb, const CommandLine& line);

/// The help of the program, and of a verb.
std::string program_help();
std::string help_of(const VerbText& verb);

/// The help of all verbs as a manual page.
std::string manual_page();

/// The script by which bash, zsh or fish completes verbs, options, and names of quantities, tables and example scenes.
std::string completion_for(const std::string& shell);

/// The outcome of a call of the program.
struct Answer {
  int status;  ///< that of the verb, 2 for BadInput, 4 where a file cannot be written, 70 for an internal error
  std::string output = {};     ///< all that goes to standard output
  std::string complaint = {};  ///< the line that goes to standard error; empty if there is none
};

/// Parses the command line and runs its verb. With bad input the output is empty, or with --json the error alone.
Answer answer(int argc, const char* const* argv);

}  // namespace nipref::verify
