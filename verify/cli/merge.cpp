#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/cli/verbs.hpp>

namespace nipref::verify {
namespace {

CommandLine command_of(const std::filesystem::path& folder, const std::string& fingerprint) {
  try {
    return command_of_fingerprint(fingerprint);
  } catch (const JsonMisfit& misfit) {
    throw data::BadInput("run", folder.string(),
                         std::string("must have a run.json as --out makes it: ") + misfit.what());
  }
}

}  // namespace

int merge_verb(const CommandLine& line, std::ostream& out) {
  if (line.words.empty())
    throw data::BadInput("run", "(missing)", "must be the folder of a run, or several of one run");
  const std::vector<std::filesystem::path> folders(line.words.begin(), line.words.end());
  const std::string fingerprint = fingerprint_of(folders);
  const CommandLine command = command_of(folders.front(), fingerprint);
  if (const auto isa = command.option("isa")) fast::use_instruction_set(*isa);
  const AuditWorks works(command, false);
  refuse_other_fingerprint(folders.front(), fingerprint, works.fingerprint());
  const std::vector<BlockWork*> all = works.all();
  BlocksThere there(all);
  for (const auto& folder : folders) read_blocks(folder, all, there);
  const std::string gaps = there.gaps();
  if (!gaps.empty())
    throw data::BadInput("run", folders.front().string(), "must have all its blocks: without " + gaps);
  return works.answer(line, out, all.size());
}

}  // namespace nipref::verify
