#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/golden/make.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;
using data::BadInput;

/// The destination of new values: one file, or a folder with a file for each name and the checksums of all files.
class Destination {
 public:
  /// BadInput if the command line names no destination.
  Destination(const CommandLine& line, std::size_t files, std::string extension = ".csv")
      : in_place_(line.has("in-place")), extension_(std::move(extension)) {
    const auto output = line.option("output");
    if (in_place_) {
      path_ = own_;
      return;
    }
    std::error_code none;
    if (!output || output->empty())
      refuse("output", output ? "" : "(missing)",
             "must be a file or a folder; make and update also take --in-place, which writes to {}",
             own_.string());
    path_ = fs::absolute(*output);
    is_file_ = files == 1 && path_.has_filename() && !fs::is_directory(path_, none);
    if (!is_file_ && fs::exists(path_, none) && !fs::is_directory(path_, none))
      throw BadInput("output", *output, "must be a folder: there are several quantities");
  }

  [[nodiscard]] fs::path file_of(const std::string& name) const {
    return is_file_ ? path_ : path_ / (name + extension_);
  }

  /// Throws BadInput if the file exists and is about another quantity or has more rows, or if it is nipref's own and
  /// --in-place is not given.
  void check(const std::string& name, std::size_t rows) const {
    const fs::path file = file_of(name);
    std::error_code none;
    if (!in_place_ && fs::weakly_canonical(file, none).parent_path() == fs::weakly_canonical(own_, none))
      throw BadInput("output", file.string(), "must be elsewhere: --in-place writes to nipref's own files");
    if (!fs::is_regular_file(file, none)) return;
    const data::CsvFile there = data::read_csv(file);
    const std::string of = header_of(there).entry("quantity");
    if (of != name)
      refuse("golden file", file.string(), "must be one of {}, or none yet: it has values of {}", name, of);
    if (there.records.size() - 1 > rows)
      refuse("golden file", file.string(), "must not lose rows: it has {} and would get {}",
             there.records.size() - 1, rows);
  }

  void replace(const std::string& name, const std::string& text) const {
    std::error_code error;
    fs::create_directories(file_of(name).parent_path(), error);  // writing says what is wrong
    replace_output_file(file_of(name).string(), text);
  }

  /// Writes a golden file and its checksum. For a single file the checksum is written only if there was one before.
  void write(const std::string& name, const GoldenFile& golden) const {
    const fs::path file = file_of(name), folder = file.parent_path();
    const std::string text = golden_text(golden);
    check(name, golden.rows.size());
    Checksums sums = checksums_of(folder);
    replace(name, text);
    if (is_file_ && !sums.contains(file.filename().string())) return;
    sums[file.filename().string()] = sha256(text);
    replace_output_file((folder / checksums_name).string(), checksums_text(sums));
  }

 private:
  fs::path own_ = data::golden_directory();
  bool in_place_;
  std::string extension_;
  fs::path path_;
  bool is_file_ = false;
};

/// The options of the command line, or the quantity's own where it has none.
GoldenOptions options_for(const Quantity& quantity, const CommandLine& line) {
  GoldenOptions options = golden_options(quantity);
  if (line.option("points")) options.points = line.count("points");
  options.digits = digits_option(line).value_or(options.digits);
  options.seed = line.option_or_usual("seed");
  return options;
}

Json made_json(const std::string& name, const fs::path& file, const MadeGolden& made) {
  const auto refused_json = [](const RefusedRow& row) -> Json {
    return {{"arguments", json_object(row.arguments)}, {"reason", row.reason}};
  };
  return {{"quantity", name},
          {"file", file.string()},
          {"rows", made.file.rows.size()},
          {"refused", json_list(made.refused, refused_json)}};
}

MadeGolden made_of(const std::string& name, const CommandLine& line, const OnProgress& progress) {
  if (is_contact_kind(name))
    return make_contacts(name, digits_option(line).value_or(contact_digits), provenance(), progress);
  const Quantity& quantity = find_quantity(name);
  GoldenOptions options = options_for(quantity, line);
  options.progress = progress;
  return make_golden(quantity, options, provenance());
}

/// The names after the action; without any, those of all kinds of contacts and of all quantities that are of no family.
std::vector<std::string> names_of(const CommandLine& line) {
  std::vector<std::string> names(line.words.begin() + 1, line.words.end());
  for (const std::string& name : names)
    if (!is_contact_kind(name)) static_cast<void>(find_quantity(name));
  if (!names.empty()) return names;
  for (const Quantity& quantity : catalogue())
    if (quantity.family.empty()) names.push_back(quantity.name);
  std::ranges::copy(contact_kinds(), std::back_inserter(names));
  return names;
}

VerbAnswer make(const CommandLine& line) {
  const auto names = names_of(line);
  const Destination destination(line, names.size());
  for (const std::string& name : names)
    destination.check(name, is_contact_kind(name) ? swept_by(contact_scene(name)).size()
                                                  : options_for(find_quantity(name), line).points);
  Progress progress(line.has("quiet"));
  std::vector<Json> files;
  std::size_t rows = 0;
  bool kept = true;
  progress.each("golden make", names, std::identity(), [&](const std::string& name) {
    const MadeGolden made = made_of(name, line, [&](double part) { progress.at(part); });
    kept = kept && made.refused.empty();
    destination.write(name, made.file);
    rows += made.file.rows.size();
    files.push_back(made_json(name, destination.file_of(name), made));
  });
  return {"golden", {{"action", "make"}, {"files", files}, {"_rows", rows}}, kept};
}

/// The file that a word means: a quantity, a kind of contacts, or a file.
fs::path file_of(const std::string& word) {
  if (is_contact_kind(word)) return golden_path(word);
  if (const Quantity* const quantity = known_quantity(word)) {
    if (quantity->family.empty()) return golden_path(word);
    refuse("quantity", word, "must be one of {}, which hold whole contacts",
           fmt::join(contact_kinds(), ", "));
  }
  std::error_code none;
  const bool is_file =
      fs::exists(word, none) || word.find('/') != std::string::npos || word.ends_with(".csv");
  if (!is_file) refuse_quantity(word);
  data::check_input_file(word, "file");
  return word;
}

/// `folder` has the failures that belong to no single file.
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

VerbAnswer check(const CommandLine& line) {
  std::vector<fs::path> paths;
  std::vector<GoldenFailure> folder;
  for (std::size_t i = 1; i < line.words.size(); ++i) paths.push_back(file_of(line.words[i]));
  if (paths.empty()) {
    folder = check_folder(data::golden_directory());
    for (const std::string& name : names_of(line)) {
      const fs::path path = golden_path(name);
      if (fs::exists(path)) {
        paths.push_back(path);
      } else {
        folder.push_back({GoldenFault::missing, {}, name + " has no golden values"});
      }
    }
  }
  CheckOptions options;
  options.all = line.has("all");
  options.every = line.count("every");
  Progress progress(line.has("quiet"));
  options.progress = [&](double part) { progress.at(part); };
  std::vector<CheckedGolden> files;
  const auto name = [](const fs::path& path) { return path.stem().string(); };
  progress.each("golden check", paths, name,
                [&](const fs::path& path) { files.push_back(check_golden(path, options)); });
  const bool kept = folder.empty() && std::ranges::all_of(files, &CheckedGolden::kept);
  return {"golden", checked_json(folder, files), kept};
}

Json value_json(const GoldenRow& row) {
  const auto& [value, bound] = row.numbers.front();
  return {{"value", value}, {"error", bound}, {"proven", row.proven}};
}

Json changed_json(const Quantity& quantity, const ChangedRow& changed) {
  return {{"row", changed.row},
          {"arguments", point_json(quantity, changed.before.arguments)},
          {"why", changed.why},
          {"before", value_json(changed.before)},
          {"after", value_json(changed.after)}};
}

VerbAnswer update(const CommandLine& line) {
  const Provenance made_with = provenance();
  if (!made_with.clean && !line.has("dirty")) {
    throw BadInput(
        "dirty", "(not given)",
        "must be given: this program was built from a tree that differs from its commit, or is of none");
  }
  const auto quantities = selection(std::span(line.words).subspan(1)).quantities;
  const Destination destination(line, quantities.size());
  Progress progress(line.has("quiet"));
  std::vector<Json> files;
  std::map<std::string, GoldenFile> changed;
  bool kept = true;
  progress.each("golden update", quantities, &Quantity::name, [&](const Quantity* quantity) {
    const fs::path path = golden_path(quantity->name);
    if (!fs::exists(path) && line.words.size() == 1) return;
    const GoldenFile before = read_golden(path);
    destination.check(quantity->name, before.rows.size());
    const UpdatedGolden updated =
        update_golden(*quantity, before, line.has("all"), made_with, [&](double part) { progress.at(part); });
    kept = kept && updated.refused.empty();
    Json file = made_json(quantity->name, destination.file_of(quantity->name), updated);
    file.set("changed",
             json_list(updated.changed, [&](const ChangedRow& row) { return changed_json(*quantity, row); }));
    file.set("_changed", updated.changed.size());
    files.push_back(file);
    if (!updated.changed.empty()) changed[quantity->name] = updated.file;
  });
  if (interrupted()) return {"golden", {{"action", "update"}, {"files", std::vector<Json>()}}};
  for (const auto& [name, file] : changed) destination.write(name, file);
  return {"golden", {{"action", "update"}, {"files", files}}, kept};
}

VerbAnswer list(const CommandLine& line) {
  std::vector<Json> files, missing;
  std::size_t rows = 0;
  for (const std::string& name : names_of(line)) {
    const fs::path path = golden_path(name);
    if (!fs::exists(path)) {
      missing.emplace_back(name);
      continue;
    }
    const data::CsvFile csv = data::read_csv(path);
    rows += csv.records.size() - 1;
    files.push_back({{"quantity", name},
                     {"file", path.string()},
                     {"rows", csv.records.size() - 1},
                     {"header", json_object(header_of(csv).header)}});
  }
  return {"golden", {{"action", "list"}, {"files", files}, {"missing", missing}, {"_rows", rows}}};
}

VerbAnswer export_files(const CommandLine& line) {
  const auto names = names_of(line);
  const std::string format = line.option_or_usual("format");
  const Destination destination(line, names.size(), format == "cpp" ? ".hpp" : "." + format);
  std::vector<Json> files;
  for (const std::string& name : names) {
    destination.replace(name, exported_golden(golden_path(name), format));
    files.push_back({{"quantity", name}, {"file", destination.file_of(name).string()}});
  }
  return {"golden", {{"action", "export"}, {"version", golden_version()}, {"files", files}}};
}

}  // namespace

VerbAnswer golden_verb(const CommandLine& line) {
  const std::string action = line.words.empty() ? "(missing)" : line.words.front();
  constexpr std::array<Verb*, golden_actions.size()> run{make, check, update, list, export_files};
  for (std::size_t i = 0; i < run.size(); ++i)
    if (golden_actions[i] == action) {
      VerbAnswer answer = run[i](line);
      answer.text = "golden_" + action + ".txt";
      return answer;
    }
  throw BadInput("golden", action, "must be make, check, update, list or export");
}

}  // namespace nipref::verify
