#pragma once
#include <nipref/data/closest_name.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A parsed command line. Values are texts; the values of options lie in the domains that verbs.toml states.
struct CommandLine {
  std::string verb;
  std::vector<std::string> words = {};  ///< names of quantities, tables or files
  Assignments assignments = {};         ///< arguments of a quantity or keys of a scene, name=value
  /// Given as --name value or as name=value. The value of a flag is empty.
  std::map<std::string, std::string> options = {};
  bool json = false;
  std::optional<std::string> help = {};  ///< the help text, if help is asked for
  bool version = false;                  ///< the version is asked for instead of a verb

  /// The option's text, or nothing.
  [[nodiscard]] std::optional<std::string> option(const std::string& name) const;
  /// The option's text, or its default in the table of verbs; empty if that has none.
  [[nodiscard]] std::string option_or_usual(const std::string& name) const;
  /// The text of option_or_usual() as a number; nothing if the text is empty.
  [[nodiscard]] std::optional<double> number(const std::string& name) const;
  /// The text of option_or_usual() as a whole number, which may be written as "1e4"; 0 if the text is empty.
  [[nodiscard]] std::size_t count(const std::string& name) const;
  /// True if the option or flag is given.
  [[nodiscard]] bool has(const std::string& name) const { return options.contains(name); }
};

/// The words of a call with this command line, but without the options in `without`.
std::vector<std::string> words_of(const CommandLine& line, const std::set<std::string>& without = {});

/// Whether JSON is asked for, also by a command line that cannot be parsed.
bool asks_for_json(int argc, const char* const* argv);

/// Parses the command line. `help VERB` means `VERB --help`, and a quantity's name as the first word means eval.
/// BadInput for an unknown verb, an unknown or repeated option, and anything else that cannot be parsed.
CommandLine parse_command_line(int argc, const char* const* argv);

// Options that several verbs have. Without the option the functions return its default in verbs.toml.

fast::Accuracy accuracy_option(const CommandLine& line);

/// The scene that a verb's only word names: a file or, if there is no such file, an example.
struct SceneRequest {
  data::SceneText scene;
  std::optional<int> digits;  ///< digits of ref; nothing if fast solves the scene
};
SceneRequest scene_request(const CommandLine& line);

/// The slowdown that --max-slowdown allows, 0.1 for "10%" or "0.1"; nothing if the option is not given.
std::optional<double> max_slowdown_option(const CommandLine& line);

/// The value of --digits; nothing if it is not given and has no default.
std::optional<int> digits_option(const CommandLine& line);

/// Throws BadInput with the reason `why` if this option or flag is given.
void refuse_option(const CommandLine& line, const std::string& name, const std::string& why);

/// The quantities of the catalogue, and the groups outside it, that the words name, each once; all of them if there
/// are no words.
struct Selection {
  std::vector<const Quantity*> quantities;
  std::vector<std::string_view> groups;

  [[nodiscard]] bool has(std::string_view group) const;
};
/// BadInput for words that are neither a quantity nor one of `groups`.
Selection selection(std::span<const std::string> words, const std::vector<std::string_view>& groups = {});

/// Keeps the rows whose `id` is one of the words, or all rows if there are no words. BadInput naming `what` for a word
/// that is no row's id.
template <class Rows, class Id>
void select_by_id(Rows& rows, const std::vector<std::string>& words, std::string_view what, Id id) {
  if (words.empty()) return;
  const auto ids = mapped<std::string_view>(rows, id);
  for (const std::string& word : words) {
    if (std::ranges::find(ids, word) == ids.end())
      throw data::BadInput(what, word,
                           data::did_you_mean(word, ids) + "must be one of those that are listed without it");
  }
  std::erase_if(rows, [&](const auto& row) { return std::ranges::find(words, row.*id) == words.end(); });
}

}  // namespace nipref::verify
