#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/json_schema.hpp"
#include "support/run_nipref.hpp"

using nlohmann::json;

TEST_CASE("an answer with a name more, less or of another kind does not fit the schema") {
  const json good = answer_to("eval I1 alpha=0.73");
  const auto misfit_after = [&](const auto& change) {
    json bad = good;
    change(bad);
    return answer_schema().misfit(bad, "eval");
  };
  CHECK(misfit_after([](json&) {}) == "");
  CHECK(misfit_after([](json& bad) { bad["more"] = 1; }) == "answer.more is not expected");
  CHECK(misfit_after([](json& bad) { bad["schema"] = 2; }) == "answer.schema is not 1");
  CHECK(misfit_after([](json& bad) { bad.erase("arguments"); }) == "answer has no arguments");
  CHECK(misfit_after([](json& bad) { bad["results"]["fast"]["value"] = "0.2"; }) ==
        "answer.results.fast.value is no [\"number\",\"null\"]");
  CHECK(answer_schema().misfit(json::object()).starts_with("answer fits none"));
  for (const char* unknown :
       {R"({"properties":{"x":{"minimum":0}}})", R"({"anyOf":[{"items":{"oneOf":[]}}]})"})
    CHECK_THROWS_AS(JsonSchema(json::parse(unknown)), std::invalid_argument);
}

TEST_CASE("a reader that has gone ends the program quietly, by the signal, or an error if that is ignored") {
  for (void (*const on_broken_pipe)(int) : {SIG_DFL, SIG_IGN}) {
    const ScratchFile errors;
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    close(ends[0]);  // before any writer exists
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      dup2(ends[1], STDOUT_FILENO);
      if (freopen(errors.path().c_str(), "w", stderr) == nullptr) _exit(99);
      signal(SIGPIPE, on_broken_pipe);
      execl(program().c_str(), "nipref", "list", nullptr);
      _exit(99);
    }
    close(ends[1]);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    const bool is_ended = on_broken_pipe == SIG_DFL;
    CHECK(WIFSIGNALED(status) == is_ended);
    CHECK((is_ended ? WTERMSIG(status) : WEXITSTATUS(status)) == (is_ended ? SIGPIPE : 4));
    CHECK(errors.text() == (is_ended ? "" : "nipref: standard output: Broken pipe\n"));
  }
}
