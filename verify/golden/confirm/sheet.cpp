#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

constexpr auto on_circle = "integral over a circle around the root";

Pole pole_of(Arguments x) { return pole_by_circle(static_cast<std::size_t>(x["n"])); }

Confirmation root_part(const Float& part) { return confirmation(on_circle, part, part * Float("1e-75")); }

/// In the order of the kernels in quantities.toml, of which I3, I4 and I5 are sine transforms.
Confirmation residue(Arguments x) {
  const Pole at = pole_of(x);
  const Complex by_kernel[]{at.I1, at.I3, at.I4, at.I5, at.I1 + at.I6_alpha, -at.I6_eta, at.I7};
  const auto number = static_cast<std::size_t>(x["kernel"]);
  const Complex c = 2 * by_kernel[number];
  const bool odd = number >= 1 && number <= 3, first = x["coefficient"] == 0;
  const Float value = odd && !first ? c.real() : first && !odd ? Float(-c.real()) : Float(-c.imag());
  return confirmation(on_circle, value, abs(c) * Float("1e-75"));
}

Confirmation kernel(const Split& sum) {
  return confirmation("integral along the real axis or around the poles", sum.value(), sum.error);
}

/// The sum divided by pi and `divisor`.
Confirmation displacement(Split sum, const mpq_class& divisor = 1) {
  const Float by = pi() * to_number(divisor);
  sum.error = sum.error / by + abs(sum.value() / by) * Float("1e-95");
  return confirmation("integrals along the real axis or around the poles", sum.value() / by, sum.error);
}

/// The exact compliances of the sheet.
struct Compliances {
  mpq_class theta1, theta2, normal;

  explicit Compliances(Arguments x) : Compliances(x["young"], x["poisson"]) {}
  Compliances(double young, double poisson) {
    const mpq_class nu(poisson), E(young);
    theta1 = (1 + nu) / E;
    theta2 = (1 + nu) * (1 - 2 * nu) / E;
    normal = theta1 + theta2;
  }
};

Split F1_sum(const Compliances& c, const mpq_class& eta) {
  return Split{}.add(c.theta2, kernel_I4(eta)).add(-c.theta1, kernel_I5(eta));
}

Split us_sum(const Compliances& c, const mpq_class& alpha) {
  return Split{}.add(c.theta2, kernel_I2(alpha)).add(-c.normal, kernel_I3(alpha));
}

Split I6_sum(const mpq_class& alpha, const mpq_class& eta) {
  return Split(kernel_I6_alpha(alpha)).add(-1, kernel_I6_eta(eta));
}

Confirmation vn(const Compliances& c, const mpq_class& alpha, const mpq_class& eta) {
  return displacement(F1_sum(c, eta).add(-1, us_sum(c, alpha)));
}

Confirmation vs(const Compliances& c, const mpq_class& alpha, const mpq_class& eta) {
  return displacement(Split{}.add(c.normal, I6_sum(alpha, eta)).add(c.theta1, kernel_I7(eta)));
}

Confirmation F2(const Compliances& c, const mpq_class& eta) {
  return displacement(
      Split{}.add(-1, kernel_I6_eta(eta)).add(mpq_class(c.theta1 / c.normal), kernel_I7(eta)));
}

}  // namespace

Methods sheet_methods() {
  return {
      {"root.re", [](Arguments x) { return root_part(pole_of(x).z.real()); }},
      {"root.im", [](Arguments x) { return root_part(pole_of(x).z.imag()); }},
      {"residue", residue},
      {"I1", [](Arguments x) { return kernel(kernel_I1(x["alpha"])); }},
      {"I2",
       [](Arguments x) { return confirmation("pi/2 sign", kernel_I2(x["alpha"]).value(), Float("1e-95")); }},
      {"I3", [](Arguments x) { return kernel(kernel_I3(x["alpha"])); }},
      {"I4", [](Arguments x) { return kernel(kernel_I4(x["eta"])); }},
      {"I5", [](Arguments x) { return kernel(kernel_I5(x["eta"])); }},
      {"I6", [](Arguments x) { return kernel(I6_sum(x["alpha"], x["eta"])); }},
      {"I7", [](Arguments x) { return kernel(kernel_I7(x["eta"])); }},
      {"F1",
       [](Arguments x) {
         const Compliances c(1, x["poisson"]);
         return displacement(F1_sum(c, x["eta"]), c.normal);
       }},
      {"F2",
       [](Arguments x) {
         return F2({1, x["poisson"]}, x["eta"]);
       }},
      {"un",
       [](Arguments x) { return displacement(Split{}.add(Compliances(x).normal, kernel_I1(x["alpha"]))); }},
      {"us", [](Arguments x) { return displacement(us_sum(Compliances(x), x["alpha"])); }},
      {"vn", [](Arguments x) { return vn(Compliances(x), x["alpha"], x["eta"]); }},
      {"vs", [](Arguments x) { return vs(Compliances(x), x["alpha"], x["eta"]); }}};
}

}  // namespace nipref::verify::confirm
