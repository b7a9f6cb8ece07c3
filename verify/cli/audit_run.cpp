#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/house.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/report/report.hpp>

namespace nipref::verify {
namespace {

constexpr const char* contacts = "contacts";

constexpr double quick = 0.1;
constexpr double thorough = 10;

double density_option(const CommandLine& line) {
  if (line.has("quick")) return quick;
  if (line.has("thorough")) return thorough;
  return line.number("density").value();
}

/// The number of scenes: the one that is given, or the default times the density.
std::size_t scenes_option(const CommandLine& line) {
  const std::size_t scenes = line.count("scenes");
  if (line.option("scenes")) return scenes;
  return static_cast<std::size_t>(
      std::max(1.0, std::round(density_option(line) * static_cast<double>(scenes))));
}

/// Refuses options without effect. --points is for named quantities only, because a number of points that is quick for
/// one quantity takes hours for another.
void refuse_options_without_effect(const CommandLine& line, const Selection& selected) {
  if (line.words.empty() && !line.has("changed"))
    refuse_option(line, "points",
                  "must be left out without names of quantities: --density is for all of them");
  if (!selected.quantities.empty()) return;
  for (const char* const name : {"points", "rtol"})
    refuse_option(line, name, "has no effect on contacts: must be left out");
}

/// Refuses ranges of arguments that one of the quantities does not have, and texts that are no ranges.
void refuse_ranges(const CommandLine& line, const Selection& selected) {
  if (line.assignments.empty()) return;
  if (selected.has(contacts) || line.has("changed"))
    throw data::BadInput(line.assignments.front().first, line.assignments.front().second,
                         "has an effect on quantities that are named only: must be left out");
  for (const Quantity* quantity : selected.quantities)
    static_cast<void>(parse_ranges(*quantity, line.assignments));
}

/// The quantities and contacts that depend on changed files.
Selection changed_selection(const CommandLine& line) {
  if (!line.words.empty()) refuse_option(line, "changed", "must be left out beside names");
  const std::set<std::string> subjects =
      touched_subjects(changed_files(line.option("since").value_or("HEAD")));
  Selection selected;
  for (const Quantity& quantity : catalogue())
    if (subjects.contains(std::string(quantity.subject))) selected.quantities.push_back(&quantity);
  if (subjects.contains(contacts)) selected.groups.push_back(contacts);
  return selected;
}

Selection selected_by(const CommandLine& line) {
  Selection selected = line.has("changed") ? changed_selection(line) : selection(line.words, {contacts});
  refuse_options_without_effect(line, selected);
  if (!selected.has(contacts))
    refuse_option(line, "scenes", "has an effect on contacts only: must be left out");
  refuse_ranges(line, selected);
  return selected;
}

/// Options that do not determine the findings: where these are stored, who computes them and how they are printed.
const std::set<std::string> without_effect{"out", "shard", "quiet", "json", "no-times"};

/// The command line in the fingerprint of a run's folder.
CommandLine command_of(const std::filesystem::path& folder, const std::string& fingerprint) {
  try {
    std::vector<std::string> words{"nipref"};
    for (const Json& word : Json::parse(fingerprint).at("command").items()) words.push_back(word.as_text());
    const auto pointers = mapped(words, &std::string::c_str);
    return parse_command_line(static_cast<int>(pointers.size()), pointers.data());
  } catch (const JsonMisfit& misfit) {
    throw data::BadInput("run", folder.string(),
                         std::string("must have a run.json as --out makes it: ") + misfit.what());
  }
}

}  // namespace

AuditRun::AuditRun(const CommandLine& line, bool keeps_points)
    : shard_(parse_shard(line.option("shard").value_or("1/1"))),
      command_(json_list(words_of(line, without_effect))) {
  const Selection selected = selected_by(line);
  accuracy_ = accuracy_option(line);
  std::vector<BlockWork*> works;
  for (const Quantity* quantity : selected.quantities) {
    AuditOptions options = sampling_options(line, *quantity, density_option(line));
    options.accuracy = accuracy_;
    quantities_.push_back(std::make_unique<QuantityWork>(*quantity, options, keeps_points));
    works.push_back(quantities_.back().get());
  }
  const std::size_t scenes = scenes_option(line);  // a wrong number is refused even without contacts
  if (selected.has(contacts)) {
    hard_cases_ = hard_cases_work();
    scenes_ = scenes_work(scenes, line.option_or_usual("seed"));
    works.insert(works.end(), {hard_cases_.get(), scenes_.get()});
  }
  stored_ = StoredBlocks(works);
  const auto folder = line.option("out");
  if (!folder) return;
  file_.emplace(*folder, fingerprint(), shard_);
  stored_.read(*folder);
  there_ = stored_.count();
}

std::string AuditRun::fingerprint() const {
  const Json works = json_list(stored_.works(), [](const BlockWork* work) {
    return Json{{"name", work->name()}, {"blocks", work->blocks()}, {"inputs", work->inputs()}};
  });
  return Json{{"program", program_json()}, {"command", command_}, {"works", works}}.text();
}

void AuditRun::do_blocks(Progress& progress) {
  struct Block {
    std::size_t work, number;
  };
  const std::vector<BlockWork*>& works = stored_.works();
  std::vector<Block> missing;
  for (std::size_t i = 0; i < works.size(); ++i)
    for (std::size_t block = 0; block < works[i]->blocks(); ++block)
      if (shard_.has(block) && !stored_.has(i, block)) missing.push_back({i, block});
  const auto name = [&](const Block& block) { return works[block.work]->name(); };
  progress.each("audit", missing, name, [&](const Block& block) {
    BlockWork& work = *works[block.work];
    const Json found = work.do_block(block.number, [&](double part) { progress.at(part); });
    if (file_) file_->append(work, block.number, found);
    stored_.add(block.work, block.number);
  });
}

void AuditRun::merge(const std::vector<std::filesystem::path>& folders) {
  for (const auto& folder : folders) stored_.read(folder);
  if (const std::string gaps = stored_.gaps(); !gaps.empty())
    throw data::BadInput("run", folders.front().string(), "must have all its blocks: without " + gaps);
}

Audited AuditRun::found() const {
  Audited audited;
  for (std::size_t i = 0; i < quantities_.size() && stored_.has_all_of(i); ++i)
    audited.quantities.push_back(quantities_[i]->result());
  if (!hard_cases_) return audited;
  audited.hard_cases = hard_cases_->result();
  audited.scenes = scenes_->result();
  return audited;
}

VerbAnswer AuditRun::answer(const CommandLine& line) const {
  if (!file_ || (!line.option("shard") && !interrupted())) {
    const Audited audited = found();
    Json answer = audits_json(audited, accuracy_);
    answer.set("_of_contacts", hard_cases_ != nullptr);
    answer.set("_of_nothing", audited.quantities.empty() && !hard_cases_);
    return {"audit", answer, audited.kept()};
  }
  const std::string shard = fmt::format("{}/{}", shard_.index + 1, shard_.of);
  const Json members{
      {"run", line.option("out")}, {"shard", shard},         {"blocks_done", stored_.count() - there_},
      {"blocks_there", there_},    {"blocks", stored_.of()}, {"_interrupted", interrupted()}};
  return {"audit", members, true, "audit_shard.txt"};
}

VerbAnswer audit_verb(const CommandLine& line) {
  Progress progress(line.has("quiet"));
  AuditRun run(line);
  run.do_blocks(progress);
  return run.answer(line);
}

VerbAnswer merge_verb(const CommandLine& line) {
  const std::vector<std::filesystem::path> folders(line.words.begin(), line.words.end());
  const std::string fingerprint = fingerprint_of(folders);
  const CommandLine command = command_of(folders.front(), fingerprint);
  if (const auto isa = command.option("isa")) fast::use_instruction_set(*isa);
  AuditRun run(command);
  refuse_other_fingerprint(folders.front(), fingerprint, run.fingerprint());
  run.merge(folders);
  return run.answer(line);
}

}  // namespace nipref::verify
