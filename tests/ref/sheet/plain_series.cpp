#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/plain_series.hpp>
#include <nipref/ref/sheet/roots.hpp>

#include "support/test.hpp"

using namespace nipref;
using ref::PlainKernel;

TEST_CASE("ref plain series: the sums of so many residues are those in double, at either sign") {
  for (const int terms : {1, 7, 500}) {
    for (const double alpha : {-0.003, 0.02, 0.7, -3.0, 40.0}) {
      std::array<double, 1> at{alpha}, I1{}, I3{}, I6{};
      fast::plain_series(at, terms, {I1, I3, I6});
      const auto near = [&](PlainKernel kernel, double value) {
        const double sum = mpfi_get_d(ref::plain_series(kernel, ref::Interval(alpha, 120), terms).get());
        return std::fabs(sum - value) <= 1e-13 * std::fmax(1, std::fabs(value));
      };
      CHECK(near(PlainKernel::I1, I1[0]));
      CHECK(near(PlainKernel::I3, I3[0]));
      CHECK(near(PlainKernel::I6_alpha_part, I6[0]));
    }
  }
}

TEST_CASE("ref plain series: enough residues are the kernel, within the interval of an argument too") {
  const ref::Enclosure truth = ref::I1(ref::Exact(1.5), 25), other = ref::I3(ref::Exact(1.5), 25);
  const ref::Interval sum = ref::plain_series(PlainKernel::I1, ref::Interval(1.5, 120), 200);
  CHECK(std::fabs(truth.error_of(mpfi_get_d(sum.get()))) <= 1e-16);
  const ref::Interval around =
      ref::Interval(1.5, 120).widened(ref::Interval(ref::Exact::parse("1e-20"), 120));
  const ref::Interval wide = ref::plain_series(PlainKernel::I3, around, 200);
  CHECK(mpfr_cmp(wide.lower(), ref::raw(other.value)) < 0);
  CHECK(mpfr_cmp(wide.upper(), ref::raw(other.value)) > 0);
  CHECK_REFUSED(ref::plain_series(PlainKernel::I1, around, 501), "terms = 501");
}
