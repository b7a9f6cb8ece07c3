// The rolling contact in multiprecision: against the elastic contact's proof, its limits, the double path and itself;
// against the energy that the sheet loses in tests/verify/solve/energy_balance.cpp.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>

#include "support/softening_sheet.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using data::ViscoelasticNip;

namespace {

/// Relaxation lengths `way` and three times that, the compliances grow by `growth` of themselves.
ViscoelasticNip rolled_nip(double thickness, double way, double growth) {
  const data::MaterialFunction theta1{9e-6, {{9e-6 * growth / way, 1 / way}}};
  const data::MaterialFunction theta2{3e-6, {{1e-6 * growth / way, 1 / (3 * way)}}};
  return {6, thickness, data::ViscoelasticMaterial(theta1, theta2), 1};
}

/// The same, and a pair of conjugate rates whose imaginary part is `swing` times the real one.
ViscoelasticNip swinging_nip(double thickness, double way, double swing) {
  const auto function = [&](double compliance) -> data::MaterialFunction {
    const std::complex<double> amplitude{compliance * 0.1 / way, -compliance * 0.05 / way};
    const std::complex<double> rate{1 / way, swing / way};
    return {
        compliance,
        {{compliance * 0.2 / way, 0.5 / way}, {amplitude, rate}, {std::conj(amplitude), std::conj(rate)}}};
  };
  return {6, thickness, data::ViscoelasticMaterial(function(9e-6), function(3e-6)), 1};
}

/// A number of each contact.
struct RollingResult {
  const char* name;
  std::function<ref::Estimate(const ref::ConvergedNip&)> reference;
  std::function<fast::Estimate(const fast::ConvergedNip&)> computed;
};

/// Numbers, and profiles at these places.
std::vector<RollingResult> rolling_results(const std::vector<double>& places) {
  using Ref = ref::ConvergedNip;
  using Fast = fast::ConvergedNip;
  std::vector<RollingResult> results{
      {"contact_length", &Ref::contact_length, &Fast::contact_length},
      {"leading_length", &Ref::leading_length, &Fast::leading_length},
      {"trailing_length", &Ref::trailing_length, &Fast::trailing_length},
      {"load", &Ref::load, &Fast::load},
      {"indentation", &Ref::indentation, &Fast::indentation},
      {"leading_displacement", &Ref::leading_displacement, &Fast::leading_displacement},
      {"trailing_displacement", &Ref::trailing_displacement, &Fast::trailing_displacement},
      {"rolling_resistance", &Ref::rolling_resistance, &Fast::rolling_resistance},
      {"creep_ratio", &Ref::creep_ratio, &Fast::creep_ratio},
      {"peak_pressure", &Ref::peak_pressure, &Fast::peak_pressure},
  };
  for (const double y : places) {
    results.push_back({"pressure", [y](const Ref& c) { return c.pressure(y); },
                       [y](const Fast& c) { return c.pressure(y); }});
    results.push_back({"normal_displacement", [y](const Ref& c) { return c.normal_displacement(y); },
                       [y](const Fast& c) { return c.normal_displacement(y); }});
    results.push_back({"tangential_displacement", [y](const Ref& c) { return c.tangential_displacement(y); },
                       [y](const Fast& c) { return c.tangential_displacement(y); }});
  }
  return results;
}

void check_covered(const ref::ConvergedNip& truth, const fast::ConvergedNip& computed,
                   double length) {
  for (const auto& [name, reference, in_double] :
       rolling_results({-0.7 * length, -0.2 * length, 0.3 * length})) {
    CAPTURE(name);
    const ref::Estimate exact = reference(truth);
    const fast::Estimate estimate = in_double(computed);
    CAPTURE(exact.value_text());
    CAPTURE(estimate.value);
    CHECK(std::fabs(exact.error_of(estimate.value)) <= estimate.error);
  }
}

void check_rolling_refused(const std::function<void()>& solve, const std::string& start) {
  CAPTURE(start);
  try {
    solve();
    FAIL("accepted");
  } catch (const data::BadInput& error) {
    CAPTURE(error.what());
    CHECK(std::string(error.what()).starts_with(start));
  }
}

}  // namespace

TEST_CASE("ref rolling contact: without memory it is the proven elastic contact, in every result") {
  const data::ElasticNip elastic = test::quarter_inch_nip;
  const ViscoelasticNip nip{elastic.roller_radius, elastic.sheet_thickness,
                            data::elastic_solid(elastic.material), 1};
  const auto rolled = ref::converged_for_length(nip, 0.15, 20);
  const auto proven = ref::converged_for_length(elastic, data::Friction::none, 0.15, 30);
  const auto same = [](const char* name, const ref::Estimate& mine, const ref::Estimate& theirs) {
    CAPTURE(name);
    ref::Float difference = ref::zero_of_bits(200);
    mpfr_sub(ref::raw(difference), ref::raw(mine.value), ref::raw(theirs.value), MPFR_RNDN);
    CHECK(mpfr_cmpabs(ref::raw(difference), ref::raw(mine.error)) <= 0);
  };
  same("load", rolled.load(), proven.load());
  same("indentation", rolled.indentation(), proven.indentation());
  same("edge_displacement", rolled.leading_displacement(), proven.leading_displacement());
  same("creep_ratio", rolled.creep_ratio(), proven.creep_ratio());
  same("peak_pressure", rolled.peak_pressure(), proven.peak_pressure());
  for (const double y : {-0.2, -0.05, 0.03, 0.075, 0.2}) {
    CAPTURE(y);
    same("normal_displacement", rolled.normal_displacement(y), proven.normal_displacement(y));
    same("tangential_displacement", rolled.tangential_displacement(y), proven.tangential_displacement(y));
  }
  CHECK(std::fabs(rolled.rolling_resistance().to_double()) <= 1e-20);
}

TEST_CASE("ref rolling contact: without memory a long one is the thin sheet's") {
  const data::ElasticNip elastic{2000, 1, {1, 0.3}};
  const double length = 30;
  const auto rolled = ref::converged_for_length(
      {elastic.roller_radius, 1, data::elastic_solid(elastic.material), 1}, length, 18);
  const auto thin = ref::converged_for_length(elastic, data::Friction::none, length, 19, 0);
  const auto same = [](const ref::Estimate& mine, const ref::Estimate& theirs) {
    CAPTURE(mine.value_text());
    ref::Float difference = ref::zero_of_bits(200);
    mpfr_sub(ref::raw(difference), ref::raw(mine.value), ref::raw(theirs.value), MPFR_RNDN);
    CHECK(mpfr_cmpabs(ref::raw(difference), ref::raw(mine.error)) <= 0);
    CHECK(mpfr_cmpabs(ref::raw(theirs.error), ref::raw(mine.error)) <= 0);
  };
  same(rolled.load(), thin.load());
  same(rolled.indentation(), thin.indentation());
  same(rolled.creep_ratio(), thin.creep_ratio());
}

TEST_CASE(
    "ref rolling contact: the shortest and long ones, memories far shorter than they, are covered in double") {
  struct Case {
    double length, way, growth;
  };
  for (const auto& [length, way, growth] : {Case{1e-6, 1e-9, 1}, {20, 2, 30}}) {
    CAPTURE(length);
    ViscoelasticNip nip = rolled_nip(1, way, growth);
    nip.roller_radius = 1000;
    check_covered(ref::converged_for_length(nip, length, 16), fast::converged_for_length(nip, length, 1e-10),
                  length);
  }
}

TEST_CASE("ref rolling contact: a memory that fades slowly is none") {
  const double length = 0.1, way = 1e6;
  const auto slow = ref::converged_for_length(test::nip(way), length, 16);
  const auto proven = ref::converged_for_length(test::elastic(1), data::Friction::none, length, 16);
  // To first order in the contact over the way.
  const double near = 5 * length / way;
  CHECK(std::fabs(proven.load().error_of(slow.load().to_double())) <= near * proven.load().to_double());
  CHECK(std::fabs(proven.creep_ratio().error_of(slow.creep_ratio().to_double())) <=
        near * length / test::radius);
}

TEST_CASE("ref rolling contact: a pair of conjugate rates is covered in double, and tends to two real ones") {
  const double length = 0.1, way = 0.2, small = 1e-9;
  const ViscoelasticNip nip = swinging_nip(0.25, way, 1.5);
  check_covered(ref::converged_for_length(nip, length, 16), fast::converged_for_length(nip, length, 1e-10),
                length);
  const auto swung = ref::converged_for_length(swinging_nip(0.25, way, small), length, 16);
  const auto still = [&](double compliance) -> data::MaterialFunction {
    return {compliance, {{compliance * 0.2 / way, 0.5 / way}, {compliance * 0.2 / way, 1 / way}}};
  };
  const ViscoelasticNip real{6, 0.25, data::ViscoelasticMaterial(still(9e-6), still(3e-6)), 1};
  const auto merged = ref::converged_for_length(real, length, 16);
  CHECK(swung.load().to_double() == doctest::Approx(merged.load().to_double()).epsilon(1e-8).scale(0));
  CHECK(swung.creep_ratio().to_double() ==
        doctest::Approx(merged.creep_ratio().to_double()).epsilon(1e-8).scale(0));
}

TEST_CASE("ref rolling contact: the double path's estimates cover what they are off by at random nips") {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>()(random));
  };
  for (int i = 0; i < 6; ++i) {
    const double length = between(1e-3, 0.2);
    const ViscoelasticNip nip = rolled_nip(0.25, length * between(0.3, 1e5), between(0.1, 10));
    CAPTURE(length);
    const auto truth = ref::converged_for_length(nip, length, 16);
    check_covered(truth, fast::converged_for_length(nip, length, 1e-10), length);
  }
}

TEST_CASE("ref rolling contact: fluids, and theta2 with nothing at once, are covered in double") {
  const double length = 0.1;
  // Shear flows within a way of 0.1 or 0.01 by as much as it gives way at once, or not at all; K is constant,
  // flows as well, or is a spring beside a dashpot.
  const auto rolled = [&](const data::DifferentialOperators& operators) -> ViscoelasticNip {
    return {6, 0.25, data::operator_solid(operators), 1};
  };
  const std::vector<double> p{6e4, 6e3}, q{0, 3.6e8};
  for (const ViscoelasticNip& nip :
       {rolled({p, q, {1}, {1.4e5}}), rolled({{6e4, 600}, {0, 3.6e7}, {7e4, 1.4e5}, {0, 1.4e10}}),
        rolled({{1}, {6e4}, {1}, {1.4e5, 3e3}})}) {
    const auto truth = ref::converged_for_length(nip, length, 16);
    const auto computed = fast::converged_for_length(nip, length, 1e-10);
    check_covered(truth, computed, length);
    CHECK(computed.load().error <= 1e-10 * computed.load().value);
    CHECK(computed.indentation().error <= 1e-10 * computed.indentation().value);
  }
}

TEST_CASE("ref rolling contact: the length that a load needs gives it back, and more digits are covered") {
  const ViscoelasticNip nip = rolled_nip(0.25, 0.1, 2);
  const auto coarse = ref::converged_for_load(nip, 60, 16);
  CHECK(std::fabs(coarse.load().error_of(60)) <= 60e-16);
  const double length = coarse.contact_length().to_double();
  check_covered(coarse, fast::converged_for_load(nip, 60, 1e-10), length);
  const auto near = ref::converged_for_length(nip, 0.1, 16), fine = ref::converged_for_length(nip, 0.1, 25);
  for (const auto& result : rolling_results({-0.07, -0.02, 0.03})) {
    CAPTURE(result.name);
    const ref::Estimate first = result.reference(near), second = result.reference(fine);
    ref::Float difference = ref::zero_of_bits(200);
    mpfr_sub(ref::raw(difference), ref::raw(first.value), ref::raw(second.value), MPFR_RNDN);
    CHECK(mpfr_cmpabs(ref::raw(difference), ref::raw(first.error)) <= 0);
    CHECK(mpfr_cmpabs(ref::raw(second.error), ref::raw(first.error)) <= 0);
  }
  CHECK(fine.unknowns() > near.unknowns());
  CHECK(fine.normal_values() > 0);
}

TEST_CASE("ref rolling contact: the strain is as sure next to the ends as elsewhere") {
  const double length = 0.1, digits = 16;
  for (const ViscoelasticNip& nip : {rolled_nip(0.25, 0.1, 2), swinging_nip(0.25, 0.2, 1.5)}) {
    const auto truth = ref::converged_for_length(nip, length, static_cast<int>(digits));
    const auto computed = fast::converged_for_length(nip, length, 1e-12);
    const double leading = truth.leading_length().to_double(), trailing = truth.trailing_length().to_double();
    for (const double beyond : {1e-14, 1e-8, 1e-3, 1.0}) {
      for (const double y : {leading + beyond * length, -trailing - beyond * length}) {
        CAPTURE(y);
        const ref::Estimate strain = truth.surface_strain(y);
        const fast::Estimate found = computed.surface_strain(y);
        const double error = mpfr_get_d(ref::raw(strain.error), MPFR_RNDU);
        CHECK(error <= std::pow(10, -digits) * length / nip.roller_radius);
        CHECK(std::fabs(strain.error_of(found.value)) <= found.error + error);
      }
    }
  }
}

TEST_CASE("ref rolling contact: what it cannot give is refused by name") {
  const ViscoelasticNip nip = rolled_nip(0.25, 0.1, 2);
  check_rolling_refused([&] { (void)ref::converged_for_length(nip, 0.1, 15); }, "digits = 15: ");
  check_rolling_refused([&] { (void)ref::converged_for_length(nip, 7, 16); }, "contact_length = 7: ");
  check_rolling_refused([&] { (void)ref::converged_for_load(nip, -1, 16); }, "load = -1: ");
  check_rolling_refused([&] { (void)ref::converged_for_load(nip, 1e9, 16); }, "load = 1000000000: gives");
  check_rolling_refused([] { (void)ref::converged_for_length(rolled_nip(0.25, 1e-11, 1), 0.1, 16); },
                        "nip.material = ");
  const data::ViscoelasticMaterial ringing = data::operator_solid({{200, 1, 1}, {100, 1, 1}, {1}, {10}});
  check_rolling_refused(
      [&] {
        (void)ref::converged_for_length({6, 0.25, ringing, 1}, 0.1, 16);
      },
      "nip.material = 19.97");
  check_rolling_refused(
      [] {
        ViscoelasticNip thin = rolled_nip(0.0002, 0.1, 1);
        (void)ref::converged_for_length(thin, 0.02, 16).greatest_shear();
      },
      "contact_length = 0.02");
}
