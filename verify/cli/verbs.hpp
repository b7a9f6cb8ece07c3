#pragma once
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A verb of the command line. BadInput for bad input.
using Verb = VerbAnswer(const CommandLine& line);

Verb list_verb, eval_verb, solve_verb, balance_verb, tables_verb, limits_verb, claims_verb, errata_verb,
    figures_verb, audit_verb, merge_verb, points_verb, grade_verb, golden_verb, bench_verb, report_verb;
inline constexpr std::array<std::string_view, 5> golden_actions{"make", "check", "update", "list", "export"};

/// The numbers that an option may have, including both limits.
struct NumberRange {
  std::string least, most;
  bool whole = true;
};

struct OptionText {
  std::string name;
  std::string meaning;  ///< with the unit; with the domain where neither a range nor choices can express it
  bool is_flag;         ///< it has no value
  std::string letter = {};  ///< "o" where -o is short for it
  std::string usual = {};   ///< the default; empty where `meaning` describes it
  std::optional<NumberRange> range = {};
  bool positive = false;  ///< any number > 0 is allowed
  std::vector<std::string> choices = {};
  /// The options with which alone, or without which alone, it is allowed, and what is said otherwise.
  std::map<std::string, std::string> needs = {}, without = {};
  std::vector<std::string> actions = {};  ///< the verb's first words with which it is allowed; empty: all
};

/// The meaning with the domain and the default.
std::string help_of(const OptionText& option);

/// BadInput that names the option if `value` is outside its range or none of its choices.
void check_option(const OptionText& option, const std::string& value);

/// A verb of the command line, its options and its help, as defined in verbs.toml.
struct VerbText {
  std::string name;
  Verb* run;
  std::string meaning;
  std::string words;  ///< name of the words that are no name=value pairs; empty if the verb has none
  std::string meaning_of_words;
  std::string too_many;             ///< what is said where there is a second word; empty if there may be
  std::string missing;              ///< what is said where there is no word; empty if there may be none
  std::vector<OptionText> options;  ///< --name value, or name=value; flags behind the others
  std::vector<std::string> examples;
  bool takes_assignments;  ///< whether it takes name=value pairs that are no options
};

const std::vector<VerbText>& verbs();

/// What the program is, and what its exit statuses mean.
const std::string& program_meaning();
const std::string& exit_statuses();

/// The verb called `name`. BadInput, with the nearest names, if there is none.
const VerbText& find_verb(const std::string& name);

/// The option of this name. Null if the verb has none.
const OptionText* find_option(const VerbText& verb, std::string_view name);

/// BadInput for a missing word or one too many, and for an option beside others that it must not, or must, stand beside.
void check_company(const VerbText& verb, const CommandLine& line);

/// The help of the program, and of a verb.
std::string program_help();
std::string help_of(const VerbText& verb);

/// What help says of all verbs, as a page for man.
std::string manual_page();

/// What bash, zsh or fish needs to complete verbs, their options, and the names of quantities, tables and example scenes.
std::string completion_for(const std::string& shell);

/// What comes of a call of the program.
struct Answer {
  int status;  ///< that of the verb, 2 for BadInput, 4 where a file cannot be written, 70 for an internal error
  std::string output = {};     ///< all that goes to standard output
  std::string complaint = {};  ///< the line that goes to standard error; empty if there is none
};

/// Parses the command line and runs its verb. With bad input the output is empty, or with --json the error alone.
Answer answer(int argc, const char* const* argv);

}  // namespace nipref::verify
