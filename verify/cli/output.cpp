#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>

#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

OutputError::OutputError(const std::string& place)
    : std::system_error(errno, std::generic_category(), place) {}

void write_output_file(const std::string& path, std::string_view text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw OutputError(path);
}

void replace_output_file(const std::string& path, std::string_view text) {
  std::error_code error;
  // Instead of a link the file to which it points is replaced.
  std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  if (error) target = path;
  const std::filesystem::file_status there = std::filesystem::status(target, error);
  if (exists(there) && !is_regular_file(there)) return write_output_file(path, text);
  if (exists(there) && access(target.c_str(), W_OK) != 0) throw OutputError(path);
  const std::string beside = target.string() + ".part" + std::to_string(getpid());
  try {
    write_output_file(beside, text);
    if (exists(there)) std::filesystem::permissions(beside, there.permissions(), error);
    if (std::rename(beside.c_str(), target.c_str()) != 0) throw OutputError(path);
  } catch (const OutputError& reason) {
    std::filesystem::remove(beside, error);
    errno = reason.code().value();
    throw OutputError(path);
  }
}

namespace {

[[noreturn]] void fail() { throw OutputError("standard output"); }

/// Opens a closed descriptor. open() takes the lowest free one: this one, because those below are occupied.
void occupy(int descriptor, int mode) {
  if (fcntl(descriptor, F_GETFD) == -1 && errno == EBADF && open("/dev/null", mode) == -1) fail();
}

constexpr long schema = 1;

/// The files of cli/templates, put here by the build so that an answer needs no file.
const Partials templates{
#include <nipref_templates.inc>
};

Json answer_head() { return {{"schema", schema}, {"nipref", version_json()}}; }

}  // namespace

void occupy_standard_descriptors() {
  occupy(STDIN_FILENO, O_RDONLY);
  occupy(STDOUT_FILENO, O_RDONLY);  // for writing it is as good as closed
  occupy(STDERR_FILENO, O_WRONLY);
}

bool standard_output_shows_colours() {
  const char* const unwanted = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (unwanted == nullptr || *unwanted == '\0') && terminal != nullptr &&
         std::string_view(terminal) != "dumb" && isatty(STDOUT_FILENO) == 1;
}

void write_to_standard_output(std::string_view text) {
  if (!write_all(STDOUT_FILENO, text)) fail();
  // Some file systems report only now that there was no space.
  if (close(STDOUT_FILENO) == -1 && errno != EINTR) fail();
}

std::string answer_text(std::string_view verb, const Json& members, bool no_times) {
  Json answer = answer_head();
  answer.set("verb", verb);
  answer.append(members.for_machines());
  if (interrupted()) answer.set("interrupted", true);
  return (no_times ? answer.without("times") : answer).text();
}

std::string text_of(const std::string& name, const Json& members, const Escape& escape) {
  return filled_text(templates.at(name), members, templates, escape);
}

std::string written(const VerbAnswer& answer, const CommandLine& line) {
  if (line.json) return answer_text(answer.verb, answer.members, line.has("no-times"));
  if (const auto* const text = std::get_if<1>(&answer.text)) return (*text)();
  const std::string& name = std::get<0>(answer.text);
  return folded(text_of(name.empty() ? answer.verb + ".txt" : name, answer.members)) + note_of_interrupt();
}

std::string note_of_interrupt() {
  return interrupted() ? "\ninterrupted: above is what was finished by then\n" : "";
}

std::string version_answer_text(bool json) {
  Json answer = answer_head();
  answer.set("golden", Json::unless_empty(golden_version()));
  return json ? answer.text() : folded(text_of("version.txt", answer));
}

std::string error_answer_text(std::string_view message, const Json& argument, const Json& value,
                              const Json& allowed) {
  Json answer = answer_head();
  answer.set("error", {{"argument", argument}, {"value", value}, {"allowed", allowed}, {"message", message}});
  return answer.text();
}

}  // namespace nipref::verify
