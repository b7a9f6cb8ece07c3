#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

#include "support/intervals.hpp"
#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

data::ViscoelasticNip nip_of(const data::ViscoelasticMaterial& material) { return {6, 0.5, material, 1}; }

void check_like_fast(const ref::LineLoadNip& mine, const fast::LineLoadNip& theirs, double accuracy) {
  const auto near = [&](const ref::Estimate& a, double b) {
    return std::fabs(a.to_double() - b) <= accuracy * std::fabs(b);
  };
  CHECK(near(mine.contact_length(), theirs.contact_length()));
  CHECK(near(mine.indentation(), theirs.indentation));
  CHECK(near(mine.leading_displacement(), theirs.leading_displacement()));
  CHECK(near(mine.trailing_displacement(), theirs.trailing_displacement()));
  CHECK(near(mine.load(), theirs.load()));
  CHECK(near(mine.peak_pressure(), theirs.peak_pressure()));
  CHECK(near(mine.rolling_resistance(), theirs.rolling_resistance()));
  CHECK(near(mine.creep_ratio(), theirs.creep_ratio()));
}

}  // namespace

TEST_CASE("ref rolling line loads of random nips: fewer digits enclose more digits, and what double gives") {
  constexpr int nips = 3;  // 200 pass as well
  std::mt19937_64 random(1);
  const auto count = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  for (int i = 1; i <= nips; ++i) {
    const double tau = between(1e-2, 1e2, random), load = between(1, 300, random);
    const auto material =
        i % 3 == 0
            ? data::standard_linear_solid({1e5, between(2e4, 2e5, random), 2e5, 1e5, 1e5 * tau, 2e5 * tau})
            : data::single_relaxation_time_solid(1e5, 3.75e4, tau, i % 3);
    const data::ViscoelasticNip nip{6, between(0.05, 2, random), material, 1};
    const int terms = i % 4 == 3 ? count(1, 60) : 0, leading = count(1, 3), trailing = count(1, leading);
    const double approach = between(0.1, 20, random);
    CAPTURE(i);
    const auto coarse = ref::line_loads_for_load(nip, {leading, trailing, approach, terms}, load, 16);
    const auto fine = ref::line_loads_for_load(nip, {leading, trailing, approach, terms}, load, 20);
    const auto check = [&](const ref::Enclosure& a, const ref::Enclosure& b) {
      CHECK(a.proven);
      CHECK(meet(a, b));
      CHECK(error(a) <= 1e-13 * std::fabs(a.to_double()));
    };
    using ref::LineLoadNip;
    using Number = ref::Enclosure (LineLoadNip::*)() const;
    for (const Number number :
         {&LineLoadNip::contact_length, &LineLoadNip::indentation, &LineLoadNip::load,
          &LineLoadNip::rolling_resistance, &LineLoadNip::creep_ratio, &LineLoadNip::peak_pressure})
      check((coarse.*number)(), (fine.*number)());
    CHECK(difference(coarse.load(), ref::exactly(load, 16)) <= error(coarse.load()));
    const double y = 0.3 * coarse.contact_length().to_double();
    check(coarse.normal_displacement(y), fine.normal_displacement(y));
    check(coarse.tangential_displacement(y), fine.tangential_displacement(y));
    check_like_fast(coarse, fast::line_loads_for_load(nip, {leading, trailing, approach, terms}, load), 1e-8);
  }
}

TEST_CASE("ref rolling line loads: a contact 1e-5 of its approach long is what double gives") {
  const data::ViscoelasticNip nip = nip_of(data::single_relaxation_time_solid(1e5, 3.75e4, 0.3, 2));
  constexpr double length = 3e-5;
  const auto mine = ref::line_loads_for_length(nip, {2, 1, 12}, length, 16);
  check_like_fast(mine, fast::line_loads_for_length(nip, {2, 1, 12}, length * 2 / 3), 1e-10);
}

TEST_CASE("ref rolling line loads: an error of 1e-25 in a memory or a length is outside, or widens") {
  const auto problem_of = [](const mpq_class& memory, const mpq_class& unknown) {
    const ref::ExactMaterial material{{1, {{memory, memory}}, {}}, {mpq_class(1, 3), {}, {}}};
    const data::ViscoelasticNip nip = nip_of(data::single_relaxation_time_solid(1e5, 3.75e4, 0.3));
    return ref::RollingLoads{
        nip, {material, ref::Exact(nip.speed), ref::Exact(nip.half_thickness())}, unknown, 3, 2, 4, 40};
  };
  const ref::WorkingDigits scope(46);
  const mpq_class tiny("1/10000000000000000000000000"), memory(2, 3), width(1, 10);
  const auto solved = [&](const mpq_class& of_memory, const mpq_class& unknown, const mpq_class& element,
                          const mpq_class& spread) {
    auto contact = ref::solve_loads(problem_of(of_memory, unknown), {element, spread});
    // The indentation divided by the instantaneous compliance, 4/3, has the unit of the loads.
    contact->normal.push_back(3L * contact->indentation / 4L);
    return contact->normal;
  };
  const auto moved = [](const ref::Interval& a, const ref::Interval& b) {
    return mpfi_get_d(ref::distance_from(ref::middle_of(a), b).get());
  };
  const auto truth = solved(memory, 0, width, 0);
  const auto check = [&](const std::vector<ref::Interval>& other, const std::vector<ref::Interval>& all) {
    double largest_move = 0, largest_width = 0;
    for (std::size_t j = 0; j < truth.size(); ++j) {
      CHECK(!is_inside(other[j], truth[j]));
      CHECK(is_inside(truth[j], all[j]));
      CHECK(is_inside(other[j], all[j]));
      largest_move = std::max(largest_move, moved(truth[j], other[j]));
      largest_width = std::max(largest_width, width_of(all[j]) / 2);
    }
    CHECK(largest_width < 1e3 * largest_move);
  };
  check(solved(memory * (1 + tiny), 0, width, 0), solved(memory, tiny, width, 0));
  check(solved(memory, 0, width + tiny, 0), solved(memory, 0, width, tiny));
}

TEST_CASE("ref rolling line loads seek the thesis's number of trailing elements") {
  const auto nip = nip_of(data::single_relaxation_time_solid(1e5, 3.75e4, 0.3, data::misprinted_rate_factor));
  const auto mine = ref::line_loads_for_load(nip, {4, {}, 4.0, 40}, 50, 16);
  const auto theirs = fast::line_loads_for_load(nip, {4, {}, 4.0, 40}, 50);
  CHECK(mine.face_loads().size() == theirs.loads.size());
  CHECK(mine.face_loads().size() < 8);
  check_like_fast(mine, theirs, 1e-9);
}

TEST_CASE("ref rolling line loads refuse what is out of their domain") {
  const auto nip = nip_of(data::single_relaxation_time_solid(1e5, 3.75e4, 0.3));
  CHECK_REFUSED(ref::line_loads_for_load(nip, {2, 1, 1.0, 0}, 50, 31), "digits = 31");
  CHECK_REFUSED(ref::line_loads_for_load(nip, {0, 1, 1.0, 0}, 50, 16), "leading_elements = 0");
  CHECK_REFUSED(ref::line_loads_for_load(nip, {2, 1, 0.0, 0}, 50, 16), "approach_lengths = 0");
  CHECK_REFUSED(ref::line_loads_for_length(nip, {2, 1, 1.0, 0}, 7, 16), "contact_length = 7");
}
