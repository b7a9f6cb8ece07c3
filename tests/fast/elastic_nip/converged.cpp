// The converged contact: its own equations, its error estimates, its work.
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::ElasticNip;
using data::Friction;
using fast::converged_for_length;
using fast::converged_for_load;
using fast::ConvergedNip;
using fast::Estimate;

namespace {

const ElasticNip table_nip = nipref::data::seed::nip(0.25);

std::vector<std::function<Estimate(const ConvergedNip&)>> results(Friction friction) {
  std::vector<std::function<Estimate(const ConvergedNip&)>> all{
      [](const ConvergedNip& contact) { return contact.contact_length(); },
      [](const ConvergedNip& contact) { return contact.load(); },
      [](const ConvergedNip& contact) { return contact.indentation(); },
      [](const ConvergedNip& contact) { return contact.leading_displacement(); },
      [](const ConvergedNip& contact) { return contact.creep_ratio(); },
      [](const ConvergedNip& contact) { return contact.pressure(0); },
      [](const ConvergedNip& contact) { return contact.pressure(0.3 * contact.contact_length().value); },
      [](const ConvergedNip& contact) { return contact.peak_pressure(); },
      [](const ConvergedNip& contact) { return contact.normal_displacement(contact.contact_length().value); },
      [](const ConvergedNip& contact) {
        return contact.tangential_displacement(contact.contact_length().value);
      }};
  if (friction == Friction::full) {
    all.push_back(
        [](const ConvergedNip& contact) { return contact.shear(0.3 * contact.contact_length().value); });
    all.push_back([](const ConvergedNip& contact) { return contact.peak_shear(); });
  }
  return all;
}

}  // namespace

TEST_CASE("one expansion over the whole contact and panels that double from its end agree") {
  for (const double half_length : {0.05, 0.7, 2.5}) {
    for (const Friction friction : {Friction::none, Friction::full}) {
      CAPTURE(half_length);
      const fast::ElasticEquations equations(friction, 0.3);
      fast::Work work;
      fast::CountedKernels kernels(fast::Accuracy{}, work);
      const double a = half_length;
      const fast::Solution one = equations.solve(a, {{0, 2 * a, true, true, 24}}, 1e-16, kernels);
      const fast::Solution other = equations.solve(
          a,
          {{0, a / 4, true, false, 24}, {a / 4, a / 2, false, false, 24}, {a / 2, 1.5 * a, false, true, 16}},
          1e-16, kernels);
      CHECK(one.value(one.load()) == approx(other.value(other.load()), 1e-12));
      const double peak = one.traction(a).real();
      for (const double x : {1e-4, 0.1, 0.4, 0.6, 1.0})
        CHECK(std::abs(one.traction(x * a) - other.traction(x * a)) < 1e-10 * peak);
    }
  }
}

TEST_CASE("between its matching points a solution satisfies its equations") {
  for (const double half_length : {0.01, 1.0, 6.0, 40.0}) {
    for (const double poisson : {-0.5, 1.0 / 3, 0.5}) {
      for (const Friction friction : {Friction::none, Friction::full}) {
        CAPTURE(half_length);
        CAPTURE(poisson);
        const auto equations = std::make_shared<const fast::ElasticEquations>(friction, poisson);
        const fast::SolvedNip nip(equations, half_length, {}, 1e-12);
        const fast::Solution& solution = nip.last();
        fast::CountedKernels kernels = nip.kernels();
        const double edge = solution.unknown(fast::ElasticEquations::edge_displacement);
        const double depth = edge + half_length * half_length, peak = solution.traction(half_length).real();
        for (const double x : {1e-3, 0.0371, 0.217, 0.63, 0.971}) {
          const double e = x * half_length;
          CHECK(std::fabs(solution.value(equations->normal(solution, {false, e}, kernels)) -
                          (edge + e * (2 * half_length - e))) < 1e-11 * (depth + peak));
          if (friction == Friction::full) {
            const double creep = solution.unknown(fast::ElasticEquations::creep_ratio);
            CHECK(std::fabs(solution.value(equations->along(solution, {false, e}, kernels).displacement) -
                            creep * (half_length - e)) < 1e-11 * (depth + peak * half_length));
          }
        }
      }
    }
  }
}

TEST_CASE("error estimates cover the error") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> log_thickness(-3, 0.5), log_load(0, 2.5), ratio(-0.9, 0.5);
  for (int trial = 0; trial < 12; ++trial) {
    const Friction friction = trial % 2 ? Friction::full : Friction::none;
    const ElasticNip nip{table_nip.roller_radius,
                         std::pow(10, log_thickness(random)),
                         {table_nip.material.young, ratio(random)}};
    const double load = std::pow(10, log_load(random));
    const auto truth = converged_for_load(nip, friction, load, 1e-13);
    for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      const auto contact = converged_for_load(nip, friction, load, accuracy);
      CHECK(std::fabs(contact.load().value / load - 1) <= contact.load().error / load);
      const double length = truth.contact_length().value;
      CHECK(std::fabs(contact.contact_length().value / length - 1) < accuracy);
      std::size_t index = 0;
      for (const auto& result : results(friction)) {
        if (index++ == 1) continue;  // the load is given
        const Estimate estimate = result(contact), exact = result(truth);
        CAPTURE(nip.sheet_thickness);
        CAPTURE(nip.material.poisson);
        CAPTURE(load);
        CAPTURE(accuracy);
        CAPTURE(index);
        CAPTURE(exact.value);
        const double error = std::fabs(estimate.value - exact.value);
        CHECK(error <= estimate.error + exact.error);
      }
    }
  }
}

TEST_CASE("asking for less costs less") {
  const auto coarse = converged_for_load(table_nip, Friction::none, 100, 1e-4);
  const auto fine = converged_for_load(table_nip, Friction::none, 100, 1e-10);
  CHECK(coarse.work().terms < fine.work().terms);
  CHECK(coarse.work().systems < fine.work().systems);
  const ElasticNip thin = nipref::data::seed::nip(0.005);
  CHECK(converged_for_load(thin, Friction::none, 100, 1e-4).work().unknowns <
        converged_for_load(thin, Friction::none, 100, 1e-10).work().unknowns);
  static_cast<void>(
      fine.peak_pressure());  // solves the longer contact that tells how numbers change with the length
  const auto before = fine.work();
  CHECK(before.kernel_evaluations[0] > 0);
  static_cast<void>(fine.indentation());
  static_cast<void>(fine.normal_displacement(0.01));
  CHECK(fine.work().terms == before.terms);
  for (const std::size_t shear_kernel : {1U, 2U, 3U, 4U, 5U, 6U})
    CHECK(before.kernel_evaluations[shear_kernel] == 0);
  static_cast<void>(fine.creep_ratio());
  CHECK(fine.work().kernel_evaluations[2] > 0);
  CHECK(fine.work().kernel_evaluations[5] == 0);
}

TEST_CASE("from half-space to film, from auxetic to incompressible, over twelve decades of load: an answer") {
  for (const double poisson : {-0.9, 0.0, 0.3, 0.49, 0.4999, 0.5}) {
    for (const Friction friction : {Friction::none, Friction::full}) {
      for (const double ratio : {1e-4, 1e-2, 1.0, 30.0, 1e3}) {
        CAPTURE(poisson);
        CAPTURE(ratio);
        const ElasticNip nip{1, ratio > 1 ? 1e-4 : 1e-2, {1.0, poisson}};
        const auto contact = converged_for_length(nip, friction, ratio * nip.sheet_thickness, 1e-8);
        CHECK(contact.load().value > 0);
        CHECK(contact.load().error < 1e-6 * contact.load().value);
        CHECK(contact.indentation().error < 1e-5 * contact.indentation().value);
      }
      double last_length = 0;
      for (int decade = -11; decade <= 1; ++decade) {
        const ElasticNip nip{1, 1e-2, {100.0, poisson}};
        const auto contact = converged_for_load(nip, friction, std::pow(10, decade), 1e-6);
        CHECK(contact.contact_length().value > last_length);
        last_length = contact.contact_length().value;
        CHECK(contact.contact_length().error < 1e-5 * last_length);
      }
    }
  }
}

TEST_CASE("the converged shear has one sign on each side of thick and thin sheets, and two in between") {
  struct Sheet {
    double thickness;
    int reversals;  ///< on each side
  };
  for (const Sheet& sheet : {Sheet{1, 0}, {0.25, 0}, {0.0625, 1}, {0.005, 0}}) {
    CAPTURE(sheet.thickness);
    const ElasticNip nip = nipref::data::seed::nip(sheet.thickness);
    const auto contact = converged_for_load(nip, Friction::full, 100, 1e-10);
    const double half = contact.contact_length().value / 2;
    int turns = 0, reversals = 0;
    double before = 0, step_before = 0;
    // Nearer to an end than 1/400 the end's own oscillation, r^(1/2) cos(eps ln r), may turn it once more.
    for (int i = 1; i < 400; ++i) {
      const double shear = contact.shear(half * i / 400).value;
      const double step = shear - before;
      if (step * step_before < 0) ++turns;
      if (shear * before < 0) ++reversals;
      before = shear;
      step_before = step;
    }
    CHECK(turns <= 2);
    CHECK(reversals == sheet.reversals);
    CHECK(contact.shear(-half / 2).value == -contact.shear(half / 2).value);
    CHECK(contact.pressure(-half / 2).value == contact.pressure(half / 2).value);
    CHECK(contact.shear(1.1 * half).value == 0);
    CHECK(contact.pressure(1.1 * half).value == 0);
  }
}

TEST_CASE("units: lengths and stresses scale out") {
  const ElasticNip other{6e3, 250, {1.45e2, 1.0 / 3}};
  for (const Friction friction : {Friction::none, Friction::full}) {
    const auto contact = converged_for_load(table_nip, friction, 100, 1e-10);
    const auto scaled = converged_for_load(other, friction, 100, 1e-10);
    CHECK(scaled.contact_length().value == approx(1e3 * contact.contact_length().value, 1e-10));
    CHECK(scaled.pressure(10).value == approx(1e-3 * contact.pressure(0.01).value, 1e-10));
    CHECK(scaled.creep_ratio().value == approx(contact.creep_ratio().value, 1e-9));
    CHECK(scaled.normal_displacement(200).value ==
          approx(1e3 * contact.normal_displacement(0.2).value, 1e-9));
    CHECK(scaled.tangential_displacement(200).value ==
          approx(1e3 * contact.tangential_displacement(0.2).value, 1e-9));
  }
}

TEST_CASE("displacements are continuous where the sheet leaves the roller") {
  for (const Friction friction : {Friction::none, Friction::full}) {
    const auto contact = converged_for_load(table_nip, friction, 100, 1e-10);
    const double end = contact.contact_length().value / 2;
    const double above = end * (1 + 1e-9), below = end * (1 - 1e-9);
    CHECK(contact.normal_displacement(above).value == approx(contact.normal_displacement(below).value, 1e-7));
    CHECK(contact.tangential_displacement(above).value ==
          approx(contact.tangential_displacement(below).value, 1e-7));
    CHECK(contact.tangential_displacement(-above).value == -contact.tangential_displacement(above).value);
    CHECK(contact.creep_ratio().value * end == approx(contact.tangential_displacement(end).value, 1e-8));
  }
}

TEST_CASE("bad input to the converged contact is refused by name") {
  using data::BadInput;
  CHECK_THROWS_AS(converged_for_load({6, 0, {1, 0.3}}, Friction::none, 1, 1e-6), BadInput);
  CHECK_THROWS_AS(converged_for_load({6, 1, {1, 0.51}}, Friction::none, 1, 1e-6), BadInput);
  for (const double load : {-1.0, 0.0, std::nan(""), HUGE_VAL, 1e9}) {
    CHECK_THROWS_WITH_AS(converged_for_load({6, 1, {1, 0.3}}, Friction::full, load, 1e-6),
                         doctest::Contains("load"), BadInput);
  }
  for (const double length : {-1.0, 0.0, std::nan(""), 6.1, 1e-9}) {
    CHECK_THROWS_WITH_AS(converged_for_length({6, 1, {1, 0.3}}, Friction::full, length, 1e-6),
                         doctest::Contains("contact_length"), BadInput);
  }
  for (const double accuracy : {0.0, 1e-14, 0.5, std::nan("")}) {
    CHECK_THROWS_WITH_AS(converged_for_load(table_nip, Friction::none, 1, accuracy),
                         doctest::Contains("accuracy"), BadInput);
  }
  const auto contact = converged_for_load(table_nip, Friction::none, 100, 1e-6);
  CHECK_THROWS_WITH_AS(static_cast<void>(contact.pressure(std::nan(""))), doctest::Contains("y"), BadInput);
}
