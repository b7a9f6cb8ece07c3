#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <fstream>

#include <nipref/data/input_file.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/run_folder.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;
using data::BadInput;

constexpr auto fingerprint_name = "run.json";
constexpr std::size_t most_gaps_named = 3;

std::string text_of(const fs::path& file) { return data::text_of_input_file(file, "run"); }

/// Throws OutputError unless an operation on a file succeeded.
void must(bool done, const fs::path& file) {
  if (!done) throw OutputError(file.string());
}

/// Opens a file. What is written to it is on the disk when the write returns.
int opened(const fs::path& file, int flags) {
  const int number = open(file.c_str(), flags | O_CLOEXEC | O_SYNC, 0666);
  must(number >= 0, file);
  return number;
}

/// Syncs a folder, so that a new name in it is on the disk.
void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(opened(folder, O_RDONLY | O_DIRECTORY));
  must(fsync(descriptor.number()) == 0 || errno == EINVAL, folder);  // EINVAL: folders cannot be synced
}

/// Writes a file unless it exists. If several processes try at the same time, one of them writes the whole file; `who`
/// differs between them.
void write_once(const fs::path& file, std::string_view text, const std::string& who) {
  if (fs::exists(file)) return;
  fs::path ours = file;
  ours += fmt::format(".{}.{}", who, getpid());
  must(write_all(Descriptor(opened(ours, O_WRONLY | O_CREAT | O_TRUNC)).number(), text), ours);
  const bool done = link(ours.c_str(), file.c_str()) == 0 || errno == EEXIST;
  const int why = errno;
  unlink(ours.c_str());
  errno = why;
  must(done, file);
  sync_folder(file.parent_path());
}

bool is_shard_file(const fs::path& file) {
  return file.filename().string().starts_with("shard-") && file.extension() == ".jsonl";
}

}  // namespace

Shard parse_shard(const std::string& text) {
  constexpr std::size_t most_shards = 1'000'000;
  std::size_t index = 0, of = 0;
  const char* const end = text.data() + text.size();
  const char* const slash = std::from_chars(text.data(), end, index).ptr;
  const bool is_shard = slash != end && *slash == '/' && std::from_chars(slash + 1, end, of).ptr == end;
  if (!is_shard || index < 1 || index > of || of > most_shards)
    refuse("shard", text, "must be i/N with 1 <= i <= N <= {}", most_shards);
  return {index - 1, of};
}

StoredBlocks::StoredBlocks(std::vector<BlockWork*> works) : works_(std::move(works)) {
  for (const BlockWork* work : works_) hashes_.emplace_back(work->blocks());
}

bool StoredBlocks::has_all_of(std::size_t work) const {
  return std::ranges::find(hashes_[work], std::size_t{0}) == hashes_[work].end();
}

std::size_t StoredBlocks::count() const {
  std::size_t sum = 0;
  for (const auto& hashes : hashes_)
    sum += hashes.size() - static_cast<std::size_t>(std::ranges::count(hashes, std::size_t{0}));
  return sum;
}

std::size_t StoredBlocks::of() const {
  std::size_t sum = 0;
  for (const auto& hashes : hashes_) sum += hashes.size();
  return sum;
}

bool StoredBlocks::add(std::size_t work, std::size_t block, const std::string& line,
                       const std::string& where) {
  std::size_t& known = hashes_[work][block];
  const std::size_t hash = std::max<std::size_t>(1, std::hash<std::string>()(line));
  if (std::exchange(known, known == 0 ? hash : known) == 0) return true;
  if (known != hash)
    refuse("run", where, "must have what another line has for {} block {}", works_[work]->name(), block);
  return false;
}

std::string StoredBlocks::gaps() const {
  std::vector<std::string> named;
  std::size_t unnamed = 0;
  for (std::size_t work = 0; work < hashes_.size(); ++work) {
    const auto& hashes = hashes_[work];
    for (std::size_t block = 0; block < hashes.size(); ++block) {
      const std::size_t first = block;
      while (block < hashes.size() && hashes[block] == 0) ++block;
      if (block == first) continue;
      if (named.size() < most_gaps_named) {
        const char* const form = block - first == 1 ? "{} block {}" : "{} blocks {} to {}";
        named.push_back(fmt::format(fmt::runtime(form), works_[work]->name(), first, block - 1));
      } else {
        unnamed += block - first;
      }
    }
  }
  const std::string text = fmt::format("{}", fmt::join(named, ", "));
  return unnamed > 0 ? fmt::format("{} and {} more", text, unnamed) : text;
}

std::string fingerprint_of(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    std::error_code none;
    if (!fs::exists(folder / fingerprint_name, none))
      refuse("run", folder.string(), "must be a folder with a {}, as --out makes it", fingerprint_name);
  }
  std::string first = text_of(folders.front() / fingerprint_name);
  for (const fs::path& folder : folders)
    refuse_other_fingerprint(folder, text_of(folder / fingerprint_name), first);
  return first;
}

void refuse_other_fingerprint(const fs::path& folder, const std::string& found, const std::string& expected) {
  if (found == expected) return;
  std::istringstream ours(expected), theirs(found);
  std::string our_line, their_line;
  while (std::getline(ours, our_line) && std::getline(theirs, their_line) && our_line == their_line) {
  }
  const auto trimmed = [](const std::string& line) {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    return line.substr(start, line.find_last_not_of(", ") + 1 - start);
  };
  refuse("run", folder.string(),
         "must be of the same program, command and inputs: there is {} where {} must be", trimmed(their_line),
         trimmed(our_line));
}

void StoredBlocks::read(const fs::path& folder) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_shard_file(entry.path())) files.insert(entry.path());
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    std::size_t number = 0;
    for (std::string line;
         std::getline(stream, line) && !stream.eof();) {  // an incomplete last line is ignored
      const std::string where = fmt::format("{}:{}", file.string(), ++number);
      try {
        const Json json = Json::parse(line);
        const auto work = std::ranges::find(works_, json.at("work").as_text(), &BlockWork::name);
        const std::size_t block = json.at("block").as_count();
        if (work == works_.end() || block >= (*work)->blocks()) throw JsonMisfit("block");
        if (add(static_cast<std::size_t>(work - works_.begin()), block, json.without("times").line(), where))
          (*work)->add(block, json.at("found"));
      } catch (const JsonMisfit& misfit) {
        refuse("run", where, "must be the line of a block of this run ({})", misfit.what());
      }
    }
  }
}

ShardFile::ShardFile(const fs::path& folder, const std::string& fingerprint, Shard shard)
    : path_((folder / fmt::format("shard-{}-of-{}.jsonl", shard.index + 1, shard.of)).string()) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error))
    throw BadInput("out", folder.string(), "must be a folder, or one that can be made");
  write_once(folder / fingerprint_name, fingerprint, fs::path(path_).stem().string());
  refuse_other_fingerprint(folder, text_of(folder / fingerprint_name), fingerprint);
  const int number = file_.emplace(opened(path_, O_RDWR | O_CREAT | O_APPEND)).number();
  if (flock(number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    refuse("out", folder.string(), "must be left to the process that is writing {}", path_);
  const std::size_t last_end = text_of(path_).rfind('\n');  // npos + 1 is the file's start
  must(ftruncate(number, static_cast<off_t>(last_end + 1)) == 0, path_);
  sync_folder(folder);
}

void ShardFile::append(const BlockWork& work, std::size_t block, const Json& found) {
  const Json line{{"work", work.name()}, {"block", block}, {"found", found}};
  must(write_all(file_->number(), line.line() + "\n"), path_);
}

}  // namespace nipref::verify
