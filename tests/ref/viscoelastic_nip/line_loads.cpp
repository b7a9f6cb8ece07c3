#include <doctest/doctest.h>

#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

using namespace nipref;

namespace {

data::ViscoelasticNip nip_of(const data::ViscoelasticMaterial& material) { return {6, 0.5, material, 1}; }

double error(const ref::Estimate& number) { return mpfr_get_d(ref::raw(number.error), MPFR_RNDU); }

double difference(const ref::Estimate& a, const ref::Estimate& b) {
  ref::Float both = ref::zero_of_bits(200);
  mpfr_sub(ref::raw(both), ref::raw(a.value), ref::raw(b.value), MPFR_RNDN);
  return std::fabs(mpfr_get_d(ref::raw(both), MPFR_RNDN));
}

void check_like_fast(const ref::ViscoelasticLineLoads& mine, const fast::ViscoelasticLineLoads& theirs,
                     double accuracy) {
  const auto near = [&](const ref::Estimate& a, double b) {
    return std::fabs(a.to_double() - b) <= accuracy * std::fabs(b);
  };
  CHECK(near(mine.contact_length(), theirs.contact_length()));
  CHECK(near(mine.indentation(), theirs.indentation));
  CHECK(near(mine.leading_displacement(), theirs.leading_displacement));
  CHECK(near(mine.trailing_displacement(), theirs.trailing_displacement));
  CHECK(near(mine.load(), theirs.load));
  CHECK(near(mine.peak_pressure(), theirs.peak_pressure));
  CHECK(near(mine.rolling_resistance(), theirs.rolling_resistance));
}

}  // namespace

TEST_CASE("ref rolling line loads are those in double, with exact kernels and with residue sums") {
  for (const int terms : {0, 60}) {
    const auto nip = nip_of(terms == 0 ? data::single_relaxation_time_solid(1e5, 3.75e4, 0.3)
                                       : data::misprinted_thesis_solid(1e5, 3.75e4, 0.3));
    const double length = 0.4;
    const auto mine = ref::ViscoelasticLineLoads::for_length(nip, {3, 2, 4.0, terms}, length, 16);
    const fast::ViscoelasticLineLoadMethod method{3, 2, 4.0, terms};
    const auto theirs = fast::viscoelastic_line_loads_for_length(nip, method, length * 3 / 5);
    check_like_fast(mine, theirs, 1e-11);
    CHECK(mine.creep_ratio().to_double() ==
          doctest::Approx(fast::creep_ratio(nip, theirs, method)).epsilon(1e-10));
    // Matching points, where the sheet is held to the roller, and an element.
    for (const double y : {0.24, 0.08, -0.16})
      CHECK(mine.normal_displacement(y).to_double() ==
            doctest::Approx(mine.indentation().to_double() - y * y / 12).epsilon(1e-13));
    CHECK(mine.pressure(0.1).to_double() ==
          doctest::Approx(fast::element_pressure(theirs, 0.1)).epsilon(1e-11));
    CHECK(mine.pressure(0.25).to_double() == 0);
  }
}

TEST_CASE("ref rolling line loads of a given load: fewer digits agree with more to their errors") {
  const auto nip = nip_of(data::single_relaxation_time_solid(1e5, 3.75e4, 0.3));
  const auto coarse = ref::ViscoelasticLineLoads::for_load(nip, {2, 1, 1.0, 0}, 50, 16);
  const auto fine = ref::ViscoelasticLineLoads::for_load(nip, {2, 1, 1.0, 0}, 50, 24);
  using Number = ref::Estimate (ref::ViscoelasticLineLoads::*)() const;
  for (const Number number :
       {&ref::ViscoelasticLineLoads::contact_length, &ref::ViscoelasticLineLoads::indentation,
        &ref::ViscoelasticLineLoads::load, &ref::ViscoelasticLineLoads::rolling_resistance}) {
    CHECK(difference((coarse.*number)(), (fine.*number)()) <= error((coarse.*number)()));
    CHECK(error((coarse.*number)()) <= 1e-16 * std::fabs((fine.*number)().to_double()));
  }
  CHECK(std::fabs(fine.load().to_double() - 50) <= 1e-14);
}

TEST_CASE("ref rolling line loads seek the thesis's number of trailing elements") {
  const auto nip = nip_of(data::misprinted_thesis_solid(1e5, 3.75e4, 0.3));
  const auto mine = ref::ViscoelasticLineLoads::for_load(nip, {4, {}, 4.0, 40}, 50, 16);
  const auto theirs = fast::viscoelastic_line_loads_by_search(nip, {4, 0, 4.0, 40}, 50);
  CHECK(mine.elements() == static_cast<int>(theirs.loads.size()));
  CHECK(mine.elements() < 8);
  check_like_fast(mine, theirs, 1e-9);
}

TEST_CASE("ref rolling line loads refuse what is out of their domain") {
  const auto nip = nip_of(data::single_relaxation_time_solid(1e5, 3.75e4, 0.3));
  using ref::ViscoelasticLineLoads;
  CHECK_THROWS_WITH_AS((void)ViscoelasticLineLoads::for_load(nip, {2, 1, 1.0, 0}, 50, 31),
                       doctest::Contains("digits = 31"), data::BadInput);
  CHECK_THROWS_WITH_AS((void)ViscoelasticLineLoads::for_load(nip, {0, 1, 1.0, 0}, 50, 16),
                       doctest::Contains("leading_elements = 0"), data::BadInput);
  CHECK_THROWS_WITH_AS((void)ViscoelasticLineLoads::for_load(nip, {2, 1, 0.0, 0}, 50, 16),
                       doctest::Contains("approach_lengths = 0"), data::BadInput);
  CHECK_THROWS_WITH_AS((void)ViscoelasticLineLoads::for_length(nip, {2, 1, 1.0, 0}, 7, 16),
                       doctest::Contains("contact_length = 7"), data::BadInput);
}
