#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/number/caches.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/verify/bench/internal/timed_row.hpp>
#include <nipref/verify/bench/internal/viscoelastic_nip.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/memory/internal/passing_times.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/replay/internal/viscoelastic_nip.hpp>
#include <nipref/verify/replay/internal/viscoelastic_row.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

constexpr auto viscoelastic_nip = "viscoelastic-nip";

/// Bulk modulus 1 and relaxation time 1, at unit speed and half-thickness.
data::ViscoelasticMaterial unit_solid() {
  return data::single_relaxation_time_solid(1, data::thesis_shear_over_bulk, 1);
}

struct Times {
  double t, T;
};

/// Loads under way for up to ten half-thicknesses, before and behind the point.
std::vector<Times> load_paths(std::size_t count) {
  Random random("bench Un");
  std::vector<Times> all;
  while (all.size() < count) {
    const double t = random.log_uniform(1e-2, 10);
    all.push_back({t, draw_passing_time(t, random)});
  }
  return all;
}

struct UnMethod {
  std::string name;
  std::function<double(const Times&)> evaluate;
};

std::vector<UnMethod> methods_for_Un() {
  std::vector<UnMethod> all;
  for (const double rtol : {fast::Accuracy::best_rtol, 1e-9, 1e-6, 1e-3}) {
    const fast::MovingLoad load(unit_solid(), 1, 1, fast::Accuracy(rtol));
    all.push_back(
        {rtol == fast::Accuracy::best_rtol ? "fast Un full" : fmt::format("fast Un rtol={:.0e}", rtol),
         [load](const Times& at) { return load.normal_displacement(at.t, at.T); }});
  }
  for (const int terms : {500, 100, 20}) {
    const fast::PlainMovingLoad load(unit_solid(), 1, 1, terms);
    all.push_back({fmt::format("thesis Un, {} terms", terms),
                   [load](const Times& at) { return load.normal_displacement(at.t, at.T); }});
  }
  return all;
}

/// Largest error over the scale of the catalogue's Un, at the first few of the points.
double largest_error(const UnMethod& method, const std::vector<Times>& points) {
  constexpr std::size_t compared = 30;
  const auto material = ref::exact_material(unit_solid(), 40);
  const Quantity& Un = find_quantity("Un");
  double largest = 0;
  for (std::size_t i = 0; i < compared; ++i) {
    const auto [t, T] = points[i];
    const auto truth = ref::moving_load_normal_displacement(ref::Exact(t), ref::Exact(T), ref::Exact(1.0),
                                                            ref::Exact(1.0), material, 20);
    const double scale = Un.envelope(std::vector<double>{t, T, 1, 1, 0, 1, 1});
    largest = std::max(largest, std::fabs(truth.error_of(method.evaluate(points[i]))) / scale);
  }
  return largest;
}

BenchReport bench_Un() {
  const auto points = load_paths(200);
  const auto methods = methods_for_Un();
  std::vector<Contender> contenders;
  std::vector<double> values(points.size());
  for (const UnMethod& method : methods) {
    contenders.push_back({[&](std::size_t count) {
                            for (std::size_t i = 0; i < count; ++i)
                              values[i % points.size()] = method.evaluate(points[i % points.size()]);
                          },
                          points.size(), 1000});
  }
  const auto timings = time_interleaved(contenders);
  BenchReport report;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const double error = largest_error(methods[i], points);
    report.rows.push_back(
        timed_row(viscoelastic_nip, "t in [0.01,10], T around", methods[i].name, timings[i], timings[0]));
    report.rows.back().max_error_ulp = error / 0x1p-52;
    report.rows.back().max_relative_error = error;
  }
  report.ratios.push_back(
      {"time of Un by 500 terms over fast Un at full accuracy", timings[4].seconds / timings[0].seconds, 50});
  return report;
}

/// Finds the contact length of B = 0.005 in, W = 100 lbf/in, F0 tau = 0.1 in.
struct NipMethod {
  std::string name;
  std::function<double()> length;
};

BenchReport bench_nip() {
  const data::Table table = data::load_table_by_id("thesis-XXIV");
  const ViscoelasticTable& how = *find_viscoelastic_table(table.id);
  constexpr std::size_t row = 4;
  const data::ViscoelasticNip nip = viscoelastic_nip_of_the_tables(table, row, false);
  const double load = table.parameter("W").value;
  std::vector<NipMethod> methods{
      {"thesis: m1=10, 500 terms, search for m2", [=, &how] {
         return fast::viscoelastic_line_loads_by_search(nip, viscoelastic_method(how), load).contact_length();
       }}};
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10}) {
    methods.push_back({fmt::format("converged {:.0e}", accuracy),
                       [=] { return fast::converged_for_load(nip, load, accuracy).contact_length().value; }});
  }
  std::vector<Contender> contenders;
  for (const NipMethod& method : methods) {
    contenders.push_back({[&](std::size_t count) {
                            for (std::size_t i = 0; i < count; ++i) static_cast<void>(method.length());
                          },
                          1, 1000});
  }
  const auto timings = time_interleaved(contenders);
  // No reference path solves this contact: the finest of its own, stated as such in the method's name.
  const double truth = fast::converged_for_load(nip, load, 1e-12).contact_length().value;
  BenchReport report;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const double error = std::fabs(methods[i].length() / truth - 1);
    report.rows.push_back(timed_row(viscoelastic_nip, "B=0.005 W=100 F0tau=0.1",
                                    methods[i].name + " (against 1e-12)", timings[i], timings[2]));
    report.rows.back().max_error_ulp = error / 0x1p-52;
    report.rows.back().max_relative_error = error;
  }
  report.ratios.push_back({"time of the thesis's rolling contact (m1 = 10) over converged 1e-6",
                           timings[0].seconds / timings[2].seconds, 1});
  return report;
}

/// All rows of Tables XI to XXVI, one thread: the row from its length, at the ends of the length's rounding
/// interval too.
double seconds_of_replay(int residue_terms) {
  fast::clear_caches();
  return seconds_of([&] {
    for (const ViscoelasticTable& how : viscoelastic_tables()) {
      const data::Table table = data::load_table_by_id(std::string(how.id));
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto nip = viscoelastic_nip_of_the_tables(table, row, false);
        auto method = viscoelastic_method(how);
        const auto input = viscoelastic_row_input(table, row, nip, method);
        method.trailing_elements = input.trailing_elements;
        method.residue_terms = residue_terms;
        static_cast<void>(replay_viscoelastic_row(nip, method, input.leading_length));
      }
    }
  });
}

BenchReport bench_replay() {
  BenchReport report;
  const auto row = [&](const std::string& method, double seconds) {
    report.rows.push_back(
        {viscoelastic_nip, "all rows of Tables XI-XXVI", method, 1e9 * seconds, {}, {}, {}});
  };
  const double plain = seconds_of_replay(500);
  row("replay, 500 terms", plain);
  row("replay, exact kernels", seconds_of_replay(0));
  report.ratios.push_back({"60 s over the replay of XI-XXVI with 500 terms", 60 / plain, 1});
  return report;
}

}  // namespace

BenchReport bench_viscoelastic(const BenchProgress& progress) {
  BenchReport report;
  const auto add = [&](const char* what, BenchReport (*part)()) {
    if (interrupted()) return;
    progress(what);
    append(report, part());
  };
  add("Un", bench_Un);
  add("contacts", bench_nip);
  add("replay of Tables XI-XXVI", bench_replay);
  return report;
}

}  // namespace nipref::verify
