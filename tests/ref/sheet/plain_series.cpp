#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/plain_series.hpp>
#include <nipref/ref/sheet/roots.hpp>

#include "support/test.hpp"

using namespace nipref;
using ref::PlainKernel;

TEST_CASE("ref plain series: the sums of so many residues in double, at either sign") {
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

TEST_CASE("residue coefficients are the thesis's printed forms at the roots") {
  for (const int n : {1, 2, 5}) {
    const ref::SheetRoot root = ref::sheet_root(n, 20);
    const double m = root.re.to_double(), k = root.im.to_double(), square = m * m + k * k;
    const double cm = std::cosh(m), sm = std::sinh(m), ck = std::cos(k), sk = std::sin(k);
    // (AI.5), (AI.14)
    const double t = std::pow(std::tanh(m), 2), u = std::pow(std::tan(k), 2), over = std::pow(1 + t * u, 2);
    const double g = ((t - u) * (1 - t * u) + 4 * t * u) / over;
    const double h = 2 * std::tanh(m) * std::tan(k) * (1 - t * u - t + u) / over;
    const double d = cm * cm * ck * ck + sm * sm * sk * sk;
    const double g1 = sm * ck * (cm * cm + sk * sk) / (d * d), h1 = cm * sk * (sm * sm - ck * ck) / (d * d);
    const double g2 = cm * ck / d, h2 = sm * sk / d;
    // (AI.8), (AI.13)
    const std::array<std::array<double, 2>, 7> printed{
        {{-(g * m + h * k) / square, (g * k - h * m) / square},
         {std::sinh(2 * m) * std::sin(2 * k) / 2 / (d * d),
          (cm * cm * ck * ck - sm * sm * sk * sk) / (d * d)},
         {(m * h1 + k * g1) / square, (m * g1 - k * h1) / square},
         {h2, g2},
         {-m / square, k / square},
         {(m * g2 - k * h2) / square, -(m * h2 + k * g2) / square},
         {-g1, h1}}};
    for (std::size_t kernel = 0; kernel < printed.size(); ++kernel) {
      CAPTURE(n);
      CAPTURE(kernel);
      const auto found = ref::residue_coefficients(static_cast<PlainKernel>(kernel), n, 20);
      CHECK(found.A.to_double() == doctest::Approx(printed[kernel][0]).epsilon(1e-12));
      CHECK(found.B.to_double() == doctest::Approx(printed[kernel][1]).epsilon(1e-12));
    }
  }
  CHECK_THROWS_AS((void)ref::residue_coefficients(PlainKernel::I1, 0, 20), data::BadInput);
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
  CHECK_THROWS_WITH_AS((void)ref::plain_series(PlainKernel::I1, around, 501),
                       doctest::Contains("terms = 501"), data::BadInput);
}
