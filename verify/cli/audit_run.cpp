#include <fmt/format.h>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
AuditRun::AuditRun(const CommandLine& line, bool keeps_points)
    : line_(line),
      shard_(parse_shard(line.option("shard").value_or("1/1"))),
      works_(line, keeps_points),
      all_(works_.all()),
      blocks_done_(all_.size()) {
  const auto folder = line.option("out");
  if (!folder) return;
  file_.emplace(*folder, works_.fingerprint(), shard_);
  there_.emplace(all_);
  read_blocks(*folder, all_, *there_);
  for (std::size_t work = 0; work < all_.size(); ++work) {
    for (std::size_t block = 0; block < all_[work]->blocks(); ++block)
      blocks_done_[work] += there_->has(work, block) ? 1U : 0U;
  }
}

std::optional<BlockAt> AuditRun::next() {
  for (; at_.work < all_.size(); at_ = {at_.work + 1, 0}) {
    while (at_.block < all_[at_.work]->blocks()) {
      const BlockAt here{at_.work, at_.block++};
      if (shard_.has(here.block) && !(there_ && there_->has(here.work, here.block))) return here;
    }
  }
  return std::nullopt;
}

void AuditRun::keep(BlockAt at, const BlockFindings& found) {
  if (file_) file_->append(*all_[at.work], at.block, block_findings_json(found));
  all_[at.work]->add(at.block, found);
  ++blocks_done_[at.work];
  ++done_;
}

void AuditRun::do_blocks(Progress& progress) try {
  progress.begin("audit", all_.size());
  std::size_t begun = 0;  // works
  while (const auto at = next()) {
    stop_if_interrupted();
    const BlockWork& work = *all_[at->work];
    for (; begun <= at->work; ++begun) progress.next(all_[begun]->name());
    const auto of_work = [&](double part) {
      progress.at((static_cast<double>(at->block) + part) / static_cast<double>(work.blocks()));
    };
    keep(*at, work.found_in(at->block, of_work));
  }
} catch (const Interrupted&) {
}

std::size_t AuditRun::finished() const {
  std::size_t work = 0;
  while (work < all_.size() && work <= at_.work && blocks_done_[work] == all_[work]->blocks()) ++work;
  return work;
}

int AuditRun::answer(std::ostream& out) const {
  if (!file_ || (!line_.option("shard") && !interrupted())) return works_.answer(line_, out, finished());
  const std::string folder = line_.option("out").value();
  const std::string shard = fmt::format("{}/{}", shard_.index + 1, shard_.of);
  const Json members{{"run", folder},          {"shard", shard},
                     {"blocks_done", done_},   {"blocks_there", there_->count()},
                     {"blocks", there_->of()}, {"_interrupted", interrupted()}};
  return write_answer(line_, out, "audit", true, members, "audit_shard.txt");
}

int audit_verb(const CommandLine& line, std::ostream& out) {
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  AuditRun run(line);
  run.do_blocks(progress);
  return run.answer(out);
}

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
