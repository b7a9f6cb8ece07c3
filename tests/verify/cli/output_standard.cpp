#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/paths.hpp"
#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"
#include "support/test.hpp"

namespace {

constexpr const char* calls[] = {
    "list",      "list --json",         "eval I1 alpha=0.73", "solve --help",
    "--version", "audit I3 points=100", "tables --list",      "tables thesis-VII --json"};

void check_not_written(const std::string& arguments, const std::string& reason) {
  CAPTURE(arguments);
  const Outcome outcome = run(arguments);
  CHECK(outcome.status == 4);
  CHECK(outcome.err == "nipref: standard output: " + reason + "\n");
}

struct Ending {
  int status;  ///< as waitpid tells it
  std::string err;
};

/// `nipref list` into a pipe that nobody reads.
Ending list_to_nobody(void (*on_broken_pipe)(int)) {
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
  return {status, errors.text()};
}

}  // namespace

TEST_CASE("what cannot be written is an error with its reason, status 4") {
  for (const std::string call : calls) {
    check_not_written(call + " >/dev/full", "No space left on device");
    check_not_written(call + " >&-", "Bad file descriptor");
  }
}

TEST_CASE("an error that cannot be answered either is told on standard error") {
  const Outcome outcome = run("eval I9 --json >/dev/full");
  CHECK(outcome.status == 4);
  CHECK(std::ranges::count(outcome.err, '\n') == 2);
  CHECK(contains(outcome.err, "quantity = I9"));
  CHECK(contains(outcome.err, "No space left on device"));
}

TEST_CASE("a closed standard error takes nothing from the answer or the status") {
  const Outcome good = run("eval I1 alpha=0.73 2>&-; exit $?");
  CHECK(good.status == 0);
  CHECK(contains(good.out, "0.20699024464081926702"));
  const Outcome bad = run("eval I9 2>&-; exit $?");
  CHECK(bad.status == 2);
  CHECK(bad.out.empty());
}

TEST_CASE("a reader that has gone ends the program quietly, by the signal") {
  const Ending ending = list_to_nobody(SIG_DFL);
  CHECK(WIFSIGNALED(ending.status));
  CHECK(WTERMSIG(ending.status) == SIGPIPE);
  CHECK(ending.err.empty());
}

TEST_CASE("with that signal ignored the reader's absence is an error as any other") {
  const Ending ending = list_to_nobody(SIG_IGN);
  REQUIRE(WIFEXITED(ending.status));
  CHECK(WEXITSTATUS(ending.status) == 4);
  CHECK(ending.err == "nipref: standard output: Broken pipe\n");
}
