#include <fmt/format.h>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/audit_works.hpp>
#include <nipref/verify/cli/interruption.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/cli/verbs.hpp>

namespace nipref::verify {
namespace {

/// What a process does of a run: of its shard's blocks those that are not there, one after the other, each on all cores.
class Doing {
 public:
  Doing(const std::vector<BlockWork*>& works, Shard shard, Progress& progress)
      : works_(works), shard_(shard), progress_(progress) {}

  /// Calls done(work, block, found) after each; until all are done or the process is interrupted. Gives the number of
  /// works whose blocks are all done.
  template <class IsThere, class Done>
  std::size_t run(IsThere is_there, Done done) {
    progress_.begin("audit", works_.size());
    for (std::size_t w = 0; w < works_.size(); ++w) {
      progress_.next(works_[w]->name());
      const std::size_t blocks = works_[w]->blocks();
      for (std::size_t block = 0; block < blocks; ++block) {
        if (!shard_.has(block) || is_there(w, block)) continue;
        const auto told = [&](double part) {
          progress_.at((static_cast<double>(block) + part) / static_cast<double>(blocks));
        };
        try {
          stop_if_interrupted();
          done(w, block, works_[w]->found_in(block, told));
        } catch (const Interrupted&) {
          return w;
        }
      }
    }
    return works_.size();
  }

 private:
  const std::vector<BlockWork*>& works_;
  Shard shard_;
  Progress& progress_;
};

void tell_shard(const CommandLine& line, const std::string& folder, Shard shard, const BlocksThere& there,
                std::size_t done, std::ostream& out) {
  if (line.json) {
    out << answer_text("audit",
                       {{"run", folder},
                        {"shard", fmt::format("{}/{}", shard.index + 1, shard.of)},
                        {"blocks_done", done},
                        {"blocks_there", there.count()},
                        {"blocks", there.of()}},
                       line.no_times);
  } else {
    out << fmt::format("{}: {} of {} blocks were there at the start; shard {}/{} did {} more\n", folder,
                       there.count(), there.of(), shard.index + 1, shard.of, done)
        << (interrupted()
                ? "interrupted: the same command goes on\n"
                : fmt::format("nipref merge {} tells what was found when all shards are done\n", folder));
  }
}

/// In a folder, in which it goes on where it was. A shard tells what it did, and status 0: launchers end all ranks when
/// one gives another. All of a run tells what is in the folder then.
int audit_into(const CommandLine& line, const std::string& folder, Progress& progress, std::ostream& out) {
  const std::string shard_text = line.option("shard").value_or("1/1");
  const Shard shard = parse_shard(shard_text);
  const AuditWorks works(line);
  const std::vector<BlockWork*> all = works.all();
  ShardFile file(folder, works.fingerprint(), shard);
  BlocksThere there(all);
  read_blocks(folder, all, there);
  std::size_t done = 0;
  const std::size_t finished =
      Doing(all, shard, progress)
          .run([&](std::size_t work, std::size_t block) { return there.has(work, block); },
               [&](std::size_t work, std::size_t block, const Json& found) {
                 file.append(*all[work], block, found);
                 all[work]->add(block, found);
                 ++done;
               });
  if (line.option("shard") || interrupted()) {
    tell_shard(line, folder, shard, there, done, out);
    return 0;
  }
  return works.answer(line, out, finished);
}

}  // namespace

int audit_verb(const CommandLine& line, std::ostream& out) {
  const auto folder = line.option("out");
  if (!folder) refuse_option(line, "shard", "must be given with --out, where what it finds is kept");
  if (folder)
    refuse_option(line, "changed", "must be left out beside --out: a run is of quantities that are named");
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  if (folder) return audit_into(line, *folder, progress, out);
  const AuditWorks works(line);
  const std::vector<BlockWork*> all = works.all();
  const std::size_t finished =
      Doing(all, {}, progress)
          .run([](std::size_t, std::size_t) { return false; },
               [&](std::size_t work, std::size_t block, const Json& found) { all[work]->add(block, found); });
  return works.answer(line, out, finished);
}

}  // namespace nipref::verify
