#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

/// A command line taken apart. Values are text; those of options are in the domain that the table of verbs has for them.
struct CommandLine {
  std::string verb;
  std::vector<std::string> words;  ///< names of quantities, tables or files
  Assignments
      assignments;  ///< name=value pairs that are no options: arguments of a quantity, keys of a scene
  std::map<std::string, std::string>
      options;  ///< path, digits, rtol, points, density, form, given as --name value or as name=value
  std::set<std::string> flags;  ///< list, quick, quiet, ...: those that are given
  bool json = false;
  bool no_times = false;            ///< only with json
  std::optional<std::string> help;  ///< set if help was asked for: the text to print
  bool version = false;             ///< asked for instead of a verb

  /// The option's text, or nothing.
  [[nodiscard]] std::optional<std::string> option(const std::string& name) const;
  /// The option's text, or its default in the table of verbs; empty if that has none.
  [[nodiscard]] std::string option_or_usual(const std::string& name) const;
  /// True if the flag is given.
  [[nodiscard]] bool has(const std::string& flag) const;
};

/// Whether the answer shall be JSON, for command lines too that cannot be taken apart.
bool asks_for_json(int argc, const char* const* argv);

/// `help VERB` is taken for `VERB --help`, and a quantity's name at the front for eval of it. BadInput in one
/// line for an unknown verb, an unknown or repeated option, and whatever else cannot be read.
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace nipref::verify
