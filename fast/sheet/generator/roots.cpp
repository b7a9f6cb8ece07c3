#include <stdexcept>

#include <nipref/fast/sheet/generator/roots.hpp>

namespace nipref::fast::generator {
namespace {

Complex equation(const Complex& z) { return sinh(2 * z) + 2 * z; }

/// For large n: e^(2z) ~ -4z, hence z ~ i pi (n - 1/4) + ln(4 pi (n - 1/4))/2.
Complex asymptotic_root(int n) {
  const Real imaginary = pi() * (n - Real(1) / 4);
  return {Real(log(4 * imaginary) / 2), imaginary};
}

/// Newton; (sinh 2z + 2z)' = 4 cosh^2 z.
Complex polished(Complex z) {
  for (int step = 0; step < 12; ++step) {
    const Complex cosh_z = cosh(z);
    const Complex correction = equation(z) / (4 * cosh_z * cosh_z);
    z -= correction;
    if (abs(correction) < abs(z) * Real("1e-95")) break;
  }
  return z;
}

void check(const Complex& z, int n) {
  const bool solves = abs(equation(z)) < Real("1e-85") * abs(z) * abs(z);
  const bool in_strip = z.real() > 0 && z.imag() > (n - Real(1) / 2) * pi() && z.imag() < n * pi();
  if (!solves || !in_strip) throw std::logic_error("a root of sinh 2z + 2z is not the one asked for");
}

}  // namespace

std::vector<Complex> first_roots(int count) {
  std::vector<Complex> roots;
  for (int n = 1; n <= count; ++n) {
    roots.push_back(polished(asymptotic_root(n)));
    check(roots.back(), n);
  }
  return roots;
}

}  // namespace nipref::fast::generator
