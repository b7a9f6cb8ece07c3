#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/output.hpp>
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
    out << verify::version_answer_text(line.json);
    return 0;
  }
  if (const auto isa = line.option("isa")) fast::use_instruction_set(*isa);
  return verify::find_verb(line.verb).run(line, out);
}

}  // namespace

int main(int argc, char** argv) { return verify::program_status(argc, argv, run); }
