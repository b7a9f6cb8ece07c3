#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

#include "support/on_terminal.hpp"

using namespace nipref;

namespace {

constexpr int status_interrupted = 130;

/// The answer of a run that is interrupted as soon as it prints `when`.
std::string answer_interrupted(std::vector<std::string> arguments, const std::string& when) {
  OnTerminal run(std::move(arguments), "xterm", 100);
  CHECK(run.wait_for(when));
  run.interrupt();
  CHECK(run.status() == status_interrupted);
  return run.output();
}

nlohmann::json json_interrupted(const std::vector<std::string>& arguments, const std::string& when) {
  auto answer = nlohmann::json::parse(answer_interrupted(arguments, when));
  CHECK(answer.at("interrupted") == true);
  return answer;
}

/// The exit status of a process of its own that does this work; negative: the signal that ended it.
int end_of(void (*work)()) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

TEST_CASE("Ctrl-C: audit, bench and tables answer with what is finished, 130, and say that it is not all") {
  if (!has_terminals()) return;
  const std::vector<std::string> audit{"audit", "I3", "I1", "I2", "I4", "I5", "I6"};
  std::vector<std::string> audit_json = audit;
  audit_json.emplace_back("--json");
  const auto rows = json_interrupted(audit_json, "] I1,").at("rows");
  REQUIRE(rows.size() >= 1);
  CHECK(rows.size() < 6);
  CHECK(rows[0].at("quantity") == "I3");
  const auto bench = json_interrupted({"bench", "I3", "I1", "F1", "--json"}, "bench 1/").at("rows");
  REQUIRE(bench.size() >= 1);
  CHECK(bench.back().at("quantity") != "F1");
  const auto tables = json_interrupted({"tables", "--json"}, "tables 1/").at("tables");
  CHECK(tables.size() >= 1);
  CHECK(tables.size() < 20);
  const std::string text = answer_interrupted(audit, "] I1,");
  CHECK(contains(text, " I3 "));
  CHECK(!contains(text, " I6 "));
  CHECK(contains(text, "\ninterrupted: "));
}

TEST_CASE("an interrupted loop throws, leaving the rest, the second interrupt kills, unless ignored before") {
  CHECK(end_of([] {
          verify::stop_gently_on_interrupt();
          std::raise(SIGINT);
          int done = 0;
          try {
            verify::parallel_for(100, [&](std::size_t) { ++done; });
          } catch (const verify::Interrupted&) {
            _exit(done == 0 ? 7 : 8);
          }
        }) == 7);
  CHECK(end_of([] {
          verify::stop_gently_on_interrupt();
          std::raise(SIGINT);
          std::raise(SIGINT);
        }) == -SIGINT);
  CHECK(end_of([] {
          std::signal(SIGINT, SIG_IGN);
          verify::stop_gently_on_interrupt();
          std::raise(SIGINT);
          if (verify::interrupted()) _exit(9);
        }) == 0);
}

TEST_CASE("progress overwrites its line on a terminal, not on a dumb one, and not if it shall be quiet") {
  if (!has_terminals()) return;
  const auto told = [](const char* term, std::vector<std::string> arguments) {
    OnTerminal run(std::move(arguments), term, 40);
    CHECK(run.status() == 0);
    return run.told();
  };
  const std::string wipe = "\r\x1b[K";
  CHECK(contains(told("xterm", {"audit", "I3"}), wipe + "audit 0/"));
  CHECK(told("dumb", {"audit", "I3"}).find('\r') == std::string::npos);
  CHECK(told("xterm", {"audit", "I3", "--quiet"}).empty());
}
