#pragma once
#include <system_error>

#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

struct Provenance;

/// A file or standard output that could not be written, with the system's reason.
class OutputError : public std::system_error {
 public:
  /// `place` is a file's path, or standard output; the reason is that of the last system call.
  explicit OutputError(const std::string& place);
};

/// Writes the file's new content. OutputError if any of it could not be written.
void write_output_file(const std::string& path, std::string_view text);

/// Replaces the file's content, so that at any time the file has either the old content or the new one: the text is
/// written to another file, which is then renamed. A pipe or a device is written to directly.
void replace_output_file(const std::string& path, std::string_view text);

/// Must be called before any file is opened. If a standard descriptor is closed, the first file that is opened
/// would get its number, and output for the user would be written into that file. Each closed descriptor is therefore
/// opened on /dev/null, standard output in such a way that writing to it fails.
void occupy_standard_descriptors();

/// Whether standard output is a terminal that shows colours and the user wants them: NO_COLOR unset or empty
/// (no-color.org).
bool standard_output_shows_colours();

/// Writes the text to standard output and closes it. OutputError if any of it could not be written. If the reader has
/// closed its end, SIGPIPE ends the program as usual.
void write_to_standard_output(std::string_view text);

// Answers in JSON, as data/schema/nipref-1.json describes them.

/// The answer of a verb. With `no_times` the members "times" are left out at any depth. If the process was interrupted,
/// the answer has "interrupted": true and only what was finished by then.
std::string answer_text(std::string_view verb, const Json& members, bool no_times = false);

/// The text that a template of cli/templates makes of an answer's members, each of which is inserted by `escape`.
std::string text_of(const std::string& name, const Json& members,
                    const std::function<std::string(const std::string&)>& escape = std::identity());

/// The answer of a verb.
struct VerbAnswer {
  std::string verb;      ///< its name in JSON
  Json members;          ///< members whose names begin with '_' are for the text alone
  bool all_well = true;  ///< otherwise a check fell short
  /// The template of the text, by default VERB.txt, which is filled and folded; or a function that returns the text.
  std::variant<std::string, std::function<std::string()>> text = {};
};

/// The answer as the command line asks for it, as JSON or as text.
std::string written(const VerbAnswer& answer, const CommandLine& line);

/// The note below the text of an answer that an interrupt has left unfinished; empty without an interrupt.
std::string note_of_interrupt();

/// The compiler of this program.
std::string compiler();

/// The provenance of golden values that this program makes.
Provenance provenance();

/// The member "nipref" of every answer: what this program was built from and with, and what it runs on.
Json version_json();

/// This program without its machine: what it was built from and with, the instruction set that fast uses, and the
/// SHA-256 of the program's file.
Json program_json();

/// The answer to --version.
std::string version_answer_text(bool json);

/// The answer for an error; `message` is the line on standard error. Unknown parts are null.
std::string error_answer_text(std::string_view message, const Json& argument = {}, const Json& value = {},
                              const Json& allowed = {});

}  // namespace nipref::verify
