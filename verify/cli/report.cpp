#include <nipref/data/input_file.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/internal/cache.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;

/// The numbers of golden values that are checked for a quantity; fewer if they take long.
constexpr std::size_t golden_sample = 25, golden_sample_of_slow = 5;
constexpr std::size_t points_of_quick_quantity = 10'000;

GoldenSample sample_golden(const Quantity& quantity) {
  const fs::path path = golden_path(quantity.name);
  if (!fs::exists(path))
    return {{},
            {.path = path,
             .quantity = quantity.name,
             .failures = {{GoldenFault::missing, {}, "there are none"}}}};
  GoldenFile file = read_golden(path);
  const std::size_t rows =
      quantity.audit_points >= points_of_quick_quantity ? golden_sample : golden_sample_of_slow;
  CheckOptions options;
  options.every = std::max<std::size_t>(1, (file.rows.size() + rows - 1) / rows);
  CheckedGolden checked = check_golden(path, options);
  return {std::move(file), std::move(checked)};
}

/// A part of a report: what it is about, the first words of its lines in the text, and its work.
struct ReportPart {
  std::string about;
  std::vector<std::string> heads;
  std::function<void()> work;
};

/// The parts of a report. Parts that take seconds come first.
std::vector<ReportPart> report_parts(Report& report, AuditRun& audits, bool draws, Progress& progress) {
  std::vector<ReportPart> parts{
      {"errata", {"errata"}, [&] { report.errata = settle_all(formula_errata()); }},
      {"limits", {"limits"}, [&] { report.limits = approach_all(limits()); }},
      {"claims", {"claims"}, [&] { report.claims = check_all(claims()); }},
      {"printed tables",
       {"tables", "sources"},
       [&] {
         report.tables = replay_and_correct(replayable_tables(), progress);
         report.tables_fall_short = fall_short(report.tables);
       }},
      {"speed", {"speed"}, [&] { report.speed = bench_all(bench_everything(), progress); }},
      {"accuracy and random contacts",
       {"audit", "contacts", "witness"},
       [&] {
         audits.do_blocks(progress);
         static_cast<Audited&>(report) = audits.found();
         report.witness = outside_witness();
       }},
      {"golden values", {"golden"}, [&] {
         progress.each("golden", catalogue(), &Quantity::name, [&](const Quantity& quantity) {
           // The quantities of a family are whole nips, which have golden contacts instead.
           if (quantity.family.empty()) report.golden.push_back(sample_golden(quantity));
         });
       }}};
  if (draws)
    parts.push_back({"figures", {}, [&] {
                       progress.each("figures", figures(), &FigurePlan::id, [&](const FigurePlan& plan) {
                         report.figures.push_back(compute(plan));
                       });
                     }});
  return parts;
}

/// Makes the folder of the report. A folder that cannot be made is refused before anything is computed.
std::optional<fs::path> output_folder(const CommandLine& line) {
  const auto name = line.option("output");
  if (!name) return std::nullopt;
  std::error_code error;
  fs::create_directories(*name, error);
  if (!fs::is_directory(*name, error))
    throw data::BadInput("output", *name, "must be a folder, or one that can be made");
  return *name;
}

/// Reads the older report, before anything is computed. BadInput if the file is not a report.
std::optional<std::string> older_report(const CommandLine& line) {
  const auto path = line.option("against");
  if (!path) return std::nullopt;
  std::string text = data::text_of_input_file(*path, "against");
  if (!is_report(text))
    throw data::BadInput("against", *path, "must be the report.json that an older report has written");
  return text;
}

/// A drawer that draws each script once, because each page of a growing report shows most plots again.
Drawer remembering(Drawer draw) {
  auto drawn = std::make_shared<Cache<std::string, std::optional<std::string>>>();
  return [=](const std::string& script) { return *drawn->at(script, [&] { return draw(script); }); };
}

/// ref/README.md and the pages of its subjects as HTML; empty where this was built without pandoc.
constexpr char mathematics[] =
#include <nipref_mathematics.inc>
    ;
constexpr bool has_mathematics = sizeof mathematics > 1;

/// Writes the page and its data into the folder. Returns the page's path and size in words.
std::string write_page(const fs::path& folder, const std::string& answer, const Drawer& draw) {
  const std::string page = report_page(answer, draw, has_mathematics);
  const fs::path file = folder / "index.html";
  write_output_file((folder / "report.json").string(), answer);
  write_output_file(file.string(), page);
  if constexpr (has_mathematics) write_output_file((folder / "mathematics.html").string(), mathematics);
  return fmt::format("{} ({:.1f} MB, opens from the file)", file.string(),
                     1e-6 * static_cast<double>(page.size()));
}

/// Does one part after the other, until the process is interrupted. `finished` is called after each part but the last.
void do_parts(Report& report, const std::vector<ReportPart>& parts,
              const std::function<void(const ReportPart&)>& finished) {
  for (std::size_t i = 0; i < parts.size() && !interrupted(); ++i) {
    parts[i].work();
    report.to_come.clear();
    for (const ReportPart& later : std::span(parts).subspan(i + 1)) report.to_come.push_back(later.about);
    if (!report.to_come.empty()) finished(parts[i]);
  }
}

}  // namespace

VerbAnswer report_verb(const CommandLine& line) {
  const auto older = older_report(line);
  const auto folder = output_folder(line);
  AuditRun audits(line, true);
  Progress progress(line.has("quiet"));
  Report report;
  report.command = fmt::format("nipref {}", fmt::join(words_of(line), " "));
  report.seed = line.option_or_usual("seed");
  const Drawer draw = remembering(drawn_by_gnuplot);
  const std::vector<ReportPart> parts = report_parts(report, audits, folder.has_value(), progress);
  progress.tell(fmt::format("nipref report does these parts, one after the other: {}\n",
                            fmt::join(mapped(parts, &ReportPart::about), ", ")));
  do_parts(report, parts, [&](const ReportPart& part) {
    const std::string answer = answer_text("report", report_json(report), line.has("no-times"));
    const std::string page = folder ? write_page(*folder, answer, draw) + ", and grows" : "";
    progress.tell(
        plain(report_lines(report_text(answer_text("report", report_json(report)), page), part.heads)));
  });
  if (older)
    report.comparison =
        compare_reports(*older, answer_text("report", report_json(report), line.has("no-times")));
  const Json found = report_json(report);
  const std::string answer = answer_text("report", found, line.has("no-times"));
  const std::string page =
      folder ? write_page(*folder, answer, draw) : "nipref report -o DIR writes all of it as DIR/index.html";
  const auto text = [found, page, compares = report.comparison.has_value()] {
    return report_text(answer_text("report", found), page) +
           (compares ? "\n" + text_of("comparison.txt", found.at("comparison")) : "") + note_of_interrupt();
  };
  return {"report", found, report.kept(line.has("strict")), text};
}

}  // namespace nipref::verify
