#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/make.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;
using data::BadInput;

/// Quantities after the action; all if there are none.
std::vector<const Quantity*> quantities_of(const CommandLine& line) {
  return select_quantities({line.words.begin() + 1, line.words.end()});
}

/// Where new values go: one file, or a folder with a file for each quantity and the checksums of all.
class Destination {
 public:
  /// BadInput if the command line says nothing of it.
  Destination(const CommandLine& line, std::size_t quantities) : in_place_(line.has("in-place")) {
    const auto output = line.option("output");
    if (in_place_) {
      path_ = own_;
      return;
    }
    std::error_code none;
    if (!output || output->empty())
      throw BadInput(
          "output", output ? "" : "(missing)",
          fmt::format("must be a file or a folder, or --in-place given, which writes to {}", own_.string()));
    path_ = fs::absolute(*output);
    is_file_ = quantities == 1 && path_.has_filename() && !fs::is_directory(path_, none);
    if (!is_file_ && fs::exists(path_, none) && !fs::is_directory(path_, none))
      throw BadInput("output", *output, "must be a folder: there are several quantities");
  }

  [[nodiscard]] fs::path file_of(const Quantity& quantity) const {
    return is_file_ ? path_ : path_ / (quantity.name + ".csv");
  }

  /// BadInput if the file is there and is none of the quantity's or has more rows, or is nipref's own and is not to be
  /// written.
  void check(const Quantity& quantity, std::size_t rows) const {
    const fs::path file = file_of(quantity);
    std::error_code none;
    if (!in_place_ && fs::weakly_canonical(file, none).parent_path() == fs::weakly_canonical(own_, none))
      throw BadInput("output", file.string(), "must be elsewhere: --in-place writes to nipref's own files");
    if (!fs::is_regular_file(file, none)) return;
    const GoldenFile there = read_golden(file);
    if (there.entry("quantity") != quantity.name)
      throw BadInput("golden file", file.string(),
                     fmt::format("must be one of {}, or none yet: it has values of {}", quantity.name,
                                 there.entry("quantity")));
    if (there.rows.size() > rows)
      throw BadInput("golden file", file.string(),
                     fmt::format("must not lose rows: it has {} and would get {}", there.rows.size(), rows));
  }

  /// A single file's checksum is kept only where there is one.
  void write(const Quantity& quantity, const GoldenFile& values) const {
    const fs::path file = file_of(quantity), folder = file.parent_path();
    const std::string text = golden_text(quantity, values);
    check(quantity, values.rows.size());
    std::error_code error;
    fs::create_directories(folder, error);  // writing says what is wrong
    Checksums sums = Checksums::of(folder);
    replace_output_file(file.string(), text);
    if (is_file_ && !sums.by_name().contains(file.filename().string())) return;
    sums.set(file.filename().string(), text);
    replace_output_file((folder / checksums_name).string(), sums.text());
  }

 private:
  fs::path own_ = data::golden_directory();
  bool in_place_;
  fs::path path_;
  bool is_file_ = false;
};

int answer(const CommandLine& line, std::ostream& out, const Json& members, bool kept) {
  return write_answer(line, out, "golden", kept, members, "golden_" + line.words.front() + ".txt");
}

/// What is not asked for is the quantity's own.
GoldenOptions options_for(const Quantity& quantity, const CommandLine& line) {
  GoldenOptions options = golden_options(quantity);
  if (line.option("points")) options.points = line.count("points");
  options.digits = digits_option(line).value_or(options.digits);
  options.seed = line.option_or_usual("seed");
  return options;
}

Json refused_json(const Quantity& quantity, const std::vector<RefusedRow>& refused) {
  return json_list(refused, [&](const RefusedRow& row) -> Json {
    return {{"arguments", point_json(quantity, row.arguments)}, {"reason", row.reason}};
  });
}

int make(const CommandLine& line, std::ostream& out) {
  const auto quantities = quantities_of(line);
  const Destination destination(line, quantities.size());
  for (const Quantity* quantity : quantities)
    destination.check(*quantity, options_for(*quantity, line).points);
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  std::vector<Json> files;
  std::size_t rows = 0;
  bool kept = true;
  progress.each("golden make", quantities, &Quantity::name, [&](const Quantity* quantity) {
    GoldenOptions options = options_for(*quantity, line);
    options.progress = [&](double part) { progress.at(part); };
    MadeGolden made = make_golden(*quantity, options, provenance());
    kept = kept && made.refused.empty();
    destination.write(*quantity, made.file);
    rows += made.file.rows.size();
    files.push_back({{"quantity", quantity->name},
                     {"file", destination.file_of(*quantity).string()},
                     {"rows", made.file.rows.size()},
                     {"refused", refused_json(*quantity, made.refused)}});
  });
  return answer(line, out, {{"action", "make"}, {"files", files}, {"_rows", rows}}, kept);
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

/// `folder`: failures that belong to no single file.
Json checked_json(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files) {
  std::size_t rows = 0;
  std::vector<GoldenFailure> all = folder;
  for (const CheckedGolden& file : files) {
    rows += file.rows;
    all.insert(all.end(), file.failures.begin(), file.failures.end());
  }
  const auto count = [&](GoldenFault fault) { return std::ranges::count(all, fault, &GoldenFailure::fault); };
  return {{"action", "check"},
          {"failures", json_list(folder, failure_json)},
          {"files", json_list(files, checked_file_json)},
          {"_rows", rows},
          {"_wrong", count(GoldenFault::wrong)},
          {"_too_wide", count(GoldenFault::too_wide)},
          {"_text_changed", count(GoldenFault::text_changed)},
          {"_missing", count(GoldenFault::missing)}};
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
  options.every = line.count("every");
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  options.progress = [&](double part) { progress.at(part); };
  std::vector<CheckedGolden> files;
  const auto name = [](const fs::path& path) { return path.stem().string(); };
  progress.each("golden check", paths, name,
                [&](const fs::path& path) { files.push_back(check_golden(path, options)); });
  const bool kept = folder.empty() && std::ranges::all_of(files, &CheckedGolden::kept);
  return answer(line, out, checked_json(folder, files), kept);
}

struct UpdatedFile {
  const Quantity& quantity;
  std::string path;
  UpdatedGolden updated;
};

Json value_json(const GoldenRow& row) {
  return {{"value", row.value}, {"error", row.bound}, {"proven", row.proven}};
}

Json updated_json(const UpdatedFile& file) {
  const auto changed = [&](const ChangedRow& row) -> Json {
    return {{"row", row.row},
            {"arguments", point_json(file.quantity, row.before.arguments)},
            {"why", row.why},
            {"before", value_json(row.before)},
            {"after", value_json(row.after)}};
  };
  return {{"quantity", file.quantity.name},
          {"file", file.path},
          {"rows", file.updated.file.rows.size()},
          {"changed", json_list(file.updated.changed, changed)},
          {"refused", refused_json(file.quantity, file.updated.refused)},
          {"_changed", file.updated.changed.size()}};
}

int update(const CommandLine& line, std::ostream& out) {
  const Provenance made_with = provenance();
  if (!made_with.clean && !line.has("dirty")) {
    throw BadInput(
        "dirty", "(not given)",
        "must be given: this program was built from a tree that differs from its commit, or is of none");
  }
  const auto quantities = quantities_of(line);
  const Destination destination(line, quantities.size());
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  std::vector<UpdatedFile> files;
  progress.each("golden update", quantities, &Quantity::name, [&](const Quantity* quantity) {
    const fs::path path = golden_path(*quantity);
    if (!fs::exists(path) && line.words.size() == 1) return;
    const GoldenFile before = read_golden(path);
    destination.check(*quantity, before.rows.size());
    files.push_back({*quantity, destination.file_of(*quantity).string(),
                     update_golden(*quantity, before, line.has("all"), made_with,
                                   [&](double part) { progress.at(part); })});
  });
  if (interrupted()) files.clear();
  // The answer is printed before the files are written.
  const bool kept =
      std::ranges::all_of(files, [](const UpdatedFile& file) { return file.updated.refused.empty(); });
  const int status =
      answer(line, out, {{"action", "update"}, {"files", json_list(files, updated_json)}}, kept);
  for (const UpdatedFile& file : files) {
    if (!file.updated.changed.empty()) destination.write(file.quantity, file.updated.file);
  }
  return status;
}

int list(const CommandLine& line, std::ostream& out) {
  std::vector<Json> files, missing;
  std::size_t rows = 0;
  for (const Quantity* quantity : quantities_of(line)) {
    const fs::path path = golden_path(*quantity);
    if (!fs::exists(path)) {
      missing.emplace_back(quantity->name);
      continue;
    }
    const GoldenFile file = read_golden(path);
    Json header = Json::object();
    for (const auto& [key, text] : file.header) header.set(key, text);
    rows += file.rows.size();
    files.push_back({{"quantity", quantity->name},
                     {"file", path.string()},
                     {"rows", file.rows.size()},
                     {"header", header}});
  }
  return answer(line, out, {{"action", "list"}, {"files", files}, {"missing", missing}, {"_rows", rows}},
                true);
}

}  // namespace

int golden_verb(const CommandLine& line, std::ostream& out) {
  const std::string action = line.words.empty() ? "(missing)" : line.words.front();
  constexpr std::array<int (*)(const CommandLine&, std::ostream&), golden_actions.size()> run{make, check,
                                                                                              update, list};
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (golden_actions[i] == action) return run[i](line, out);
  }
  throw BadInput("golden", action, "must be make, check, update or list");
}

}  // namespace nipref::verify
