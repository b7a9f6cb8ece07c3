#include <nipref/verify/cli/programs.hpp>
#include <nipref/verify/cli/verbs.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

/// What a shell would offer after these words of a command line, a line each.
std::string offered(const std::string& words) {
  const std::string script =
      verify::completion_for("bash") + "COMP_WORDS=(" + words +
      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _nipref; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const verify::ProgramOutput output = verify::output_of({"bash"}, script);
  REQUIRE(output.status == 0);
  return "\n" + output.text;
}

/// The same of zsh, which leaves what does not match out itself; empty without a zsh.
std::string offered_by_zsh(const std::string& words) {
  const std::string script = "compadd() { print -l -- \"$@\" }; _files() {}; words=(" + words +
                             "); CURRENT=${#words}; () { " + verify::completion_for("zsh") + "\n}";
  const verify::ProgramOutput output = verify::output_of({"zsh", "-f"}, script);
  return output.status == 0 ? "\n" + output.text : "";
}

std::string offered_by_fish(const std::string& words) {
  const std::string script = verify::completion_for("fish") + "complete -C'" + words + "'";
  const verify::ProgramOutput output = verify::output_of({"fish", "--no-config"}, script);
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

TEST_CASE("bash completes verbs, quantities, options, scenes and tables") {
  CHECK(offered("nipref lim") == "\nlimits\n");
  CHECK(offered("nipref ti.crit") == "\nti.critical\n");
  CHECK(offered("nipref help so") == "\nsolve\n");
  CHECK(offered("nipref solve --di") == "\n--digits\n");
  CHECK(offered("nipref solve thick-full-friction-l") == "\n\n");
  CHECK(offered("nipref solve thick-full-f") == "\nthick-full-friction\n");
  CHECK(offered("nipref tables thesis-VII") == "\nthesis-VII\nthesis-VIII\n");
  CHECK(offered("nipref golden ch") == "\ncheck\n");
  CHECK(offered("nipref grade mine.so ti.crit") == "\nti.critical\n");
  CHECK(offered("nipref eval I6 al") == "\nalpha=\n");
  CHECK(offered("nipref I6 et") == "\neta=\n");
  CHECK(offered("nipref audit --quick I") == "\nI1\nI2\nI3\nI4\nI5\nI6\nI7\n");
}

TEST_CASE("zsh and fish complete the same") {
  using Offered = std::string (*)(const std::string&);
  for (const Offered by_shell : {Offered(offered_by_zsh), Offered(offered_by_fish)}) {
    if (by_shell("nipref ").empty()) {
      MESSAGE("skipped: zsh or fish is not installed");
      continue;
    }
    for (const auto& [words, wanted] : {std::pair{"nipref lim", "limits"},
                                        {"nipref help so", "solve"},
                                        {"nipref solve --di", "--digits"},
                                        {"nipref solve thick-full-f", "thick-full-friction"},
                                        {"nipref golden ch", "check"},
                                        {"nipref eval I6 al", "alpha="},
                                        {"nipref I6 et", "eta="}}) {
      CAPTURE(words);
      CHECK(contains(by_shell(words), "\n" + std::string(wanted) + "\n"));
    }
  }
}
