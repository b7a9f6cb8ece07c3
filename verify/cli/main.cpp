#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/program.hpp>
#include <nipref/verify/cli/tables.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

namespace {

using namespace nipref;

int run(const verify::CommandLine& line, std::ostream& out) {
  if (line.help) {
    out << verify::folded(*line.help);
    return 0;
  }
  if (line.version) {
    out << (line.json ? verify::version_answer_text() : verify::folded(verify::version_text()));
    return 0;
  }
  if (const auto isa = line.option("isa")) fast::use_instruction_set(*isa);
  if (line.verb == "list") return verify::list_verb(line, out);
  if (line.verb == "eval") return verify::eval_verb(line, out);
  if (line.verb == "solve") return verify::solve_verb(line, out);
  if (line.verb == "balance") return verify::balance_verb(line, out);
  if (line.verb == "audit") return verify::audit_verb(line, out);
  if (line.verb == "merge") return verify::merge_verb(line, out);
  if (line.verb == "points") return verify::points_verb(line, out);
  if (line.verb == "grade") return verify::grade_verb(line, out);
  if (line.verb == "golden") return verify::golden_verb(line, out);
  if (line.verb == "limits") return verify::limits_verb(line, out);
  if (line.verb == "claims") return verify::claims_verb(line, out);
  if (line.verb == "errata") return verify::errata_verb(line, out);
  if (line.verb == "figures") return verify::figures_verb(line, out);
  if (line.verb == "bench") return verify::bench_verb(line, out);
  if (line.verb == "report") return verify::report_verb(line, out);
  return verify::tables_verb({.ids = line.words,
                              .list = line.has("list"),
                              .full = line.has("full"),
                              .json = line.json,
                              .quiet = line.has("quiet")},
                             out);
}

}  // namespace

int main(int argc, char** argv) { return verify::program_status(argc, argv, run); }
