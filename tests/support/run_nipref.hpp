#pragma once
#include <sys/wait.h>
#include <wordexp.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

#include "support/paths.hpp"
#include "support/scratch.hpp"

struct Outcome {
  int status;
  std::string out;
  std::string err;
};

/// Runs these commands in a shell and returns their outcome.
inline Outcome outcome_in_shell(const std::string& commands) {
  const ScratchFile errors;
  FILE* pipe = popen(("{ " + commands + "\n} 2>'" + errors.path() + "'").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string out;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    out.append(buffer.data(), count);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out, errors.text()};
}

/// Runs the program with these arguments, as a shell reads them.
inline Outcome run(const std::string& arguments) {
  return outcome_in_shell("'" + program() + "' " + arguments);
}

/// Runs the program's code in this process, because a process takes more time than most answers. Uses run() if the
/// shell must do more than split the words, if an instruction set is chosen, which holds for the whole process, and for
/// verbs that start or compare the program's file.
inline Outcome outcome_of_call(const std::string& arguments) {
  constexpr std::array of_file{"bench", "merge", "report"};
  wordexp_t words{};
  const bool needs_process =
      contains(arguments, "isa=") ||
      std::ranges::any_of(of_file, [&](const char* verb) { return arguments.starts_with(verb); });
  if (needs_process || wordexp(("nipref " + arguments).c_str(), &words, WRDE_NOCMD) != 0)
    return run(arguments);
  const auto [status, output, complaint] =
      nipref::verify::answer(static_cast<int>(words.we_wordc), words.we_wordv);
  wordfree(&words);
  return {status, nipref::verify::plain(output), complaint.empty() ? "" : "nipref: " + complaint + "\n"};
}

/// The program's answer in JSON. Checks the exit status.
inline nlohmann::json answer_to(const std::string& arguments, int status = 0) {
  const Outcome outcome = outcome_of_call(arguments + " --json");
  CAPTURE(arguments, outcome.err);
  REQUIRE(outcome.status == status);
  return nlohmann::json::parse(outcome.out);
}

/// The message of a refused call: one line on standard error, with status 2 and nothing on standard output.
inline std::string refusal_of_call(const std::string& arguments) {
  const Outcome outcome = outcome_of_call(arguments);
  CAPTURE(arguments, outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
  return outcome.err;
}

inline void check_call_refused(const std::string& arguments, const std::string& says) {
  CHECK(contains(refusal_of_call(arguments), says));
}
