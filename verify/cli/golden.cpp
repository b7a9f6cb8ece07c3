#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/interruption.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/output_file.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/golden/checksums.hpp>
#include <nipref/verify/golden/render.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;
using data::BadInput;

constexpr auto actions = "must be make, check, update or list";

/// Quantities after the action; all if there are none.
std::vector<const Quantity*> quantities_of(const CommandLine& line) {
  return select_quantities({line.words.begin() + 1, line.words.end()});
}

void write_with_checksum(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  Checksums sums = Checksums::of(path.parent_path());
  sums.set(path.filename().string(), text);
  write_output_file(path.string(), text);
  write_output_file((path.parent_path() / checksums_name).string(), sums.text());
}

int answer(const CommandLine& line, std::ostream& out, const std::string& text, const Json& json, bool kept) {
  if (line.json) {
    out << answer_text("golden", json, line.no_times);
  } else {
    out << folded(text) << interruption_text();
  }
  return kept ? 0 : 1;
}

/// What is not asked for is the quantity's own.
GoldenOptions options_for(const Quantity& quantity, const CommandLine& line) {
  GoldenOptions options = golden_options(quantity);
  if (line.option("points")) options.points = points_option(line);
  options.digits = digits_option(line, options.digits);
  options.seed = seed_option(line);
  return options;
}

int make(const CommandLine& line, std::ostream& out) {
  const auto quantities = quantities_of(line);
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  progress.begin("golden make", quantities.size());
  std::vector<MadeFile> files;
  bool kept = true;
  for (const Quantity* quantity : quantities) {
    progress.next(quantity->name);
    GoldenOptions options = options_for(*quantity, line);
    options.progress = [&](double part) { progress.at(part); };
    try {
      MadeGolden made = make_golden(*quantity, options, provenance());
      kept = kept && made.refused.empty();
      const fs::path path = golden_path(*quantity);
      write_with_checksum(path, golden_text(*quantity, made.file));
      files.push_back({quantity->name, path.string(), std::move(made)});
    } catch (const Interrupted&) {
      break;
    }
  }
  return answer(line, out, made_text(files), made_json(files), kept);
}

/// A word is a quantity, or a file.
fs::path file_of(const std::string& word) {
  if (const Quantity* const quantity = known_quantity(word)) return golden_path(*quantity);
  std::error_code none;
  const bool is_file =
      fs::exists(word, none) || word.find('/') != std::string::npos || word.ends_with(".csv");
  if (!is_file) refuse_quantity(word);
  data::check_input_file(word, "file");
  return word;
}

int check(const CommandLine& line, std::ostream& out) {
  std::vector<fs::path> paths;
  std::vector<GoldenFailure> folder;
  for (std::size_t i = 1; i < line.words.size(); ++i) paths.push_back(file_of(line.words[i]));
  if (paths.empty()) {
    folder = check_folder(data::golden_directory());
    for (const Quantity& quantity : catalogue()) {
      if (fs::exists(golden_path(quantity))) {
        paths.push_back(golden_path(quantity));
      } else {
        folder.push_back({GoldenFault::missing, {}, quantity.name + " has no golden values"});
      }
    }
  }
  CheckOptions options;
  options.all = line.has("all");
  options.every = every_option(line);
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  progress.begin("golden check", paths.size());
  options.progress = [&](double part) { progress.at(part); };
  std::vector<CheckedGolden> files;
  for (const fs::path& path : paths) {
    progress.next(path.stem().string());
    try {
      files.push_back(check_golden(path, options));
    } catch (const Interrupted&) {
      break;
    }
  }
  const bool kept = folder.empty() && std::ranges::all_of(files, &CheckedGolden::kept);
  return answer(line, out, checked_text(folder, files), checked_json(folder, files), kept);
}

int update(const CommandLine& line, std::ostream& out) {
  const Provenance made_with = provenance();
  if (!made_with.clean && !line.has("dirty")) {
    throw BadInput(
        "dirty", "(not given)",
        "must be given: this program was built from a tree that differs from its commit, or is of none");
  }
  const auto quantities = quantities_of(line);
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  progress.begin("golden update", quantities.size());
  std::vector<UpdatedFile> files;
  for (const Quantity* quantity : quantities) {
    progress.next(quantity->name);
    const fs::path path = golden_path(*quantity);
    if (!fs::exists(path) && line.words.size() == 1) continue;
    try {
      files.push_back({quantity->name, path.string(),
                       update_golden(*quantity, read_golden(path), line.has("all"), made_with,
                                     [&](double part) { progress.at(part); })});
    } catch (const Interrupted&) {
      files.clear();
      break;
    }
  }
  // What is told comes before what is written.
  const bool kept =
      std::ranges::all_of(files, [](const UpdatedFile& file) { return file.updated.refused.empty(); });
  const int status = answer(line, out, updated_text(files), updated_json(files), kept);
  for (const UpdatedFile& file : files) {
    if (!file.updated.changed.empty())
      write_with_checksum(file.path, golden_text(find_quantity(file.quantity), file.updated.file));
  }
  return status;
}

int list(const CommandLine& line, std::ostream& out) {
  std::vector<ListedFile> files;
  std::vector<std::string> missing;
  for (const Quantity* quantity : quantities_of(line)) {
    const fs::path path = golden_path(*quantity);
    if (fs::exists(path)) {
      files.push_back({quantity->name, path.string(), read_golden(path)});
    } else {
      missing.push_back(quantity->name);
    }
  }
  return answer(line, out, listed_text(files, missing), listed_json(files, missing), true);
}

/// BadInput for options that the action does not have.
void refuse_options_of_others(const CommandLine& line, const std::string& action) {
  const auto only = [&](const std::vector<std::string>& names, const std::vector<std::string>& with) {
    if (std::ranges::find(with, action) != with.end()) return;
    for (const std::string& name : names)
      refuse_option(line, name, fmt::format("golden {} has no such option", action));
  };
  only({"points", "digits", "seed"}, {"make"});
  only({"every"}, {"check"});
  only({"all"}, {"check", "update"});
  only({"dirty"}, {"update"});
}

}  // namespace

int golden_verb(const CommandLine& line, std::ostream& out) {
  const std::string action = line.words.empty() ? "(missing)" : line.words.front();
  const std::vector<std::pair<std::string, int (*)(const CommandLine&, std::ostream&)>> known{
      {"make", make}, {"check", check}, {"update", update}, {"list", list}};
  for (const auto& [name, run] : known) {
    if (name != action) continue;
    refuse_options_of_others(line, action);
    return run(line, out);
  }
  throw BadInput("golden", action, actions);
}

}  // namespace nipref::verify
