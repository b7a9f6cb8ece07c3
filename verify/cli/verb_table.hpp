#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

struct OptionText {
  std::string name;
  std::string meaning;      ///< with unit, domain and default
  std::string letter = {};  ///< "o" where -o is short for it
};

/// "-o,--output"
std::string names_of(const OptionText& option);

/// What a verb takes, and what its help says.
struct VerbText {
  std::string name;
  std::string meaning;
  std::string words;  ///< what the words that are no name=value pairs are called; empty: there are none
  std::string meaning_of_words;     ///< and what they are
  std::vector<OptionText> options;  ///< --name value, or name=value
  std::vector<OptionText> flags;
  std::vector<std::string> examples;
  bool takes_assignments = false;  ///< name=value pairs that are no options
};

/// What the program is.
std::string_view program_meaning();
/// What its exit statuses say.
std::string_view exit_statuses();

/// All of them.
std::span<const VerbText> verbs();

/// The one called `name`. BadInput, with the nearest names, if there is none.
const VerbText& find_verb(const std::string& name);

/// BadInput, with the nearest name, for a "--name" that the verb does not take.
void refuse_unknown_option(const VerbText& verb, const std::string& name, const std::string& value);

}  // namespace nipref::verify
