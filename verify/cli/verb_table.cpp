#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/verb_table.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

const OptionText path_option{"path", "which path computes, --digits being for ref and --rtol for fast",
                             "",     "both",
                             {},     {"ref", "fast", "both"}};
const OptionText digits_option{"digits", "decimal digits of ref's result", "", "50",
                               NumberRange{"16", "1000"}};
const OptionText solve_path_option{"path", "which path computes", "", "fast", {}, {"ref", "fast"}};
const OptionText solve_digits_option{
    "digits", "with path=ref only: decimal digits of ref's results, line loads to 300, others to 100 or 30",
    "", "30", NumberRange{"16", "300"}};
const OptionText balance_digits_option{"digits", "with path=ref only: decimal digits of ref's contact", "",
                                       "16", NumberRange{"16", "30"}};
const OptionText report_output_option{
    "output",
    "folder, made if need be, for the report as index.html, one page with all plots, and as report.json",
    "o"};
const OptionText older_report_option{
    "against", "report.json of an older report: what has become better, worse, slower or new since then"};
const OptionText rtol_option{
    "rtol",
    "error that fast may make, as a part of the scale, 4.44e-16 <= rtol < 1 (default: full accuracy)"};
const OptionText form_option{
    "form", "corrected, or printed or table for the seed's own where they differ (default corrected)"};
const OptionText points_text{
    "points", "points for each of the named quantities (default: each its own, 3 to 20000, see list)", "", "",
    NumberRange{"1", "1e12"}};
const OptionText density_option{"density", "factor on each quantity's own number of points", "", "1",
                                NumberRange{"1e-6", "1000", false}};

const OptionText report_density_option{"density", "factor on each quantity's own number of points", "", "0.3",
                                       NumberRange{"1e-6", "1000", false}};
const OptionText report_scenes_option{"scenes", "random scenes to be audited", "", "100",
                                      NumberRange{"1", "1000000"}};
const OptionText scenes_option{"scenes", "random scenes to be audited with contacts", "", "300",
                               NumberRange{"1", "1000000"}};
const OptionText seed_option{"seed", "any text, from which they are drawn", "", "1"};
const OptionText audit_seed_option{"seed", "any text, from which points and scenes are drawn", "", "1"};
const OptionText out_option{
    "out",
    "folder, made if need be, to which each finished block of 4096 points, or 32 scenes, is "
    "written; the same command goes on where it was ended, killed or not"};
const OptionText shard_option{
    "shard",
    "with --out: do this part of the blocks, i/N for the i-th of N processes, or env for what Open MPI, MPICH, Slurm "
    "or an indexed job of Kubernetes says (there JOB_COMPLETIONS is to be set); then merge"};

const OptionText sweep_points_text{"points", "values of each range; combinations up to 1e7", "", "100",
                                   NumberRange{"1", "1e8"}};
const OptionText sample_points_option{"points",
                                      "about so many points (default: the quantity's own, see list)", "", "",
                                      NumberRange{"1", "1e8"}};
const OptionText sample_seed_option{"seed", "any text: another one gives other random points", "", "1"};
const OptionText promise_option{
    "promise",
    "largest error allowed, in units in the last place of the scale (default: what fast promises)"};
const OptionText column_option{
    "column", "which column holds the values (default: value, the quantity's name, or the only one left)"};
const OptionText baseline_option{
    "baseline",
    "TOML file of errors found earlier; more than 1.5 times that and 0.25 ulp fails, as does what is not in it"};
const OptionText accept_option{"accept", "with --update-baseline: why an error may be larger than before"};
const OptionText keep_worst_option{"keep-worst",
                                   "file like a golden one, to which the worst point is appended"};
const OptionText junit_option{"junit", "file for the outcome as JUnit XML"};

const OptionText symbol_option{
    "symbol", "of a shared object: this function, double f(double, ...) of the arguments of --quantity"};
const OptionText quantity_option{"quantity",
                                 "what --symbol computes; it may be the word after the file as well"};
const OptionText time_limit_option{"time-limit",
                                   "seconds that a batch of points may take a kernel (default 10)"};
const OptionText older_object_option{
    "against", "an older shared object: each kernel is timed in turns with the older one of the same name"};
const OptionText max_slowdown_option{
    "max-slowdown",
    "with --against: slower by more than this gives status 1, 10% or 0.1 (default: for kernels 10%, for bench none)"};
const OptionText ctest_flag{"ctest", "print the largest errors as measurements that CTest collects"};
const OptionText thread_safe_flag{"thread-safe",
                                  "the function of --symbol may be called from several threads, and is"};

const OptionText update_baseline_flag{"update-baseline",
                                      "write what was found into the baseline, which is made if need be"};

const OptionText with_option{"with", "a shared object, whose kernels are timed beside fast's; see grade"};
const OptionText older_program_option{"against", "an older nipref: both are timed in turns, in three rounds"};
const OptionText since_option{"since", "with --changed: a revision of git's (default HEAD)"};
const OptionText changed_flag{
    "changed", "what the files that differ from git's last revision have a part in, new files too"};
const OptionText isa_option{
    "isa", "baseline, v3 or v4: fast runs its code for that, as on another machine (default: the best)"};
const OptionText golden_points_option{"points",
                                      "values of each quantity (default 250, 200 where they take seconds)",
                                      "", "", NumberRange{"1", "1e8"}};
const OptionText golden_digits_option{"digits", "decimal digits (default 50, 30 where they take seconds)", "",
                                      "", NumberRange{"16", "1000"}};
const OptionText golden_output_option{
    "output",
    "make, update: the file to be written, or the folder, as it is for several quantities; made if need be",
    "o"};
const OptionText every_option{"every", "check: look at every so many-th row only", "", "1",
                              NumberRange{"1", "1000000"}};
const OptionText all_flag{"all",
                          "check: recompute every row by ref, slow ones too; update: change every row"};
const OptionText in_place_flag{"in-place",
                               "make, update: write the files that golden check reads, nipref's own"};
const OptionText dirty_flag{"dirty", "update: though the program was built from no clean commit"};

const OptionText figure_csv_option{"csv", "file for its numbers, a line for each point"};
const OptionText figure_svg_option{"svg", "file for the figure, drawn by gnuplot"};
const OptionText figure_list_flag{"list", "only list the figures"};

const OptionText full_flag{"full", "all there is to say"};
const OptionText quick_flag{"quick", "the same as --density 0.1"};
const OptionText thorough_flag{"thorough", "the same as --density 10"};
const OptionText quiet_flag{"quiet", "print no progress"};
const OptionText list_flag{"list", "only list the tables"};
const OptionText strict_flag{"strict",
                             "a promised ratio of times that is missed gives status 1 (default: only said)"};
const OptionText json_flag{"json", "output for machines, errors too"};
const OptionText no_times_flag{"no-times", "with --json: leave out what the clock decides"};

const std::array all_verbs{
    VerbText{
        "list",
        list_verb,
        "The quantities that can be computed, or all about those that are named; the keys and results of scenes.",
        "quantity",
        "names of quantities (default: all, in brief), or 'scene' for the keys and results of scenes",
        {},
        {full_flag, json_flag, no_times_flag},
        {"nipref list", "nipref list I1 vs", "nipref list scene"}},
    VerbText{
        "eval",
        eval_verb,
        "One quantity at one argument, by both paths, with their errors, or a sweep over many. 'eval' may be left out.",
        "quantity",
        "its name, and name=value for each of its arguments, as 'nipref list QUANTITY' says; decimal or "
        "hexadecimal numbers, taken exactly; lengths over the half-thickness, angles in degrees. name=a,b,c and "
        "name=lo..hi[:log|:linear|:bits] give all combinations, a row each, as CSV; whole numbers with a blank, "
        "'1, 2', as 1,2 may be a decimal comma. A material is one argument with its numbers, "
        "'material=prony(theta1_rates=[1, 0.1..10])'; what is left out has its default. The accuracy that was asked, 10^-digits of ref or rtol of fast, is "
        "met by an error of no more than that part of the scale; status 1 if it is missed",
        {path_option, digits_option, rtol_option, form_option, sweep_points_text},
        {quiet_flag, json_flag, no_times_flag},
        {"nipref eval I1 alpha=0.73", "nipref eval I6 alpha=1e-6..20:log eta=0.5,2 --points 200",
         "nipref eval vs alpha=0.5 eta=2 young=1.45e5 poisson=0.3 --digits 100"},
        true},
    VerbText{
        "solve",
        solve_verb,
        "What a scene wants of its contact, or of many. A nip whose rollers would meet is refused; strains of its sheet "
        "and slopes of its rollers above 0.1, more than linear theory bears, are warned of.",
        "scene",
        "a TOML file in any consistent units, or the name of an example in data/scenes; key=value pairs stand for "
        "what it has there. key=a,b,c and key=lo..hi[:log|:linear|:bits], here or in the scene's table [sweep], give "
        "all combinations, a row each, as CSV; whole numbers with a blank, '1, 2', as 1,2 may be a decimal comma",
        {solve_path_option, solve_digits_option, sweep_points_text},
        {full_flag, quiet_flag, json_flag, no_times_flag},
        {"nipref solve thick-full-friction",
         "nipref solve scene.toml load.per_length=200 material.poisson=0.3",
         "nipref solve thick-frictionless load.per_length=1..1000:log --points 50"},
        true},
    VerbText{
        "balance",
        balance_verb,
        "The work of a nip's rolling resistance against what its sheet loses, by the losses at all frequencies "
        "of its pressure: status 1 if they differ by more than their errors.",
        "scene",
        "of a rolling sheet, converged: a TOML file, or the name of an example in data/scenes; key=value pairs "
        "stand for what it has there",
        {solve_path_option, balance_digits_option},
        {json_flag, no_times_flag},
        {"nipref balance viscoelastic-operators --path ref", "nipref balance scene.toml accuracy=1e-12"},
        true},
    VerbText{"tables",
             tables_verb,
             "The seeds' tables, replayed cell by cell and corrected.",
             "table",
             "ids or, where it is clear, what is behind their hyphens: thesis-VII, VII (default: all)",
             {},
             {list_flag, full_flag, quiet_flag, json_flag, no_times_flag},
             {"nipref tables --list", "nipref tables VII brock2013-1"}},
    VerbText{"limits",
             limits_verb,
             "How the contacts' solvers approach limits that are known in closed form, and with which power.",
             "limit",
             "names of limits, limit.hertz.load and so on (default: all)",
             {},
             {json_flag, no_times_flag},
             {"nipref limits", "nipref limits limit.hertz.load --json"}},
    VerbText{"claims",
             claims_verb,
             "What the seeds say in words: whether it is so, with the numbers that decide.",
             "claim",
             "ids of claims (default: all)",
             {},
             {json_flag, no_times_flag},
             {"nipref claims", "nipref claims thesis-one-reversal --json"}},
    VerbText{"errata",
             errata_verb,
             "Formulas that the seeds print wrong: printed, right, and against what, each with numbers.",
             "erratum",
             "ids of errata (default: all)",
             {},
             {json_flag, no_times_flag},
             {"nipref errata", "nipref errata thesis-4.8 --json"}},
    VerbText{"figures",
             figures_verb,
             "The seeds' figures from our own solvers: the seed's method, what is printed, and what is true.",
             "figure",
             "the id of one, as --list shows them; without --csv and --svg its numbers are printed as CSV",
             {figure_csv_option, figure_svg_option},
             {figure_list_flag, json_flag, no_times_flag},
             {"nipref figures --list", "nipref figures thesis-17 --svg thesis-17.svg",
              "nipref figures brock2013-3 --csv contours.csv"}},
    VerbText{
        "audit",
        audit_verb,
        "Largest error of fast against ref, by a search for the worst argument.",
        "quantity",
        "names of quantities, and name=lo..hi[:log|:linear|:bits] for arguments that are not to be drawn from their "
        "whole domain, also within a material, 'material=elastic(shear=1..2)'; or contacts for hard cases of whole contacts and random scenes (default: all of it)",
        {points_text, density_option, rtol_option, scenes_option, audit_seed_option, since_option, isa_option,
         out_option, shard_option},
        {changed_flag, quick_flag, thorough_flag, quiet_flag, json_flag, no_times_flag},
        {"nipref audit --changed --quick", "nipref audit I1 I6 --points 1e6",
         "nipref audit I6 alpha=1e-6..20:log eta=2", "nipref audit contacts --scenes 20000 --seed 7",
         "mpirun -n 8 nipref audit I1 --points 1e9 --out run --shard env"},
        true},
    VerbText{"merge",
             merge_verb,
             "What the shards of an audit have found, as one process would have printed it.",
             "run",
             "folders that 'audit --out' has written, of one and the same program, command and inputs",
             {},
             {json_flag, no_times_flag},
             {"nipref merge run", "nipref merge run-of-one-machine run-of-another --json"}},
    VerbText{
        "points",
        points_verb,
        "Arguments for somebody else's program, as CSV; it adds a column of values for grade.",
        "quantity",
        "its name, and name=value or name=lo..hi[:log|:linear|:bits] for arguments that are not to be drawn from "
        "their whole domain",
        {sample_points_option, sample_seed_option},
        {json_flag},
        {"nipref points I1 --points 1000", "nipref points I6 alpha=1e-6..20:log eta=2 >points.csv"},
        true},
    VerbText{
        "grade",
        grade_verb,
        "How wrong somebody else's values are, or the kernels of a shared object, measured as fast's are.",
        "file",
        "a CSV as points writes it with a column of values more, - for standard input, and the quantity's name, "
        "unless the file says it; or a shared object as nipref/kernel.h has it, names or quantities of its kernels "
        "(default: all), and name=lo..hi[:log|:linear|:bits] for arguments that are not to be drawn from their whole "
        "domain. It runs in a process of its own",
        {promise_option, sample_points_option, sample_seed_option, column_option, symbol_option,
         quantity_option, time_limit_option, older_object_option, max_slowdown_option, baseline_option,
         accept_option, junit_option, keep_worst_option},
        {thread_safe_flag, update_baseline_flag, ctest_flag, quiet_flag, json_flag, no_times_flag},
        {"nipref grade results.csv", "nipref grade - I1 --promise 4 --junit grade.xml",
         "nipref grade ./mine.so I1 alpha=1e-3..50 --against ./old.so",
         "nipref grade ./mine.so --symbol f --quantity I1"},
        true},
    VerbText{
        "golden",
        golden_verb,
        "Values that are kept, each confirmed by a second method: make, check, update or list them.",
        "action",
        "make, check, update or list, and names of quantities (default: all); check takes files too. What make and "
        "update write must be said, by -o or --in-place, and no file gets fewer rows than it has",
        {golden_output_option, golden_points_option, golden_digits_option, seed_option, every_option},
        {in_place_flag, all_flag, dirty_flag, quiet_flag, json_flag, no_times_flag},
        {"nipref golden check", "nipref golden check I1 mine.csv --all",
         "nipref golden make I1 --points 1000 -o I1.csv", "nipref golden update Un --in-place"}},
    VerbText{
        "bench",
        bench_verb,
        "Speed against error, beside other libraries.",
        "quantity",
        "names of quantities, or elastic-nip, viscoelastic-nip, half-space for whole contacts (default: all of "
        "it but the quantities of which a value costs a solution)",
        {with_option, isa_option, older_program_option, max_slowdown_option},
        {strict_flag, quiet_flag, json_flag, no_times_flag},
        {"nipref bench I1", "nipref bench elastic-nip --strict", "nipref bench I1 --with ./mine.so",
         "nipref bench I1 --against ../old/build/verify/nipref --max-slowdown 10%"}},
    VerbText{
        "report",
        report_verb,
        "Everything at once: one screen of text, and with -o a page with all plots and tables.",
        "",
        "",
        {report_output_option, older_report_option, report_density_option, report_scenes_option, seed_option},
        {quick_flag, thorough_flag, strict_flag, quiet_flag, json_flag, no_times_flag},
        {"nipref report -o report", "nipref report --quick",
         "nipref report --against old/report.json -o new"}},
};

/// "a whole number from 1 to 100", "ref, fast or both"; empty if the table has no domain for it.
std::string domain_of(const OptionText& option) {
  if (option.range)
    return fmt::format("a {} from {} to {}", option.range->whole ? "whole number" : "number",
                       option.range->least, option.range->most);
  if (option.choices.empty()) return "";
  const auto last = option.choices.end() - 1;
  return fmt::format("{} or {}", fmt::join(option.choices.begin(), last, ", "), *last);
}

std::vector<std::string_view> names_of(std::span<const VerbText> verbs) {
  std::vector<std::string_view> names;
  for (const VerbText& verb : verbs) names.push_back(verb.name);
  return names;
}

}  // namespace

std::string_view program_meaning() {
  return "Verification reference for rolling contact: two independent paths, ref (16 to 1000 digits with bounds) and "
         "fast (double).\n'nipref help VERB' says what a verb takes.";
}

std::string_view exit_statuses() {
  return "Exit status: 0 all well, 1 a check fell short, 2 bad input, 3 incomplete, 4 output could not be written, 70 "
         "internal error, 130 interrupted.\n"
         "An error is one line on standard error; with --json it is an answer on standard output as well.";
}

std::string help_of(const OptionText& option) {
  const std::string domain = domain_of(option);
  return option.meaning + (domain.empty() ? "" : "; " + domain) +
         (option.usual.empty() ? "" : " (default " + option.usual + ")");
}

void check_option(const OptionText& option, const std::string& value) {
  bool allowed = option.choices.empty() || std::ranges::find(option.choices, value) != option.choices.end();
  if (const auto& range = option.range) {
    const double number = parse_real(option.name, value);
    allowed = number >= parse_real(option.name, range->least) &&
              number <= parse_real(option.name, range->most) &&
              (!range->whole || number == std::floor(number));
  }
  if (!allowed) throw BadInput(option.name, value, "must be " + domain_of(option));
}

const OptionText* find_option(const VerbText& verb, std::string_view name) {
  const auto found = std::ranges::find(verb.options, name, &OptionText::name);
  return found == verb.options.end() ? nullptr : &*found;
}

std::string names_of(const OptionText& option) {
  return (option.letter.empty() ? "" : "-" + option.letter + ",") + "--" + option.name;
}

std::span<const VerbText> verbs() { return all_verbs; }

const VerbText& find_verb(const std::string& name) {
  const auto found = std::ranges::find(all_verbs, name, &VerbText::name);
  if (found != all_verbs.end()) return *found;
  const auto known = names_of(all_verbs);
  auto near = known;
  for (const Quantity& quantity : catalogue()) near.push_back(quantity.name);
  throw BadInput(
      "verb", name,
      fmt::format("{}must be one of {}", data::did_you_mean(name, near, 3), fmt::join(known, ", ")));
}

void refuse_unknown_option(const VerbText& verb, const std::string& name, const std::string& value) {
  std::vector<std::string> known{"--help"};
  for (const auto* const group : {&verb.options, &verb.flags}) {
    for (const OptionText& option : *group) known.push_back("--" + option.name);
  }
  if (std::ranges::find(known, name) != known.end()) return;
  throw BadInput(
      name, value,
      fmt::format("unknown option: {}{} takes {}", data::did_you_mean(name, {known.begin(), known.end()}),
                  verb.name, fmt::join(known, ", ")));
}

}  // namespace nipref::verify
