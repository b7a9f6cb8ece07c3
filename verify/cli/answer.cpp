#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

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

/// Whatever was in the input, the message stays one line.
std::string in_one_line(std::string message) {
  std::ranges::replace_if(
      message, [](unsigned char letter) { return letter < ' '; }, ' ');
  return message;
}

}  // namespace

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
