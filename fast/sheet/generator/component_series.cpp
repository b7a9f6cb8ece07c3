#include <map>
#include <stdexcept>

#include <nipref/fast/sheet/generator/component_series.hpp>

namespace nipref::fast::generator {
namespace {

using internal::Component;
using internal::Shape;

Complex equation(const Complex& z) { return sinh(2 * z) + 2 * z; }

/// For large n: e^(2z) ~ -4z, hence z ~ i pi (n - 1/4) + ln(4 pi (n - 1/4))/2.
Complex asymptotic_root(int n) {
  const Real imaginary = pi() * (n - Real(1) / 4);
  return {Real(log(4 * imaginary) / 2), imaginary};
}

/// Newton's method with (sinh 2z + 2z)' = 4 cosh^2 z.
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

/// The coefficient c of c e^(i z x): the residue of the kernel's transform at the root z, thesis (AI.8), (AI.13) in
/// complex form.
Complex residue(Component component, const Complex& z) {
  const Complex sinh_z = sinh(z);
  const Complex cosh_z = cosh(z);
  switch (component) {
    case Component::I1:
      return sinh_z * sinh_z / (2 * z * cosh_z * cosh_z);
    case Component::I3:
      return 1 / (2 * cosh_z * cosh_z);
    case Component::I4:
      return sinh_z / (2 * z * cosh_z * cosh_z);
    case Component::I5:
      return 1 / (2 * cosh_z);
    case Component::I7:
      return sinh_z / (2 * cosh_z * cosh_z);
    case Component::alpha_part_of_I6:
      return 1 / (2 * z);
    case Component::eta_part_of_I6:
      return 1 / (2 * z * cosh_z);
  }
  throw std::logic_error("unknown component");
}

/// Odd components are Re(2 pi c e^(i z x)), the others -Im(2 pi c e^(i z x)) = Re(2 pi i c e^(i z x)).
Complex amplitude(Component component, const Complex& root) {
  const Complex c = 2 * pi() * residue(component, root);
  return shape(component) == Shape::odd ? c : Complex(-c.imag(), c.real());
}

/// e^(i z_n x) for the roots for which it is not negligible. Results are cached, since all components need them.
const std::vector<Complex>& waves(const Real& x) {
  static std::map<Real, std::vector<Complex>> kept;
  std::vector<Complex>& found = kept[x];
  if (found.empty()) {
    for (auto z = roots().begin(); found.empty() || norm(found.back()) > Real("1e-140"); ++z) {
      if (z == roots().end()) throw std::logic_error("too few roots for a residue series");
      found.push_back(exp(Complex(-z->imag() * x, z->real() * x)));
    }
  }
  return found;
}

}  // namespace

const std::vector<Complex>& roots() {
  constexpr int count = 1200;  // enough at x = 1/20, the most demanding use
  static const std::vector<Complex> all = [] {
    std::vector<Complex> found;
    for (int n = 1; n <= count; ++n) {
      found.push_back(polished(asymptotic_root(n)));
      check(found.back(), n);
    }
    return found;
  }();
  return all;
}

/// The power series is the polynomial through values of the residue series. As the even part is analytic in x^2 except
/// at and below -1, the polynomial converges like 18^-degree between the points and like 15^-degree at 0.
ComponentSeries::ComponentSeries(Component component) : component_(component) {
  for (const Complex& z : roots()) amplitudes_.push_back(amplitude(component, z));
  const Real nearest = Real(1) / 400, farthest = Real(1) / 4, between = Real(1) / 64;
  about_zero_ = interpolated([this](const Real& square) { return even_part(square); }, nearest, farthest, 56);
  if (!(abs(value(about_zero_, between) - even_part(between)) < Real("1e-45")))
    throw std::logic_error("a power series about 0 is not that of its component");
}

Real ComponentSeries::limit() const { return shape(component_) == Shape::odd ? Real(pi() / 4) : Real(0); }

Real ComponentSeries::linear() const {
  const bool of_I6 = component_ == Component::alpha_part_of_I6 || component_ == Component::eta_part_of_I6;
  return of_I6 ? Real(pi() / 4) : Real(0);
}

Real ComponentSeries::by_residues(const Real& x) const {
  const std::vector<Complex>& wave = waves(x);
  Real sum = limit();
  for (std::size_t n = 0; n < wave.size(); ++n)
    sum += amplitudes_[n].real() * wave[n].real() - amplitudes_[n].imag() * wave[n].imag();
  return sum;
}

Real ComponentSeries::even_part(const Real& square) const {
  const Real x = sqrt(square), f = by_residues(x);
  if (shape(component_) == Shape::odd) return f / x;
  return shape(component_) == Shape::logarithmic ? Real(f + log(x) - linear() * x) : Real(f - linear() * x);
}

Real ComponentSeries::operator()(const Real& x) const {
  if (x < Real(1) / 8) return value(about_zero_, x * x) + linear() * x;
  return shape(component_) == Shape::odd ? Real(by_residues(x) / x) : by_residues(x);
}

}  // namespace nipref::fast::generator
