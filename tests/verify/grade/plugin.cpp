#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/grade/fault.hpp>
#include <nipref/verify/grade/plugin.hpp>
#include <nipref/verify/grade/speed.hpp>

#include "support/paths.hpp"
#include "support/scratch.hpp"

using namespace nipref;
using verify::AuditOptions;
using verify::AuditResult;
using verify::Fault;
using verify::FaultKind;
using verify::open_kernel;
using verify::Plugin;
using verify::PluginKernel;
using verify::Point;
using verify::Quantity;

namespace {

constexpr double here = 17.25;

Plugin test_kernels(double time_limit = 60) { return {plugin_file("kernels"), {}, time_limit}; }

/// A kernel of the test's plugin, and its grading.
struct Graded {
  explicit Graded(const std::string& name, AuditOptions options = {400, {}, {}},
                  const Plugin& plugin = test_kernels())
      : kernel(open_kernel(plugin, name)), quantity(verify::find_quantity(quantity_of(*kernel))) {
    options.more_points.push_back(Point(quantity.arguments.size(), here));
    result = verify::audit(quantity, kernel->evaluator(), options);
    faults = kernel->faults();
  }

  static std::string quantity_of(const PluginKernel& kernel) {
    return kernel.info().quantity.empty() ? "I3" : kernel.info().quantity;
  }

  std::unique_ptr<PluginKernel> kernel;
  const Quantity& quantity;
  AuditResult result{};
  std::vector<Fault> faults;
};

}  // namespace

TEST_CASE("fast as a plugin, and as a bare function, has exactly the numbers of its audit") {
  const AuditOptions options{400, {}, {}};
  const auto check = [&](PluginKernel& kernel, const std::string& name) {
    CAPTURE(name);
    const Quantity& quantity = verify::find_quantity(name);
    const AuditResult found = verify::audit(quantity, kernel.evaluator(), options);
    CHECK(found.kept());
    CHECK(verify::audit_row_json(found).text() ==
          verify::audit_row_json(verify::audit(quantity, options)).text());
    CHECK(kernel.faults().empty());
  };
  for (const char* name : {"all_sound", "all_sound_I1", "sound_I6", "with_state"}) {
    const auto kernel = open_kernel(test_kernels(), name);
    check(*kernel, kernel->info().quantity);
  }
  for (const auto& [symbol, arity] : {std::pair<std::string, std::size_t>{"bare_I3", 1}, {"bare_I6", 2}}) {
    const auto kernel = open_kernel({plugin_file("kernels"), {{symbol, arity, true}}}, symbol);
    check(*kernel, symbol.substr(5));
  }
}

TEST_CASE("a fault at one point is named with it, alone, and only there may the value be wrong") {
  struct Planted {
    const char* kernel;
    FaultKind kind;
    const char* says;
    bool has_value;
  };
  for (const auto& [kernel, kind, says, has_value] : {
         Planted{"no_number", FaultKind::not_finite, "nan", false},
             {"crashes", FaultKind::crash, "SIGSEGV", false},
             {"aborts", FaultKind::crash, "SIGABRT (Aborted), saying: I have had enough", false},
             {"hangs", FaultKind::hang, "no answer within 1 s", false},
             {"exits", FaultKind::exit, "status 0", false},
#if defined(__x86_64__) || defined(__aarch64__)
             {"flushes", FaultKind::environment, "flushed to zero", true},
#endif
             {"rounds_up", FaultKind::environment, "rounding mode", true},
             {"prints", FaultKind::output, "standard output", true},
             {"changes_arguments", FaultKind::arguments, "writes to its arguments", true},
             {"leaves_out", FaultKind::unwritten, "no value", false},
             {"refuses", FaultKind::refused, "returns 7", false},
       }) {
    CAPTURE(kernel);
    // The time limit is for a batch of 64 points, which takes a thousandth of a second.
    const Graded found(kernel, {200, {}, {}}, test_kernels(kind == FaultKind::hang ? 1 : 60));
    REQUIRE(found.faults.size() == 1);
    CAPTURE(found.faults[0].words);
    CHECK(found.faults[0].kind == kind);
    CHECK(found.faults[0].point == Point{here});
    CHECK(contains(found.faults[0].words, says));
    CHECK(found.result.kept() == has_value);
    REQUIRE(found.result.spread.wrong.has_value() == !has_value);
    if (has_value) continue;
    CHECK(found.result.spread.wrong->lower[0] == here);
    CHECK(found.result.spread.wrong->upper[0] == here);
  }
}

TEST_CASE("faults that are no one point's are named once, with their number, and leave the values") {
  struct Planted {
    std::string kernel;
    FaultKind kind;
    std::string says;
    std::size_t least = 1, most = 1000;
    bool kept = true;
  };
  AuditOptions few{100, {}, {}};
  few.ranges = verify::parse_ranges(verify::find_quantity("I3"), {{"alpha", "1..2"}});
  for (const Planted& planted :
       {Planted{"one_too_many", FaultKind::overrun, "its output", 51},
        {"one_too_early", FaultKind::overrun, "its output", 51},
        {"reads_too_much", FaultKind::overrun, "its arguments", 51},
        {"first_is_other", FaultKind::order, "in another order of points", 1, 1000, false},
        {"crashes_often", FaultKind::crash, "SIGSEGV", 10, 90, false},
        {"not_closed", FaultKind::crash, ", in close"},
        {"speaks", FaultKind::protocol, "wrote to a descriptor that is not its own, in open", 1, 1000, false},
        {"speaks_last", FaultKind::protocol, "wrote to a descriptor that is not its own, in close"}}) {
    CAPTURE(planted.kernel);
    const Graded found(planted.kernel, few);
    const auto groups = verify::grouped(found.faults);
    REQUIRE_FALSE(groups.empty());
    CHECK(groups[0].kind == planted.kind);
    CHECK(groups[0].count >= planted.least);
    CHECK(groups[0].count <= planted.most);
    CHECK(contains(groups[0].first[0].words, planted.says));
    if (planted.kept) CHECK(found.result.kept());
  }
  const Graded unopened("not_opened", few);
  REQUIRE(unopened.faults.size() == 2);
  CHECK(unopened.faults[0].words == "returns 3, in open");
  CHECK(unopened.faults[1].kind == FaultKind::given_up);
  CHECK_FALSE(unopened.result.kept());
}

TEST_CASE("a state that threads share without care is found, in kernels and in bare functions") {
  const auto bare = [](bool is_thread_safe) {
    return Plugin{plugin_file("kernels"), {{"bare_shares", 1, is_thread_safe}}, 60};
  };
  for (const Graded& found : {Graded("shares"), Graded("bare_shares", {400, {}, {}}, bare(true))}) {
    const auto groups = verify::grouped(found.faults);
    REQUIRE(groups.size() == 1);
    CHECK(groups[0].kind == FaultKind::threads);
    CHECK(groups[0].lower.has_value());
    CHECK(found.result.kept());
  }
  CHECK(Graded("bare_shares", {400, {}, {}}, bare(false)).faults.empty());
}

TEST_CASE("a crash in larger batches alone is named with the batch, and its points have values") {
  const Graded found("crashes_in_batches");
  REQUIRE(found.faults.size() == 1);
  CHECK(found.faults[0].kind == FaultKind::crash);
  const std::string& words = found.faults[0].words;
  CAPTURE(words);
  const std::string begins = ", in a batch of ";
  REQUIRE(contains(words, begins));
  // A batch that crashes is halved until neither half crashes.
  const char size = words[words.find(begins) + begins.size()];
  CHECK(size >= '4');
  CHECK(size <= '7');
  CHECK(found.result.kept());
}

TEST_CASE("a kernel that crashes or hangs at every point comes to an end, and is said to be given up") {
  for (const auto& [name, limit] : {std::pair("crashes_always", 60.0), std::pair("hangs_always", 0.05)}) {
    CAPTURE(name);
    const auto kernel = open_kernel(test_kernels(limit), name);
    const std::vector<Point> points(5000, Point{1.5});
    std::vector<double> values(points.size());
    kernel->evaluate(points, values);
    CHECK(std::ranges::all_of(values, [](double value) { return std::isnan(value); }));
    const std::vector<Fault> faults = kernel->faults();
    REQUIRE(faults.size() == 2);
    CHECK(faults[0].point == Point{1.5});
    CHECK(faults[1].kind == FaultKind::given_up);
  }
}

TEST_CASE("a plugin that prints and flushes small numbers as it is loaded is named for it") {
  const Graded found("zero", {100, {}, {}}, {plugin_file("prints_and_flushes"), {}, 60});
  const auto groups = verify::grouped(found.faults);
#if defined(__x86_64__)
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].kind == FaultKind::environment);
  CHECK(groups[0].count == 1);
  CHECK(contains(groups[0].first[0].words, "FTZ"));
  CHECK(contains(groups[0].first[0].words, "DAZ"));
  CHECK(groups[0].first[0].words.ends_with("by being loaded"));
#endif
  CHECK(groups.back().kind == FaultKind::output);
  CHECK(groups.back().count == 1);
}

TEST_CASE("a shared object that lists other kernels in its next process is refused") {
  const ScratchFolder scratch;
  const Environment left("NIPREF_TEST_FICKLE", scratch.file("loaded"));
  CHECK_REFUSED(open_kernel({plugin_file("fickle")}, "zero"), "must list the same kernels each time");
}

TEST_CASE("a shared object of a newer header is understood, others are refused in one line") {
  CHECK(verify::kernels_of({plugin_file("newer")}).at(0).name == "zero");
  for (const auto& [plugin, says] : {
           std::pair{Plugin{plugin_file("other_abi")}, "ABI number 2: must be 1"},
           {{plugin_file("no_list")},
            "has no symbol nipref_kernels, as nipref/kernel.h describes it: name a function by --symbol"},
           {{plugin_file("empty_list")}, "lists no kernels"},
           {{plugin_file("crashes")}, "must be loaded without harm: crash, SIGABRT"},
           {{plugin_file("there_is_none")}, "cannot open shared object file"},
           {{source_directory() + "/README.md"}, "README.md"},
           {{plugin_file("kernels"), {{"no_such_function"}}}, "has no symbol no_such_function"},
           {{plugin_file("kernels"), {{"bare_I3", 17}}}, "must be 1 to 16"},
           {{plugin_file("kernels"), {}, 0}, "time-limit"},
       })
    CHECK_REFUSED(verify::kernels_of(plugin), says);
  CHECK_REFUSED(open_kernel(test_kernels(), "al_sound"), "all_sound");
}

TEST_CASE("faults are told in a few lines, with where the others lie") {
  const Quantity& quantity = verify::find_quantity("I3");
  std::vector<Fault> faults{{FaultKind::environment, {}, "leaves another rounding mode, in open"}};
  for (int i = 0; i < 100; ++i) faults.push_back({FaultKind::crash, Point{i / 4.0}, "SIGSEGV"});
  const std::string text =
      verify::text_of("grade_faults.txt", {{"faults", verify::faults_json(quantity, faults)}});
  CHECK(text ==
        "  crash at alpha=0 (0x0p+0): SIGSEGV\n"
        "  crash at alpha=0.25 (0x1p-2): SIGSEGV\n"
        "  crash at alpha=0.5 (0x1p-1): SIGSEGV\n"
        "  crash at alpha=0.75 (0x1.8p-1): SIGSEGV\n"
        "  crash: and 96 more, all in alpha=0 (0x0p+0) ... alpha=24.75 (0x1.8cp+4)\n"
        "  environment changed: leaves another rounding mode, in open\n");
  CHECK(contains(verify::faults_json(quantity, faults).text(), "\"count\": 100"));
}
