#include <nipref/fast/elastic_nip/line_loads.hpp>

#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using fast::LineLoadNip;
using fast::LoadSearch;
using fast::Work;
using namespace nipref::test;

using Counts = std::array<std::uint64_t, 7>;

TEST_CASE("a load is carried by the shortest length that carries it, however wide its elements are") {
  // As half an element approaches about 1.24 half-thicknesses, where the kernel changes its sign, the loads grow
  // without bound. Wider elements have meaningless loads, which may be as large.
  const data::ElasticNip film{6, 0.01, {1.45e5, 1.0 / 3}};
  for (const int m : {1, 3, 9}) {
    for (const double half_element : {0.3, 1.0, 1.1, 1.2, 1.23}) {
      CAPTURE(m, half_element);
      const LineLoadNip wanted =
          fast::line_loads_for_length(film, m, 4 * m * half_element * film.half_thickness());
      REQUIRE(wanted.load() > 0);
      const LineLoadNip found = fast::line_loads_for_load(film, m, wanted.load());
      CHECK(found.contact_length() == approx(wanted.contact_length(), 1e-10));
    }
  }
}

TEST_CASE("inside the sheet, on the line through the centres, the shear of line loads is exactly 0") {
  const fast::InnerPoint points[] = {{0, 0.3}, {0, -0.7}, {0.01, 0.3}};
  for (const data::LineLoadFriction& friction : {data::LineLoadFriction{}, full_friction(1e-3)}) {
    const LineLoadNip solution = fast::line_loads_for_length(thick_nip, 7, 0.1, friction);
    const auto stresses = fast::line_load_stresses(solution.loads, thick_nip.half_thickness(), points);
    CHECK(stresses[0].shear.value == 0);
    CHECK(stresses[1].shear.value == 0);
    CHECK(stresses[2].shear.value != 0);
  }
}

TEST_CASE("length for a load and load for a length are inverse, over twelve decades of load") {
  for (double length = 1e-6; length < 2; length *= 10) {
    // The creep of a thick nip is proportional to its length.
    for (const data::LineLoadFriction& friction : {data::LineLoadFriction{}, full_friction(-1e-2 * length)}) {
      CAPTURE(length);
      const LineLoadNip solution = fast::line_loads_for_length(thick_nip, 4, length, friction);
      const LineLoadNip again = fast::line_loads_for_load(thick_nip, 4, solution.load(), friction);
      CHECK(again.load() == approx(solution.load(), 1e-12));
      CHECK(again.contact_length() == approx(length, 1e-9));
    }
  }
}

TEST_CASE("without friction and creep nothing but I1 is evaluated, 2m values a solve") {
  const auto solution = fast::line_loads_for_length(quarter_inch_nip, 7, 0.1);
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 0, 0, 0, 0, 0});
  CHECK(solution.work().systems == 1);
  CHECK(solution.work().unknowns == 8);
  // The creep needs I3 at the loads, and a normal displacement needs I1 at the loads.
  (void)solution.creep_ratio();
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 14, 0, 0, 0, 0});
  (void)solution.normal_displacement(0.2);
  CHECK(solution.work().kernel_evaluations == Counts{28, 0, 14, 0, 0, 0, 0});
  CHECK(solution.work().systems == 1);
}

TEST_CASE("a search for the load counts every solve of it, and evaluates I1 only") {
  const Work fast_work = fast::line_loads_for_load(quarter_inch_nip, 7, 100.0).work();
  CHECK(fast_work.kernel_evaluations == Counts{14 * fast_work.systems, 0, 0, 0, 0, 0, 0});
  const auto by_thesis =
      fast::line_loads_for_load(quarter_inch_nip, 7, 100.0, {}, {LoadSearch::Iteration::thesis, 1e-12});
  CHECK(by_thesis.load() == approx(100.0, 1e-12));
  CHECK(fast_work.systems < by_thesis.work().systems);
  // The thesis stopped within 0.2 %.
  const auto coarse =
      fast::line_loads_for_load(quarter_inch_nip, 7, 100.0, {}, {LoadSearch::Iteration::thesis, 2e-3});
  CHECK(std::abs(coarse.load() / 100.0 - 1) <= 2e-3);
  CHECK(std::abs(coarse.load() / 100.0 - 1) > 1e-9);
  CHECK(coarse.work().systems < by_thesis.work().systems / 2);
}

TEST_CASE("with full friction three kernels are evaluated at the same distances, and one system is solved") {
  const auto solution = fast::line_loads_for_length(quarter_inch_nip, 7, 0.1, full_friction(1e-4));
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 14, 0, 0, 14, 0});
  CHECK(solution.work().systems == 1);
  CHECK(solution.work().unknowns == 15);
  // The creep is part of the solution.
  CHECK(solution.creep_ratio() == 1e-4);
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 14, 0, 0, 14, 0});
}

TEST_CASE(
    "at the thesis's creep no load pulls and shear changes its sign in the middle only, though a load may be 0") {
  int solved = 0;
  for (const double poisson : {-0.5, 0.0, 0.3, 0.4, 0.5}) {
    for (int m = 2; m <= 12; ++m) {
      for (const double length : {0.1, 0.5, 1.0, 2.0, 3.0}) {
        CAPTURE(poisson, m, length);
        try {
          const LineLoadNip nip = fast::line_loads_for_length({100, 1, {1, poisson}}, m, length,
                                                              {data::LineLoadFriction::Kind::thesis_creep});
          CHECK(nip.shear_zeros() == std::vector<double>{0});
          CHECK(nip.presses_everywhere());
          ++solved;
        } catch (const data::BadInput&) {
          // No creep meets the thesis's conditions.
        }
      }
    }
  }
  CHECK(solved >= 200);
}

TEST_CASE("counts of work add up, but of the unknowns the larger number counts") {
  Work sum{{1, 0, 2, 0, 0, 3, 0}, 10, 1, 5};
  sum += Work{{4, 0, 0, 0, 0, 1, 7}, 20, 2, 3};
  CHECK(sum.kernel_evaluations == Counts{5, 0, 2, 0, 0, 4, 7});
  CHECK(sum.terms == 30);
  CHECK(sum.systems == 3);
  CHECK(sum.unknowns == 5);
}

TEST_CASE("line loads sum as many residues as asked for, and enough of them make the library's kernels") {
  const auto by_residues = fast::line_loads_for_length(quarter_inch_nip, {5, 500}, 0.1, full_friction(1e-4));
  CHECK(by_residues.work().terms == 3 * 10 * 500);
  const auto by_library = fast::line_loads_for_length(quarter_inch_nip, 5, 0.1, full_friction(1e-4));
  CHECK(by_residues.indentation == approx(by_library.indentation, 1e-11));
  CHECK(by_residues.peak_shear() == approx(by_library.peak_shear(), 1e-10));
  // Half an element is 0.08 b, so that ten residues leave an error of e^(-0.08 pi 10), which is 8 %.
  const auto by_few = fast::line_loads_for_length(quarter_inch_nip, {5, 10}, 0.1, full_friction(1e-4));
  CHECK(by_few.indentation != approx(by_library.indentation, 1e-3));
}

TEST_CASE("coarser kernels change the result by no more than their tolerance times the condition") {
  const double full = fast::line_loads_for_length(thick_nip, 5, 0.1).indentation;
  const double coarse = fast::line_loads_for_length(thick_nip, {5, 0, fast::Accuracy(1e-9)}, 0.1).indentation;
  CHECK(coarse != full);
  CHECK(coarse == approx(full, 1e-7));
}

TEST_CASE("bad input to line loads is refused by name") {
  const auto of_length = [](const fast::LineLoadMethod& method, double length,
                            const data::LineLoadFriction& friction = {}) {
    return fast::line_loads_for_length(thick_nip, method, length, friction);
  };
  const auto of_nip = [](const data::ElasticNip& other) { return fast::line_loads_for_load(other, 2, 1.0); };
  CHECK_REFUSED(of_length(0, 0.1), "elements_per_side = 0: must be from 1 to 10000");
  CHECK_REFUSED(of_length(-3, 0.1, full_friction(0)), "elements_per_side = -3: must be from 1 to 10000");
  CHECK_REFUSED(of_length({2, -1}, 0.1), "residue_terms = -1");
  CHECK_REFUSED(of_length({2, 501}, 0.1), "residue_terms = 501");
  CHECK_REFUSED(of_length(2, 0), "contact_length = 0");
  CHECK_REFUSED(of_length(2, not_a_number), "contact_length = nan");
  CHECK_REFUSED(of_length(2, 0.1, full_friction(not_a_number)), "creep = nan: must be a finite number");
  CHECK_REFUSED(fast::line_loads_for_load(thick_nip, 2, -1.0), "load = -1");
  CHECK_REFUSED(fast::line_loads_for_load(thick_nip, 2, 1, full_friction(0), {.tolerance = 0}),
                "tolerance = 0");
  CHECK_REFUSED(of_nip({0.0, 1.0, thick_nip.material}), "roller_radius = 0");
  CHECK_REFUSED(of_nip({6.0, not_a_number, thick_nip.material}), "sheet_thickness = nan");
  CHECK_REFUSED(of_nip({6.0, 1.0, {1.0, 0.6}}), "poisson = 0.6");
  CHECK_REFUSED(of_nip({6.0, 1.0, {-1.0, 0.3}}), "young = -1");
  // These elements are so wide that their loads no longer reach the next matching point.
  CHECK_REFUSED(fast::line_loads_for_length(data::seed::nip(0.005), 1, 301 * 2 * 0.005), "contact_length = ");
}
