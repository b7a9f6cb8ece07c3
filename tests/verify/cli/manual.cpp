#include <doctest/doctest.h>

#include <string>

#include <nipref/verify/cli/programs.hpp>
#include <nipref/verify/cli/verbs.hpp>

using namespace nipref;

namespace {

/// What bash would offer after these words of a command line, a line each.
std::string offered(const std::string& words) {
  const std::string script =
      verify::bash_completion() + "COMP_WORDS=(" + words +
      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _nipref; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const verify::ProgramOutput output = verify::output_of({"bash"}, script);
  REQUIRE(output.status == 0);
  return "\n" + output.text;
}

}  // namespace

TEST_CASE("the manual's page tells of every verb and option, and roff takes it without a warning") {
  const std::string page = verify::manual_page();
  for (const verify::VerbText& verb : verify::verbs()) {
    CAPTURE(verb.name);
    CHECK(page.find("\n.SS " + verb.name + "\n") != std::string::npos);
  }
  for (const char* option : {"\\-\\-digits", "\\-\\-no\\-times", "\\-\\-max\\-slowdown"})
    CHECK(page.find(option) != std::string::npos);
  const verify::ProgramOutput set = verify::output_of({"sh", "-c", "groff -man -Tascii -P-cbou -ww 2>&1"}, page);
  if (set.status == verify::status_not_found) {
    MESSAGE("skipped: groff is not installed");
    return;
  }
  CHECK(set.status == 0);
  CHECK(set.text.find("warning") == std::string::npos);
  CHECK(set.text.find("EXIT STATUS") != std::string::npos);
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
