#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
namespace {

constexpr long schema = 1;

Json answer_head() { return {{"schema", schema}, {"nipref", version_json()}}; }

}  // namespace

std::string answer_text(std::string_view verb, const Json& members, bool no_times) {
  Json answer = answer_head();
  answer.set("verb", verb);
  answer.append(members);
  if (interrupted()) answer.set("interrupted", true);
  return (no_times ? answer.without("times") : answer).text();
}

std::string version_answer_text() { return answer_head().text(); }

std::string error_answer_text(std::string_view message, const Json& argument, const Json& value,
                              const Json& allowed) {
  Json answer = answer_head();
  answer.set("error", {{"argument", argument}, {"value", value}, {"allowed", allowed}, {"message", message}});
  return answer.text();
}

}  // namespace nipref::verify
