#include <nipref/fast/elastic_nip/line_loads.hpp>

#include "support/line_load_sums.hpp"
#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using namespace line_load_tests;
using fast::LineLoadMethod;
using fast::LoadSearch;
using fast::Work;
using test::quarter_inch_nip;

namespace {

using Counts = std::array<std::uint64_t, 7>;

}  // namespace

TEST_CASE("without friction and creep nothing but I1 is evaluated, 2m values a solve") {
  const auto solution = fast::line_loads_for_length(quarter_inch_nip, 7, 0.1);
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 0, 0, 0, 0, 0});
  CHECK(solution.work().systems == 1);
  CHECK(solution.work().unknowns == 8);
  // The creep asks for I3 at the loads; displacements at one place likewise.
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

TEST_CASE("with full friction three kernels at the same distances, one system") {
  const auto solution = fast::line_loads_for_length(quarter_inch_nip, 7, 0.1, grip_with(1e-4));
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 14, 0, 0, 14, 0});
  CHECK(solution.work().systems == 1);
  CHECK(solution.work().unknowns == 15);
  // The creep is part of the solution.
  CHECK(solution.creep_ratio() == 1e-4);
  CHECK(solution.work().kernel_evaluations == Counts{14, 0, 14, 0, 0, 14, 0});
}

TEST_CASE("work adds up") {
  Work sum{{1, 0, 2, 0, 0, 3, 0}, 10, 1, 5};
  sum += Work{{4, 0, 0, 0, 0, 1, 7}, 20, 2, 3};
  CHECK(sum.kernel_evaluations == Counts{5, 0, 2, 0, 0, 4, 7});
  CHECK(sum.terms == 30);
  CHECK(sum.systems == 3);
  CHECK(sum.unknowns == 5);
}

TEST_CASE("residues: as many terms as asked for, and the library's kernels where they suffice") {
  const auto by_residues = fast::line_loads_for_length(quarter_inch_nip, {5, 500}, 0.1, grip_with(1e-4));
  CHECK(by_residues.work().terms == 3 * 10 * 500);
  const auto by_library = fast::line_loads_for_length(quarter_inch_nip, 5, 0.1, grip_with(1e-4));
  CHECK(by_residues.indentation == approx(by_library.indentation, 1e-11));
  CHECK(by_residues.peak_shear() == approx(by_library.peak_shear(), 1e-10));
  // Half an element is 0.08 b: e^(-0.08 pi 10) is 8 % of it.
  const auto by_few = fast::line_loads_for_length(quarter_inch_nip, {5, 10}, 0.1, grip_with(1e-4));
  CHECK(by_few.indentation != approx(by_library.indentation, 1e-3));
}
