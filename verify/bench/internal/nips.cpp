#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/number/caches.hpp>
#include <nipref/fast/partial_slip/line_loads.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/partial_slip/partial_slip.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

namespace nipref::verify {
namespace {

using data::Friction;

constexpr auto elastic_nip = "elastic-nip", viscoelastic_nip = "viscoelastic-nip";

/// A way to compute a number of a contact. `error_of` is empty if there is no independent value to compare with.
TimedWay contact_way(const std::string& name, const std::function<double()>& number,
                     const std::function<WayError(double number)>& error_of = {}) {
  TimedWay way{name, repeated([=](std::size_t) { return number(); })};
  if (error_of) way.error = [=] { return error_of(number()); };
  return way;
}

auto error_against(const ref::Estimate& truth) {
  return [=](double number) {
    const double error = std::fabs(truth.error_of(number));
    return WayError{error / ulp_of(number), error / std::fabs(number)};
  };
}

/// Contacts at the middle one of the thesis's loads.
std::vector<BenchRow> elastic_contacts(double thickness) {
  constexpr double load = 100;
  constexpr int length_digits = 20;
  const data::ElasticNip nip = data::seed::nip(thickness);
  const auto converged = [&](Friction friction, double accuracy) {
    return [=] { return fast::converged_for_load(nip, friction, load, accuracy).contact_length().value; };
  };
  const auto error_of =
      error_against(ref::converged_for_load(nip, Friction::none, load, length_digits).contact_length());
  const auto by_thesis = [&] {
    const fast::LoadSearch search{fast::LoadSearch::Iteration::thesis, 2e-3};
    return fast::line_loads_for_load(nip, {10, 500}, load, {}, search).contact_length();
  };
  const auto by_line_loads = [&] { return fast::line_loads_for_load(nip, 10, load).contact_length(); };
  std::vector<TimedWay> ways{contact_way("thesis: m=10, 500 terms", by_thesis, error_of),
                             contact_way("line loads, m=10, fast kernels", by_line_loads, error_of)};
  for (const double accuracy : {1e-4, 1e-6, 1e-10, 1e-13})
    ways.push_back(contact_way(fmt::format("converged {:.0e}", accuracy), converged(Friction::none, accuracy),
                               error_of));
  ways.push_back(contact_way("converged 1e-10, full friction", converged(Friction::full, 1e-10)));
  constexpr double relaxation_length = 0.1;
  const data::Compliances at_once{nip.material.theta1(), nip.material.theta2()};
  const data::ViscoelasticNip rolled{nip.roller_radius, nip.sheet_thickness,
                                     data::single_relaxation_time_solid(at_once, relaxation_length), 1};
  for (const double accuracy : {1e-6, 1e-10})
    ways.push_back(contact_way(fmt::format("converged {:.0e}, rolling", accuracy), [=] {
      return fast::converged_for_load(rolled, load, accuracy).contact_length().value;
    }));
  return timed_rows(elastic_nip, fmt::format("B={} W=100", thickness), ways, {.over = 4});
}

/// The creep ratio with Coulomb's friction. Each roller transmits half of the largest possible traction.
std::vector<BenchRow> creep_with_slip() {
  constexpr double load = 100, friction = 0.1;
  const data::PartialSlipNip nip{data::seed::nip(0.25), friction, data::GivenTraction{friction * load / 2}};
  const auto error_of = error_against(ref::partial_slip_for_load(nip, load, 16).creep_ratio());
  std::vector<TimedWay> ways;
  for (const int elements : {10, 40, 160})
    ways.push_back(contact_way(
        fmt::format("line loads, m={}", elements),
        [=] { return fast::line_loads_for_load(nip, elements, load).creep_ratio(); }, error_of));
  for (const double accuracy : {1e-4, 1e-6, 1e-10})
    ways.push_back(contact_way(
        fmt::format("converged {:.0e}", accuracy),
        [=] { return fast::partial_slip_for_load(nip, load, accuracy).creep_ratio().value; }, error_of));
  return timed_rows(elastic_nip, "creep, B=0.25 W=100 T=5 friction=0.1", ways, {.over = 5});
}

/// Times all rows of Tables III to X without the loading of the tables.
std::vector<BenchRow> elastic_replay() {
  std::vector<data::Table> tables;
  for (const LineLoadTable& how : line_load_tables())
    tables.push_back(data::load_table_by_id(std::string(how.id)));
  const auto replay_all = [&](std::size_t) {
    std::size_t cells = 0;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const LineLoadTable& how = line_load_tables()[i];
      cells += replay_line_loads(tables[i], how.friction, how.elements_per_side).cells.size();
    }
    return cells;
  };
  auto rows = timed_rows(elastic_nip, "all rows of Tables III-X", {{"replay", repeated(replay_all)}});
  rows.front().ratio.reset();
  return rows;
}

/// Bulk modulus 1 and relaxation time 1, at unit speed and half-thickness.
data::ViscoelasticMaterial unit_solid() {
  return data::single_relaxation_time_solid(1, data::thesis_shear_over_bulk, 1);
}

struct Times {
  double t, T;
};

/// Paths of loads that have moved by up to ten half-thicknesses. The point lies ahead of the load or behind it.
std::vector<Times> load_paths(std::size_t count) {
  Random random("bench Un");
  std::vector<Times> all;
  while (all.size() < count) {
    const double t = random.log_uniform(1e-2, 10);
    all.push_back({t, draw_passing_time(t, random)});
  }
  return all;
}

/// The largest error relative to the scale of the catalogue's Un, at the first few points.
double largest_error(const auto& by_method, const std::vector<Times>& points) {
  constexpr std::size_t compared = 30;
  const ref::MovingLoad load(ref::exact_material(unit_solid()), ref::Exact(1.0), ref::Exact(1.0));
  const Quantity& Un = find_quantity("Un");
  double largest = 0;
  for (std::size_t i = 0; i < compared; ++i) {
    const auto [t, T] = points[i];
    const auto truth = load.normal_displacement(ref::Exact(t), ref::Exact(T), 20);
    const ParsedArguments at =
        parse_arguments(Un, {{"t", fmt::format("{:a}", t)}, {"T", fmt::format("{:a}", T)}});
    const double scale = Un.envelope(at.nearest(Un));  // the other arguments are those of unit_solid()
    largest = std::max(largest, std::fabs(truth.error_of(by_method(points[i]))) / scale);
  }
  return largest;
}

std::vector<BenchRow> displacements_under_moving_load() {
  const auto points = load_paths(200);
  std::vector<TimedWay> ways;
  const auto add = [&](const std::string& name, const auto& load) {
    const auto Un = [load](const Times& at) { return load.normal_displacement(at.t, at.T); };
    Contender contender = repeated([=, &points](std::size_t i) { return Un(points[i % points.size()]); });
    contender.least = points.size();
    ways.push_back({name, contender, [=, &points] { return of_relative(largest_error(Un, points)); }});
  };
  for (const double rtol : {fast::Accuracy::best_rtol, 1e-9, 1e-6, 1e-3})
    add(rtol == fast::Accuracy::best_rtol ? "fast Un full" : fmt::format("fast Un rtol={:.0e}", rtol),
        fast::MovingLoad(unit_solid(), 1, 1, fast::Accuracy(rtol)));
  for (const int terms : {500, 100, 20})
    add(fmt::format("thesis Un, {} terms", terms), fast::PlainMovingLoad(unit_solid(), 1, 1, terms));
  return timed_rows(viscoelastic_nip, "t in [0.01,10], T around", ways);
}

/// The contact length for B = 0.005 in, W = 100 lbf/in, F0 tau = 0.1 in. The reference path does not solve this
/// contact. The result of fast at its finest accuracy takes the place of the truth, as the names of the methods say.
std::vector<BenchRow> rolling_contacts() {
  const data::Table table = data::load_table_by_id("thesis-XXIV");
  const ViscoelasticTable& how = *find_viscoelastic_table(table.id);
  constexpr std::size_t row = 4;
  const data::ViscoelasticNip nip = viscoelastic_nip_of_the_tables(table, row, false);
  const double load = table.parameter("W").value;
  const auto converged = [&](double accuracy) {
    return fast::converged_for_load(nip, load, accuracy).contact_length().value;
  };
  const auto by_thesis = [&] {
    auto method = viscoelastic_method(how);
    method.trailing_elements.reset();
    return fast::line_loads_for_load(nip, method, load).contact_length();
  };
  const double truth = converged(1e-12);
  const auto error_of = [=](double length) { return of_relative(std::fabs(length / truth - 1)); };
  std::vector<TimedWay> ways{
      contact_way("thesis: m1=10, 500 terms, search for m2 (against 1e-12)", by_thesis, error_of)};
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10})
    ways.push_back(contact_way(
        fmt::format("converged {:.0e} (against 1e-12)", accuracy), [=] { return converged(accuracy); },
        error_of));
  return timed_rows(viscoelastic_nip, "B=0.005 W=100 F0tau=0.1", ways, {.over = 2});
}

/// The seconds for all rows of Tables XI to XXVI, from their lengths, in one thread.
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

std::vector<BenchRow> rolling_replay() {
  std::vector<BenchRow> rows;
  for (const auto& [method, terms] : {std::pair{"replay, 500 terms", 500}, {"replay, exact kernels", 0}})
    rows.push_back(
        {viscoelastic_nip, "all rows of Tables XI-XXVI", method, 1e9 * seconds_of_replay(terms), {}, {}, {}});
  return rows;
}

}  // namespace

std::vector<BenchPart> elastic_bench() {
  auto parts = mapped<BenchPart>(data::seed::sheet_thicknesses, [](double thickness) {
    return BenchPart{fmt::format("B={} W=100", thickness), [=] { return elastic_contacts(thickness); }};
  });
  parts.push_back({"creep with Coulomb's friction", creep_with_slip});
  parts.push_back({"replay of Tables III-X", elastic_replay});
  return parts;
}

std::vector<BenchPart> viscoelastic_bench() {
  return {{"Un", displacements_under_moving_load},
          {"contacts", rolling_contacts},
          {"replay of Tables XI-XXVI", rolling_replay}};
}

}  // namespace nipref::verify
