#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/paths.hpp"
#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"
#include "support/test.hpp"

TEST_CASE("what cannot be written is an error with its reason, status 4") {
  for (const std::string call : {"list", "list --json", "eval I1 alpha=0.73", "solve --help", "--version",
                                 "tables thesis-VII --json"}) {
    for (const auto& [output, reason] :
         {std::pair{" >/dev/full", "No space left on device"}, std::pair{" >&-", "Bad file descriptor"}}) {
      CAPTURE(call);
      const Outcome outcome = run(call + output);
      CHECK(outcome.status == 4);
      CHECK(outcome.err == std::string("nipref: standard output: ") + reason + "\n");
    }
  }
}

TEST_CASE("an error that cannot be answered is told on standard error, if that is open, with its status") {
  const Outcome outcome = run("eval I9 --json >/dev/full");
  CHECK(outcome.status == 4);
  CHECK(std::ranges::count(outcome.err, '\n') == 2);
  CHECK(contains(outcome.err, "quantity = I9"));
  CHECK(contains(outcome.err, "No space left on device"));
  const Outcome good = run("eval I1 alpha=0.73 2>&-; exit $?");
  CHECK(good.status == 0);
  CHECK(contains(good.out, "0.20699024464081926702"));
  const Outcome bad = run("eval I9 2>&-; exit $?");
  CHECK(bad.status == 2);
  CHECK(bad.out.empty());
}

TEST_CASE(
    "a reader that has gone ends the program quietly, by the signal, or by an error where that is ignored") {
  for (void (*const on_broken_pipe)(int) : {SIG_DFL, SIG_IGN}) {
    const ScratchFile errors;
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    close(ends[0]);  // before there is anybody who could write
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
