#include <boost/math/constants/constants.hpp>

#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/roots.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

// Second methods for the reference path, which share nothing with it but the definition of the kernels: the
// contour turned to the ray arg z = pi/4 with a double-exponential rule, for larger arguments the residue
// series in many digits, and for the largest a circle around the slowest root.

using namespace nipref::ref;
using nipref::test::ComplexDecimal;
using nipref::test::Decimal;
using nipref::test::exact;

namespace {

using Float60 = Decimal<60>;
using Complex60 = ComplexDecimal<60>;

template <unsigned digits>
void check_agrees(const Enclosure& reference, const Decimal<digits>& other, const char* tolerance) {
  const Decimal<digits> value(reference.value_text());
  const Decimal<digits> bound(reference.error_text());
  CHECK(abs(value - other) <= bound + Decimal<digits>(tolerance) * abs(other));
}

template <class Complex>
Complex S(const Complex& z) {
  return sinh(2 * z) + 2 * z;
}

/// int_0^inf f(z) dz along z = t e^{i pi/4}, t = exp(u - e^{-u}) (Takahasi and Mori), for f that decays like
/// e^{-a t/sqrt 2}. The roots of S lie above 61 degrees: nothing is crossed on the way to the ray, and the
/// rule in u converges like e^{-2 pi 0.28/h}, 0.28 being the angle from the ray to the first root: 1e-61 for
/// h = 1/80.
Complex60 along_ray(double a, const std::function<Complex60(const Complex60&)>& f) {
  const Float60 half_root = sqrt(Float60(2)) / 2;
  const Complex60 ray(half_root, half_root);
  constexpr int steps_a_unit = 80;
  const int last = static_cast<int>(std::ceil(steps_a_unit * std::log(210 / std::min(a, 1.0))));
  Complex60 sum(0);
  for (int k = -5 * steps_a_unit; k <= last; ++k) {
    const Float60 u = Float60(k) / steps_a_unit;
    const Float60 t = exp(u - exp(-u));
    sum += f(ray * t) * t * (1 + exp(-u));
  }
  return ray * sum / steps_a_unit;
}

const Complex60 i(0, 1);

Complex60 I1_symbol(const Complex60& z) { return 2 * sinh(z) * sinh(z) / (z * S(z)); }
Complex60 I3_symbol(const Complex60& z) { return 2 / S(z); }
Complex60 I4_symbol(const Complex60& z) { return 2 * sinh(z) / (z * S(z)); }
Complex60 I5_symbol(const Complex60& z) { return 2 * cosh(z) / S(z); }
Complex60 I7_symbol(const Complex60& z) { return 2 * sinh(z) / S(z); }

Float60 even_along_ray(Complex60 (*symbol)(const Complex60&), const Float60& a) {
  return along_ray(a.convert_to<double>(),
                   [&](const Complex60& z) { return Complex60(symbol(z) * exp(i * a * z)); })
      .real();
}

/// The subtracted e^{-z} removes the pole at 0 and is real on the real axis, where the imaginary part is the
/// integral wanted.
Float60 odd_along_ray(Complex60 (*symbol)(const Complex60&), const Float60& a) {
  return along_ray(a.convert_to<double>(),
                   [&](const Complex60& z) { return Complex60(symbol(z) * (exp(i * a * z) - exp(-z))); })
      .imag();
}

/// Likewise i (a - e) e^{-z}/(2z), imaginary on the real axis, where the real part is wanted. cosh z e^{iaz}
/// - e^{iez} is arranged so that it keeps its digits as z -> 0.
Float60 I6_along_ray(const Float60& a, const Float60& e) {
  const Complex60 half_turn = i * (a - e) / 2;
  return along_ray(a.convert_to<double>(),
                   [&](const Complex60& z) {
                     const Complex60 difference = 2 * sinh(z / 2) * sinh(z / 2) * exp(2 * half_turn * z) +
                                                  2 * sinh(half_turn * z) * exp(half_turn * z);
                     const Complex60 both = 2 * cosh(z) * exp(i * e * z) * difference / (z * S(z));
                     return Complex60(both - half_turn * exp(-z) / z);
                   })
      .real();
}

/// 2 pi sum_n c(z_n) e^{i z_n a} over the roots of the first quadrant.
template <unsigned digits>
ComplexDecimal<digits> residues(const Decimal<digits>& a,
                                ComplexDecimal<digits> (*coefficient)(const ComplexDecimal<digits>&)) {
  using Complex = ComplexDecimal<digits>;
  const int terms = 3 + static_cast<int>(std::ceil(digits * 2.31 / (3.14 * a.template convert_to<double>())));
  Complex sum(0);
  for (int n = 1; n <= terms; ++n) {
    const SheetRoot root = sheet_root(n, static_cast<int>(digits) + 10);
    const Complex z(Decimal<digits>(root.re.value_text()), Decimal<digits>(root.im.value_text()));
    sum += coefficient(z) * exp(Complex(0, 1) * z * a);
  }
  return 2 * boost::math::constants::pi<Decimal<digits>>() * sum;
}

/// 2 pi times the residue of symbol(z) e^{i a z} at the slowest root, the root itself not needed: the rule
/// with n points on a circle of radius r = 1/1024 around a point as near it as seven digits are. The rule errs
/// by (a r)^n/n!, (5e-7/r)^n and (r/2.2)^n of it, less than 1e-1100 for a = 1000, n = 500, and less than
/// 1e-300 for n = 170.
template <unsigned digits>
ComplexDecimal<digits> on_circle(const Decimal<digits>& a, int points,
                                 ComplexDecimal<digits> (*symbol)(const ComplexDecimal<digits>&)) {
  using Complex = ComplexDecimal<digits>;
  const Complex centre(Decimal<digits>("1.125364"), Decimal<digits>("2.106196"));
  const Decimal<digits> two_pi = 2 * boost::math::constants::pi<Decimal<digits>>();
  const Complex turn = exp(Complex(0, two_pi / points));
  Complex arm(Decimal<digits>(1) / 1024);
  Complex sum(0);
  for (int k = 0; k < points; ++k) {
    const Complex z = centre + arm;
    sum += symbol(z) * exp(Complex(0, 1) * z * a) * arm;
    arm *= turn;
  }
  return two_pi * sum / points;
}

template <class Complex>
Complex cosh_symbol(const Complex& z) {
  return 2 * cosh(z) / S(z);
}
template <class Complex>
Complex sinh_symbol(const Complex& z) {
  return 2 * sinh(z) / S(z);
}
/// I4's symbol less I5's.
template <class Complex>
Complex I4_less_I5_symbol(const Complex& z) {
  return sinh_symbol(z) / z - cosh_symbol(z);
}
/// That of I6's alpha part less that of its eta part.
template <class Complex>
Complex I6_symbol(const Complex& z) {
  return cosh_symbol(z) * (cosh(z) - 1) / z;
}

template <class Complex>
Complex I1_residue(const Complex& z) {
  return tanh(z) * tanh(z) / (2 * z);
}
template <class Complex>
Complex I3_residue(const Complex& z) {
  return 1 / (2 * cosh(z) * cosh(z));
}
template <class Complex>
Complex I4_residue(const Complex& z) {
  return sinh(z) / (2 * z * cosh(z) * cosh(z));
}
template <class Complex>
Complex I5_residue(const Complex& z) {
  return 1 / (2 * cosh(z));
}
template <class Complex>
Complex I6_alpha_residue(const Complex& z) {
  return 1 / (2 * z);
}
template <class Complex>
Complex I6_eta_residue(const Complex& z) {
  return 1 / (2 * z * cosh(z));
}
template <class Complex>
Complex I7_residue(const Complex& z) {
  return sinh(z) / (2 * cosh(z) * cosh(z));
}

}  // namespace

TEST_CASE("the turned contour confirms the kernels to 38 digits") {
  for (const std::string text : {"0.01", "0.73", "1.25", "4"}) {
    CAPTURE(text);
    const Float60 a(text);
    check_agrees(I1(exact(text), 40), even_along_ray(I1_symbol, a), "1e-38");
    check_agrees(I3(exact(text), 40), odd_along_ray(I3_symbol, a), "1e-38");
    check_agrees(I4(exact(text), 40), odd_along_ray(I4_symbol, a), "1e-38");
    check_agrees(I5(exact(text), 40), odd_along_ray(I5_symbol, a), "1e-38");
    check_agrees(I7(exact(text), 40), even_along_ray(I7_symbol, a), "1e-38");
    check_agrees(I6(exact(text), exact("1.9"), 40), I6_along_ray(a, Float60("1.9")), "1e-38");
  }
}

TEST_CASE(
    "the residue series confirms the kernels at larger arguments, where all digits cancel on the real axis") {
  const Float60 quarter_pi = boost::math::constants::pi<Float60>() / 4;
  for (const std::string text : {"2.5", "11", "47", "300"}) {
    CAPTURE(text);
    const Float60 a(text);
    const Float60 e("8.5");
    const Exact x = exact(text);
    check_agrees(I1(x, 50), Float60(-residues<60>(a, I1_residue).imag()), "1e-52");
    check_agrees(I3(x, 50), Float60(quarter_pi + residues<60>(a, I3_residue).real()), "1e-52");
    check_agrees(I4(x, 50), Float60(quarter_pi + residues<60>(a, I4_residue).real()), "1e-52");
    check_agrees(I5(x, 50), Float60(quarter_pi + residues<60>(a, I5_residue).real()), "1e-52");
    check_agrees(I7(x, 50), Float60(-residues<60>(a, I7_residue).imag()), "1e-52");
    check_agrees(I6(x, exact("8.5"), 50),
                 Float60(quarter_pi * (e - a) - residues<60>(a, I6_alpha_residue).imag() +
                         residues<60>(e, I6_eta_residue).imag()),
                 "1e-52");
  }
}

TEST_CASE("the residue series confirms 300 digits") {
  const Decimal<320> a("40.25");
  check_agrees(I1(exact("40.25"), 300), Decimal<320>(-residues<320>(a, I1_residue).imag()), "1e-310");
  check_agrees(I7(exact("40.25"), 300), Decimal<320>(-residues<320>(a, I7_residue).imag()), "1e-310");
}

// The second root's terms are e^{-3.25 a} of the slowest one's: 1e-1410.
TEST_CASE("a circle around the slowest root confirms the largest arguments, where all else decays") {
  const Decimal<1010> a(999);
  check_agrees(I7(exact("999"), 1000), Decimal<1010>(-on_circle<1010>(a, 500, sinh_symbol).imag()),
               "1e-1004");
  const Decimal<220> b(999);
  check_agrees(I6(exact("-999"), exact("999"), 200), Decimal<220>(-on_circle<220>(b, 170, I6_symbol).imag()),
               "1e-212");
  const Decimal<220> c(1000);
  const Decimal<220> difference = on_circle<220>(c, 170, I4_less_I5_symbol).real();
  const Decimal<220> two_pi = 2 * boost::math::constants::pi<Decimal<220>>();
  check_agrees(F1(exact("1000"), exact("0"), 200), Decimal<220>(difference / two_pi), "1e-212");
}
