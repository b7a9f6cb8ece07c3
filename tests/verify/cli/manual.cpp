#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/process.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

/// The words that a shell offers after these words of a command line, one a line; empty without this shell.
std::string offered_by(const std::string& shell, const std::string& words) {
  const std::string completion = verify::completion_for(shell);
  // zsh itself leaves out words that do not match.
  const std::map<std::string, std::pair<std::vector<std::string>, std::string>> ways{
      {"bash",
       {{"bash"},
        completion + "COMP_WORDS=(" + words +
            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _nipref; printf '%s\\n' \"${COMPREPLY[@]}\""}},
      {"zsh",
       {{"zsh", "-f"},
        "compadd() { print -l -- \"$@\" }; _files() {}; words=(" + words + "); CURRENT=${#words}; () { " +
            completion + "\n}"}},
      {"fish", {{"fish", "--no-config"}, completion + "complete -C'" + words + "'"}}};
  const auto& [command, script] = ways.at(shell);
  const verify::ProgramOutput output = verify::output_of(command, script);
  return output.status == 0 ? "\n" + output.text : "";
}

}  // namespace

TEST_CASE("the manual's page tells of every verb and option, and roff takes it without a warning") {
  const std::string page = verify::manual_page();
  for (const verify::VerbText& verb : verify::verbs()) {
    CAPTURE(verb.name);
    CHECK(contains(page, "\n.SS " + verb.name + "\n"));
  }
  for (const char* option : {"\\-\\-digits", "\\-\\-no\\-times", "\\-\\-max\\-slowdown"})
    CHECK(contains(page, option));
  const verify::ProgramOutput set =
      verify::output_of({"sh", "-c", "groff -man -Tascii -P-cbou -ww 2>&1"}, page);
  if (set.status == verify::status_not_found) {
    MESSAGE("skipped: groff is not installed");
    return;
  }
  CHECK(set.status == 0);
  CHECK(!contains(set.text, "warning"));
  CHECK(contains(set.text, "EXIT STATUS"));
}

TEST_CASE("bash, zsh and fish complete verbs, quantities, options, scenes and tables") {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    if (offered_by(shell, "nipref ").empty()) {
      MESSAGE("skipped: zsh or fish is not installed");
      continue;
    }
    for (const auto& [words, wanted] : {std::pair{"nipref lim", "limits"},
                                        {"nipref ti.crit", "ti.critical"},
                                        {"nipref help so", "solve"},
                                        {"nipref solve --di", "--digits"},
                                        {"nipref solve thick-full-f", "thick-full-friction"},
                                        {"nipref golden ch", "check"},
                                        {"nipref grade mine.so ti.crit", "ti.critical"},
                                        {"nipref eval I6 al", "alpha="},
                                        {"nipref I6 et", "eta="}}) {
      CAPTURE(words);
      CHECK(contains(offered_by(shell, words), "\n" + std::string(wanted) + "\n"));
    }
  }
  CHECK(offered_by("bash", "nipref solve thick-full-friction-l") == "\n\n");
  CHECK(offered_by("bash", "nipref tables thesis-VII") == "\nthesis-VII\nthesis-VIII\n");
  CHECK(offered_by("bash", "nipref audit --quick I") == "\nI1\nI2\nI3\nI4\nI5\nI6\nI7\n");
}
