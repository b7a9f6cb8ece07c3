// The continuous contact in multiprecision: against the double path, line loads and itself.
#include <doctest/doctest.h>

#include <cmath>

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
      const auto truth = ref::converged_for_load(here, load, 25);
      const auto computed = fast::converged_for_load(here, data::Friction::none, load, 1e-12);
      const auto agree = [](const ref::Estimated& exact, const fast::Estimate& estimate) {
        CHECK(relative_error(exact, estimate.value) < 1e-12);
        CHECK(std::fabs(exact.error_of(estimate.value)) <= estimate.error);
      };
      agree(truth.contact_length(), computed.contact_length());
      agree(truth.indentation(), computed.indentation());
      agree(truth.pressure(0), computed.pressure(0));
      agree(truth.edge_displacement(), computed.edge_displacement());
      CHECK(std::fabs(truth.load().error_of(load)) < 1e-24 * load);
    }
  }
}

TEST_CASE(
    "ref converged contact: more digits stay within the estimate, and the pressure is symmetric and ends") {
  const auto coarse = ref::converged_for_length(quarter_inch_nip, 0.2, 18);
  const auto fine = ref::converged_for_length(quarter_inch_nip, 0.2, 40);
  CHECK(difference(coarse.load(), fine.load()) <= error(coarse.load()));
  CHECK(difference(coarse.indentation(), fine.indentation()) <= error(coarse.indentation()));
  CHECK(difference(coarse.pressure(0.05), fine.pressure(-0.05)) <= error(coarse.pressure(0.05)));
  CHECK(fine.terms() > coarse.terms());
  CHECK(fine.pressure(0.1).to_double() == 0);
  // Line loads approach it: their distance halves with the elements.
  const auto excess = [&](int m) {
    return ref::line_loads_for_length(quarter_inch_nip, m, 0.2, 16).load.to_double() /
               fine.load().to_double() -
           1;
  };
  CHECK(std::fabs(excess(40)) < 0.6 * std::fabs(excess(20)));
}

TEST_CASE("ref converged contact refuses bad input by name") {
  using data::BadInput;
  CHECK_THROWS_WITH_AS(ref::converged_for_length(quarter_inch_nip, 7, 30),
                       doctest::Contains("contact_length"), BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, -1, 30), doctest::Contains("load"),
                       BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, 1e7, 30), doctest::Contains("load"),
                       BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, 1, 101), doctest::Contains("digits"),
                       BadInput);
  // Too small and too large for a double once they are made dimensionless.
  CHECK_THROWS_WITH_AS(ref::converged_for_load(quarter_inch_nip, 5e-324, 30), doctest::Contains("load = "),
                       BadInput);
  CHECK_THROWS_WITH_AS(ref::converged_for_load({6, 0.25, {1e-60, 0.3}}, 1e308, 30),
                       doctest::Contains("load = "), BadInput);
}
