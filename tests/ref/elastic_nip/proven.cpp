// The continuous contact in multiprecision: against the double path, line loads and itself.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>

#include "support/reference_values.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using data::ElasticNip;
using test::quarter_inch_nip;

TEST_CASE("ref converged contact: the double path agrees to 1e-12, its estimates cover the difference") {
  for (const double thickness : {1.0, 0.0625}) {
    for (const double load : {25.0, 200.0}) {
      const ElasticNip here = nipref::data::seed::nip(thickness);
      const auto truth = ref::converged_for_load(here, data::Friction::none, load, 25);
      const auto computed = fast::converged_for_load(here, data::Friction::none, load, 1e-12);
      const auto agree = [](const ref::Estimate& exact, const fast::Estimate& estimate) {
        CHECK(relative_error(exact, estimate.value) < 1e-12);
        CHECK(std::fabs(exact.error_of(estimate.value)) <= estimate.error);
      };
      agree(truth.contact_length(), computed.contact_length());
      agree(truth.indentation(), computed.indentation());
      agree(truth.pressure(0), computed.pressure(0));
      agree(truth.leading_displacement(), computed.leading_displacement());
      CHECK(std::fabs(truth.load().error_of(load)) < 1e-24 * load);
    }
  }
}

TEST_CASE(
    "ref converged contact: more digits stay within the bound, and the pressure is symmetric and ends") {
  const auto coarse = ref::converged_for_length(quarter_inch_nip, data::Friction::none, 0.2, 18);
  const auto fine = ref::converged_for_length(quarter_inch_nip, data::Friction::none, 0.2, 40);
  CHECK(difference(coarse.pressure(0.05), fine.pressure(-0.05)) <= error(coarse.pressure(0.05)));
  CHECK(difference(coarse.tangential_displacement(-0.05), fine.tangential_displacement(-0.05)) <=
        error(coarse.tangential_displacement(0.05)));
  CHECK(fine.tangential_displacement(0.2).to_double() == -fine.tangential_displacement(-0.2).to_double());
  CHECK(fine.unknowns() > coarse.unknowns());
  CHECK(fine.coupling_values() > 0);
  CHECK(ref::converged_for_length(quarter_inch_nip, data::Friction::none, 0.2, 18).coupling_values() == 0);
  CHECK(error(fine.pressure(0.1)) == 0);
  CHECK(fine.pressure(0.1).to_double() == 0);
  CHECK(fine.pressure(0x1.9999999999999p-4).to_double() > 0);
  // Line loads approach it: their distance halves with the elements.
  const auto excess = [&](int m) {
    return ref::line_loads_for_length(quarter_inch_nip, m, 0.2, 16).load.to_double() /
               fine.load().to_double() -
           1;
  };
  CHECK(std::fabs(excess(40)) < 0.6 * std::fabs(excess(20)));
}

namespace {

struct ContactResult {
  const char* name;
  std::function<ref::Estimate(const ref::ConvergedNip&)> proven;
  std::function<fast::Estimate(const fast::ConvergedNip&)> estimated;
};

/// At places inside and outside of a contact of half length A half-thicknesses b.
std::vector<ContactResult> contact_results(double b, double A) {
  std::vector<ContactResult> results{
      {"contact_length", &ref::ConvergedNip::contact_length, &fast::ConvergedNip::contact_length},
      {"load", &ref::ConvergedNip::load, &fast::ConvergedNip::load},
      {"indentation", &ref::ConvergedNip::indentation, &fast::ConvergedNip::indentation},
      {"edge_displacement", &ref::ConvergedNip::leading_displacement,
       &fast::ConvergedNip::leading_displacement},
      {"creep_ratio", &ref::ConvergedNip::creep_ratio, &fast::ConvergedNip::creep_ratio},
      {"peak_pressure", &ref::ConvergedNip::peak_pressure, &fast::ConvergedNip::peak_pressure},
  };
  for (const double t : {0.25, 0.875}) {
    results.push_back({"pressure", [=](const auto& contact) { return contact.pressure(t * A * b); },
                       [=](const auto& contact) { return contact.pressure(t * A * b); }});
  }
  for (const double t : {0.5, 1.0, 1.125, 2.5}) {
    results.push_back({"normal_displacement",
                       [=](const auto& contact) { return contact.normal_displacement(t * A * b); },
                       [=](const auto& contact) { return contact.normal_displacement(t * A * b); }});
    results.push_back({"tangential_displacement",
                       [=](const auto& contact) { return contact.tangential_displacement(t * A * b); },
                       [=](const auto& contact) { return contact.tangential_displacement(t * A * b); }});
  }
  return results;
}

}  // namespace

TEST_CASE(
    "ref converged contact: bounds of 20, 30 and 40 digits meet, keep the digits and lie within fast's") {
  const ElasticNip nip{1000, 2, {3, 0.2}};
  for (const double A : {1e-8, 1e-6, 1e-3, 0.1, 0.5, 1.0, 3.0}) {
    CAPTURE(A);
    const auto twenty = ref::converged_for_length(nip, data::Friction::none, 2 * A, 20);
    const auto thirty = ref::converged_for_length(nip, data::Friction::none, 2 * A, 30);
    const auto forty = ref::converged_for_length(nip, data::Friction::none, 2 * A, 40);
    const auto computed = fast::converged_for_length(nip, data::Friction::none, 2 * A, 1e-10);
    const double largest_displacement = thirty.indentation().to_double();
    for (const ContactResult& result : contact_results(1, A)) {
      CAPTURE(result.name);
      const ref::Estimate truth = result.proven(thirty);
      const bool displacement = std::string_view(result.name).ends_with("displacement");
      const double size =
          displacement ? largest_displacement * std::fmax(A, 1) : std::fabs(truth.to_double());
      CHECK(error(truth) <= 1e-30 * size);
      CHECK(error(result.proven(forty)) <= 1e-40 * size);
      CHECK(difference(result.proven(twenty), truth) <= error(result.proven(twenty)) + error(truth));
      CHECK(difference(truth, result.proven(forty)) <= error(truth) + error(result.proven(forty)));
      const fast::Estimate estimate = result.estimated(computed);
      CHECK(std::fabs(truth.error_of(estimate.value)) <= estimate.error + 1e-15 * size);
    }
  }
}

TEST_CASE("ref converged contact: lengths, moduli and loads scale as they must") {
  const ElasticNip nip{6, 0.25, {1.45e5, 0.25}};
  const auto contact = ref::converged_for_length(nip, data::Friction::none, 0.25, 25);
  // Factors and products are exact in double.
  const auto stiffer =
      ref::converged_for_length({6, 0.25, {3 * 1.45e5, 0.25}}, data::Friction::none, 0.25, 25);
  const auto larger = ref::converged_for_length({30, 1.25, {1.45e5, 0.25}}, data::Friction::none, 1.25, 25);
  const auto ratio = [](const ref::Estimate& x, const ref::Estimate& y, double factor) {
    ref::Estimate multiple = y;
    mpfr_mul_d(ref::raw(multiple.value), ref::raw(y.value), factor, MPFR_RNDN);
    CHECK(difference(x, multiple) <= 1.01 * (error(x) + factor * error(y)));
  };
  ratio(stiffer.load(), contact.load(), 3);
  ratio(stiffer.pressure(0.0625), contact.pressure(0.0625), 3);
  ratio(stiffer.indentation(), contact.indentation(), 1);
  ratio(larger.load(), contact.load(), 5);
  ratio(larger.pressure(5 * 0.0625), contact.pressure(0.0625), 1);
  ratio(larger.leading_displacement(), contact.leading_displacement(), 5);
  ratio(larger.normal_displacement(5 * 0.1875), contact.normal_displacement(0.1875), 5);
  ratio(larger.creep_ratio(), contact.creep_ratio(), 1);
}

TEST_CASE("ref converged contact: the length of a load is that whose load it is") {
  for (const double A : {0.001, 0.25, 3.0}) {
    CAPTURE(A);
    const ElasticNip nip{1000, 2, {3, 0.2}};
    const auto there = ref::converged_for_length(nip, data::Friction::none, 2 * A, 30);
    const double load = there.load().to_double();
    const auto back = ref::converged_for_load(nip, data::Friction::none, load, 30);
    CHECK(std::fabs(back.load().error_of(load)) <= error(back.load()));
    CHECK(error(back.contact_length()) <= 1e-30 * 2 * A);
    // ln W grows 2 to 3 times as fast as ln L.
    const double of_load = -there.load().error_of(load) / load;
    const double of_length = -back.contact_length().error_of(2 * A) / (2 * A);
    CHECK(of_load * of_length < 0);
    CHECK(std::fabs(of_length) <= std::fabs(of_load) / 2 + 1e-30);
    CHECK(std::fabs(of_length) >= std::fabs(of_load) / 3 - 1e-30);
  }
}

TEST_CASE("ref converged contact: outside the displacement goes on from what it is inside") {
  const auto contact = ref::converged_for_length({1000, 2, {3, 0.2}}, data::Friction::none, 2, 25);
  const ref::Estimate end = contact.leading_displacement();
  CHECK(difference(contact.normal_displacement(1), end) <=
        error(end) + error(contact.normal_displacement(1)));
  // u' = -2y/(2R) there, and u'' is infinite as the root of the distance.
  const double step = 0x1p-40;
  const double slope = difference(contact.normal_displacement(1 + step), end) / step;
  CHECK(slope == doctest::Approx(1 / 1000.0).epsilon(1e-5));
}

TEST_CASE("ref converged contact refuses bad input by name") {
  using data::BadInput;
  CHECK_THROWS_WITH_AS(ref::converged_for_length(quarter_inch_nip, data::Friction::none, 7, 30),
                       doctest::Contains("contact_length"), BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, data::Friction::none, -1, 30),
                       doctest::Contains("load"), BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, data::Friction::none, 1e7, 30),
                       doctest::Contains("load"), BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, data::Friction::none, 1, 101),
                       doctest::Contains("digits"), BadInput);
  // More than the proof's terms give.
  CHECK(ref::proven_terms({1000, 2, {1, 0.3}}, data::Friction::none, 150, 60) == 0);
  const auto contact = ref::converged_for_length(quarter_inch_nip, data::Friction::none, 0.2, 16);
  CHECK_THROWS_WITH_AS((void)contact.normal_displacement(113), doctest::Contains("y = 113"), BadInput);
  CHECK_THROWS_WITH_AS((void)contact.tangential_displacement(NAN), doctest::Contains("y = nan"), BadInput);
  CHECK_THROWS_WITH_AS((void)contact.pressure(NAN), doctest::Contains("y = nan"), BadInput);
  CHECK(contact.pressure(1e300).to_double() == 0);
  // Too small and too large for a double once they are made dimensionless.
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, data::Friction::none, 5e-324, 30),
                       doctest::Contains("load = "), BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load({6, 0.25, {1e-60, 0.3}}, data::Friction::none, 1e308, 30),
                       doctest::Contains("load = "), BadInput);
}
