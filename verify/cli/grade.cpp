#include <fstream>

#include <nipref/data/closest_name.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/grade/measured_points.hpp>
#include <nipref/verify/grade/plugin.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr double usual_slowdown = 0.1;

/// A kernel to be graded, and the quantity that it computes.
struct Chosen {
  std::string kernel;
  const Quantity* quantity;
};

/// The quantity of a bare function: that of the option, or of the word after the file.
const Quantity& quantity_of_symbol(const CommandLine& line) {
  const auto option = line.option("quantity");
  if (option && line.words.size() > 1)
    throw BadInput("argument", line.words[1], "unexpected: the quantity is given already");
  if (line.words.size() > 2)
    throw BadInput("argument", line.words[2], "unexpected: a function computes one quantity");
  if (option) return find_quantity(*option);
  return find_quantity(line.words.size() > 1 ? line.words[1] : "(missing)");
}

Plugin plugin_of(const CommandLine& line, const std::string& file) {
  Plugin plugin{file, {}, line.number("time-limit").value()};
  if (const auto symbol = line.option("symbol"))
    plugin.function = {*symbol, quantity_of_symbol(line).arguments.size(), line.has("thread-safe")};
  return plugin;
}

Chosen chosen(const KernelInfo& kernel) {
  const Quantity& quantity = find_quantity(kernel.quantity);
  if (kernel.arity != quantity.arguments.size())
    refuse("kernel", kernel.name, "must have {} arguments, as {} has, instead of {}",
           quantity.arguments.size(), quantity.name, kernel.arity);
  return {kernel.name, &quantity};
}

/// The kernels selected by the words after the file, by their own names or by those of their quantities, or all.
std::vector<Chosen> chosen_kernels(const CommandLine& line, const Plugin& plugin) {
  const std::vector<KernelInfo> kernels = kernels_of(plugin);
  if (plugin.function) return {{plugin.function->symbol, &quantity_of_symbol(line)}};
  const auto words = std::span(line.words).subspan(1);
  const auto has = [](const auto& names, const auto& name) {
    return std::ranges::find(names, name) != names.end();
  };
  std::vector<std::string_view> names;
  std::vector<Chosen> all;
  for (const KernelInfo& kernel : kernels) {
    names.insert(names.end(), {kernel.name, kernel.quantity});
    if (words.empty() || has(words, kernel.name) || has(words, kernel.quantity))
      all.push_back(chosen(kernel));
  }
  for (const std::string& word : words)
    if (!has(names, word))
      refuse("kernel", word, "{}must be one of {}", data::did_you_mean(word, names),
             fmt::join(each_once(names), ", "));
  return all;
}

std::string where_text(const CommandLine& line) {
  if (line.assignments.empty()) return "its domain";
  const auto written = [](const auto& pair) { return pair.first + "=" + pair.second; };
  return fmt::format("{}", fmt::join(mapped(line.assignments, written), " "));
}

/// Measures the kernel's speed beside fast at full accuracy, both in batches if possible, and, if asked for, beside an
/// older kernel, each in its own process.
void add_speed(const CommandLine& line, PluginKernel& kernel, const Ranges& ranges, Graded& graded) {
  const Quantity& quantity = *graded.grade.found.quantity;
  const std::vector<Point> points = timing_points(quantity, ranges);
  const auto speed_beside = [&](const BatchMethod& other) {
    return in_turns(method_of(kernel, points), other, points.size());
  };
  const bool batch = !kernel.info().quantity.empty() && quantity.by_fast_batch;
  if (!points.empty())
    graded.to_fast =
        speed_beside(method_of(batch ? quantity.by_fast_batch : quantity.by_fast_loop, {}, points));
  const auto older_file = line.option("against");
  if (!older_file) return;
  graded.to_older = {*older_file, max_slowdown_option(line).value_or(usual_slowdown), {}};
  const auto older = open_kernel(plugin_of(line, *older_file), kernel.info().name);
  if (older->info().arity != kernel.info().arity)
    throw BadInput("against", *older_file, "must have a kernel of that name with as many arguments");
  if (!points.empty()) graded.to_older->speed = speed_beside(method_of(*older, points));
}

Graded graded_kernel(const CommandLine& line, const Plugin& plugin, const Chosen& chosen,
                     Progress& progress) {
  AuditOptions options = sampling_options(line, *chosen.quantity);
  options.progress = [&](double part) { progress.at(part); };
  const std::string promised = take_promise(line, options);
  const auto kernel = open_kernel(plugin, chosen.kernel);
  const auto [found, seconds] = timed([&] { return audit(*chosen.quantity, kernel->evaluator(), options); });
  double own = 0;
  kernel->evaluate({&found.worst, 1}, {&own, 1});
  progress.at(1, "timing");
  // The library's version and folder are not part of the kernel's name.
  std::string file = plugin.file.filename().string();
  if (const std::size_t version = file.find(".so."); version != std::string::npos) file.resize(version + 3);
  Graded graded{.grade = grade_of(chosen.kernel + " of " + file, where_text(line), found),
                .seconds = seconds,
                .promised = promised,
                .own = own,
                .seed = options.seed,
                .is_kernel = true};
  add_speed(line, *kernel, options.ranges, graded);
  graded.faults = kernel->faults();
  return graded;
}

void refuse_what_is_wrong(const CommandLine& line) {
  refuse_option(line, "column", "has no effect on kernels: must be left out");
  static_cast<void>(max_slowdown_option(line));
  if (const auto older = line.option("against")) static_cast<void>(kernels_of(plugin_of(line, *older)));
}

/// Whether the first word is a shared object.
bool names_plugin(const CommandLine& line) {
  const std::string& file = line.words.front();
  if (file.ends_with(".so") || line.option("symbol")) return true;
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;  // a pipe can be read only once
  std::array<char, 4> first{};
  std::ifstream(file, std::ios::binary).read(first.data(), first.size());
  return first == std::array{'\x7f', 'E', 'L', 'F'};
}

/// Grades kernels of a shared object; fewer if the process is interrupted. Reports progress, unless quiet.
std::vector<Graded> graded_kernels(const CommandLine& line) {
  refuse_what_is_wrong(line);
  const Plugin plugin = plugin_of(line, line.words.front());
  const std::vector<Chosen> kernels = chosen_kernels(line, plugin);
  Progress progress(line.has("quiet"));
  std::vector<Graded> all;
  progress.each("grade", kernels, &Chosen::kernel,
                [&](const Chosen& chosen) { all.push_back(graded_kernel(line, plugin, chosen, progress)); });
  return all;
}

void refuse_what_needs_kernels(const CommandLine& line) {
  for (const char* const name :
       {"points", "seed", "quantity", "time-limit", "against", "max-slowdown", "thread-safe"})
    refuse_option(line, name, "has an effect on shared objects only: must be left out");
  if (!line.assignments.empty())
    throw BadInput(line.assignments.front().first, line.assignments.front().second,
                   "unexpected: ranges are for shared objects, a CSV has its points");
}

std::vector<std::string> remarks_on(const MeasuredPoints& measured) {
  std::vector<std::string> remarks;
  if (measured.contradicting_rows > 0)
    remarks.push_back(
        fmt::format("{} rows have a decimal argument that is another number than the hexadecimal one, "
                    "which was taken: digits were lost",
                    measured.contradicting_rows));
  if (measured.short_rows > 0)
    remarks.push_back(
        fmt::format("{} rows have a decimal argument of 15 digits or less: it may have lost digits, and "
                    "the value is compared at what is left",
                    measured.short_rows));
  return remarks;
}

/// Grades the values in a CSV. The words are its name and, if the file does not state it, its quantity. For contacts
/// there is a grade for each column. Reports progress, unless quiet.
std::vector<Graded> graded_file(const CommandLine& line) {
  refuse_what_needs_kernels(line);
  if (line.words.size() > 2)
    throw BadInput("argument", line.words[2], "unexpected: grade takes a file and a quantity");
  const auto quantity = line.words.size() > 1 ? std::optional(line.words[1]) : std::nullopt;
  AuditOptions options;
  const std::string promised = take_promise(line, options);
  const std::string& file = line.words.front();
  const std::string what = file == "-" ? "standard input" : std::filesystem::path(file).filename().string();
  const auto columns = read_measured_points(file, quantity, line.option("column"));
  Progress progress(line.has("quiet"));
  options.progress = [&](double part) { progress.at(part); };
  std::vector<Graded> all;
  const auto name = [](const MeasuredPoints& column) { return column.quantity->name; };
  progress.each("grade", columns, name, [&](const MeasuredPoints& column) {
    const auto [found, seconds] =
        timed([&] { return audit_values(*column.quantity, column.points, column.values, options); });
    const auto worst = std::ranges::find(column.points, found.worst) - column.points.begin();
    all.push_back({.grade = grade_of(what, "its points", found),
                   .seconds = seconds,
                   .promised = promised,
                   .own = column.values[static_cast<std::size_t>(worst)],
                   .remarks = remarks_on(column)});
  });
  return all;
}

BaselineKey key_of(const Graded& graded) {
  const Grade& grade = graded.grade;
  return {grade.what,         grade.found.quantity->name,
          grade.where,        graded.seed,
          grade.found.points, sampler_version,
          compiler(),         std::string(fast::instruction_set())};
}

/// Reads the baseline, before anything is graded. If it is to be written, there may be no file yet.
std::optional<Baseline> baseline_of(const CommandLine& line) {
  const auto path = line.option("baseline");
  if (!path) return std::nullopt;
  std::error_code unknown;
  if (!std::filesystem::exists(*path, unknown) && !unknown) {
    if (line.has("update-baseline")) return Baseline{};
    throw BadInput("baseline", *path, "must be a file that exists: --update-baseline makes one");
  }
  return Baseline::read(*path);
}

/// Updates the baseline, if asked for, and compares with it. False if an update is not allowed.
bool settle_baseline(const CommandLine& line, Baseline& baseline, std::vector<Graded>& all) {
  std::size_t updated = 0, refused = 0;
  for (Graded& graded : all) {
    const BaselineKey key = key_of(graded);
    const double error = graded.grade.found.max_error_ulp;
    if (line.has("update-baseline")) {
      const bool is_allowed = update(baseline, key, error, line.option("accept"));
      ++(is_allowed ? updated : refused);
      if (!is_allowed)
        graded.remarks.emplace_back("the baseline was left as it is: raising it needs --accept \"reason\"");
    }
    graded.against_baseline = compare_with(baseline, key, error);
  }
  if (updated > 0) replace_output_file(*line.option("baseline"), baseline.text());
  return refused == 0;
}

std::string text_of_all(const std::vector<Graded>& all, bool for_ctest) {
  std::string text;
  for (const Graded& graded : all)
    text += folded(graded_text(graded)) + (for_ctest ? text_of("ctest.txt", graded_json(graded)) : "");
  return text + note_of_interrupt();
}

}  // namespace

VerbAnswer grade_verb(const CommandLine& line) {
  std::optional<Baseline> baseline = baseline_of(line);
  std::vector<Graded> all = names_plugin(line) ? graded_kernels(line) : graded_file(line);
  const bool settled = !baseline || settle_baseline(line, *baseline, all);
  if (const auto path = line.option("keep-worst"))
    for (const Graded& graded : all) keep_worst(*path, graded);
  if (const auto junit = line.option("junit")) write_output_file(*junit, junit_text(all));
  return {"grade",
          {{"rows", json_list(all, graded_json)}},
          settled && all_kept(all),
          [=, for_ctest = line.has("ctest")] { return text_of_all(all, for_ctest); }};
}

}  // namespace nipref::verify
