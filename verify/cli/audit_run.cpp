#include <fmt/format.h>

#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
namespace {

/// So that its options are refused before what takes a while.
CommandLine checked_audit(const CommandLine& line) {
  if (!line.option("out")) {
    refuse_option(line, "shard", "must be given with --out, where what it finds is kept");
  } else {
    refuse_option(line, "changed", "must be left out beside --out: a run is of quantities that are named");
  }
  return line;
}

}  // namespace

AuditRun::AuditRun(const CommandLine& line, bool keeps_points)
    : line_(checked_audit(line)),
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

void AuditRun::write_shard(std::ostream& out) const {
  const std::string folder = line_.option("out").value();
  if (line_.json) {
    out << answer_text("audit",
                       {{"run", folder},
                        {"shard", fmt::format("{}/{}", shard_.index + 1, shard_.of)},
                        {"blocks_done", done_},
                        {"blocks_there", there_->count()},
                        {"blocks", there_->of()}},
                       line_.no_times);
  } else {
    out << fmt::format("{}: {} of {} blocks were there at the start; shard {}/{} did {} more\n", folder,
                       there_->count(), there_->of(), shard_.index + 1, shard_.of, done_)
        << (interrupted()
                ? "interrupted: the same command goes on\n"
                : fmt::format("nipref merge {} tells what was found when all shards are done\n", folder));
  }
}

int AuditRun::answer(std::ostream& out) const {
  if (!file_ || (!line_.option("shard") && !interrupted())) return works_.answer(line_, out, finished());
  write_shard(out);
  return 0;
}

}  // namespace nipref::verify
