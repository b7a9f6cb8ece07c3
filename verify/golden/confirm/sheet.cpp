#include <map>
#include <string>

#include <nipref/verify/golden/confirm/kernels.hpp>
#include <nipref/verify/golden/confirm/sheet.hpp>

namespace nipref::verify::confirm {
namespace {

using Arguments = std::span<const double>;

/// sinh w + w = 0 as w = Log(e^-w - 2 w) + 2 pi i n, which contracts by about 2/|w|, so that there is one root with
/// this n and no other.
Complex root(double n) {
  const Float turns = 2 * pi<Float>() * Float(n);
  Complex w(log(2 * turns), turns - pi<Float>() / 2);
  for (int k = 0; k < 600; ++k) {
    const Complex next = log(exp(-w) - 2 * w) + Complex(Float(0), turns);
    const Float change = abs(next - w);
    w = next;
    if (change < abs(w) * Float("1e-95")) break;
  }
  return w / 2;
}

Confirmation of_root(const Float& part) {
  return confirmation<Float>("fixed point of a logarithm", part, part * Float("1e-90"));
}

Confirmation kernel(const Split& sum) {
  return confirmation<Float>("integral along the real axis or around the poles", sum.value(), sum.error);
}

/// The sum over pi and `divisor`.
Confirmation displacement(Split sum, const mpq_class& divisor = 1) {
  const Float by = pi<Float>() * to_number<Float>(divisor);
  sum.error = sum.error / by + abs(sum.value() / by) * Float("1e-95");
  return confirmation<Float>("integrals along the real axis or around the poles", sum.value() / by,
                             sum.error);
}

/// Constants of the sheet, exact.
struct Compliances {
  mpq_class theta1, theta2, normal;

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

const Methods& all() {
  static const Methods methods{
      {"root.re", [](Arguments x) { return of_root(root(x[0]).real()); }},
      {"root.im", [](Arguments x) { return of_root(root(x[0]).imag()); }},
      {"I1", [](Arguments x) { return kernel(kernel_I1(x[0])); }},
      {"I2",
       [](Arguments x) { return confirmation<Float>("pi/2 sign", kernel_I2(x[0]).value(), Float("1e-95")); }},
      {"I3", [](Arguments x) { return kernel(kernel_I3(x[0])); }},
      {"I4", [](Arguments x) { return kernel(kernel_I4(x[0])); }},
      {"I5", [](Arguments x) { return kernel(kernel_I5(x[0])); }},
      {"I6", [](Arguments x) { return kernel(I6_sum(x[0], x[1])); }},
      {"I7", [](Arguments x) { return kernel(kernel_I7(x[0])); }},
      {"F1",
       [](Arguments x) {
         const Compliances c(1, x[1]);
         return displacement(F1_sum(c, x[0]), c.normal);
       }},
      {"F2",
       [](Arguments x) {
         return F2({1, x[1]}, x[0]);
       }},
      {"un",
       [](Arguments x) {
         return displacement(Split{}.add(Compliances(x[1], x[2]).normal, kernel_I1(x[0])));
       }},
      {"us",
       [](Arguments x) {
         return displacement(us_sum({x[1], x[2]}, x[0]));
       }},
      {"vn",
       [](Arguments x) {
         return vn({x[2], x[3]}, x[0], x[1]);
       }},
      {"vs", [](Arguments x) {
         return vs({x[2], x[3]}, x[0], x[1]);
       }}};
  return methods;
}

}  // namespace

Confirm of_sheet(std::string_view quantity) { return found_in(all(), quantity); }

}  // namespace nipref::verify::confirm
