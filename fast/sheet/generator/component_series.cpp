#include <algorithm>
#include <stdexcept>

#include <nipref/fast/sheet/generator/component_series.hpp>
#include <nipref/fast/sheet/generator/series.hpp>

namespace nipref::fast::generator {
namespace {

using internal::Component;
using internal::Shape;

/// Coefficient c of c e^(i z x): residue of the kernel's transform at the root z, thesis (AI.8), (AI.13) in
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

/// The components of I6 are even except for a linear term. Coefficients of the wrong parity are checked by their
/// contribution at x = reach, the largest argument for which the series is used.
void check_parity(Component component, Series series, const Real& reach) {
  if (component == Component::alpha_part_of_I6 || component == Component::eta_part_of_I6)
    series[1] -= pi() / 4;
  const std::size_t wrong = shape(component) == Shape::odd ? 0 : 1;
  for (std::size_t k = wrong; k < series.size(); k += 2) {
    const Real effect = abs(series[k]) * pow(reach, static_cast<int>(k));
    if (!(effect < Real("1e-25"))) throw std::logic_error("a continued series has lost its parity");
  }
}

}  // namespace

ComponentSeries::ComponentSeries(Component component, const std::vector<Complex>& roots)
    : component_(component), roots_(&roots) {
  for (const Complex& z : roots) amplitudes_.push_back(amplitude(z));
}

Real ComponentSeries::limit() const { return shape(component_) == Shape::odd ? Real(pi() / 4) : Real(0); }

/// Odd components are Re(2 pi c e^(i z x)), the others -Im(2 pi c e^(i z x)) = Re(2 pi i c e^(i z x)).
Complex ComponentSeries::amplitude(const Complex& root) const {
  const Complex c = 2 * pi() * residue(component_, root);
  return shape(component_) == Shape::odd ? c : Complex(-c.imag(), c.real());
}

Series ComponentSeries::about(const Real& centre, int length) const {
  const Real negligible("1e-70");
  Series result(static_cast<std::size_t>(length), Real(0));
  for (std::size_t n = 0; n < roots_->size(); ++n) {
    const Complex iz(-(*roots_)[n].imag(), (*roots_)[n].real());
    Complex term = amplitudes_[n] * exp(iz * centre);
    Real largest = 0;
    for (int k = 0; k < length; ++k) {
      result[static_cast<std::size_t>(k)] += term.real();
      largest = std::max(largest, Real(abs(term.real()) + abs(term.imag())));
      term *= iz / (k + 1);
    }
    if (largest < negligible) {
      result.front() += limit();
      return result;
    }
  }
  throw std::logic_error("too few roots for a Taylor series");
}

Series ComponentSeries::about_zero() const {
  // Logarithmic components are singular at +-2i (and 0, removed), the others at +-i.
  const bool logarithmic = shape(component_) == Shape::logarithmic;
  const Real centre = logarithmic ? Real(1) / 2 : Real(1) / 8;
  const int length = logarithmic ? 90 : 56;
  const int kept = 40;
  Series series = about(centre, length);
  if (logarithmic) {
    const Series log_x = logarithm(centre, length);
    for (std::size_t k = 0; k < series.size(); ++k) series[k] += log_x[k];
  }
  Series result = shifted(series, -centre, kept);
  check_parity(component_, result, centre);
  return result;
}

}  // namespace nipref::fast::generator
