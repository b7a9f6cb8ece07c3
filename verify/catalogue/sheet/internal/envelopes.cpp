#include <complex>

#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

using data::SheetLoad;
using std::numbers::pi;
using Complex = std::complex<double>;

/// First root of sinh 2z + 2z = 0 in the first quadrant.
const Complex first_root{1.1253643058009303, 2.1061961152453303}, root_cosine = std::cosh(first_root);

double decaying(Complex coefficient, double argument) {
  return 2 * pi * std::abs(coefficient) * std::exp(-first_root.imag() * std::fabs(argument));
}

double bounded(double slope, double largest, double argument) {
  return std::min(slope * std::fabs(argument), largest);
}

constexpr double closed_forms_end = 1.25;

/// A place in the sheet: its distances from the load on the nearer face and from that on the other face, and functions of
/// them.
struct Seen {
  double a, s, near_face, far_face, near, far;
  double residue;  ///< of the slowest residue, but for |c cosh(s z)| or |c sinh(s z)|

  Seen(const FieldSize& at, bool odd_in_alpha)
      : a(std::fabs(at.alpha)),
        s(std::fabs(at.depth)),
        near_face(1 - s),
        far_face(1 + s),
        near(std::hypot(a, near_face)),
        far(std::hypot(a, far_face)),
        // Subnormal numbers have fewer bits.
        residue(2 * pi * std::max(std::exp(-first_root.imag() * a), std::numeric_limits<double>::min()) *
                (odd_in_alpha ? std::min(1.0, a) : 1.0)) {}

  [[nodiscard]] double of_cosh(int power, bool sinh) const {
    return term(1 / std::abs(2.0 * root_cosine), power, sinh);
  }
  [[nodiscard]] double of_sinh(int power, bool sinh) const {
    return term(std::abs(first_root / (2.0 * root_cosine * root_cosine * root_cosine)), power, sinh);
  }
  [[nodiscard]] double term(double c, int power, bool sinh) const {
    return residue * c * std::pow(std::abs(first_root), power) *
           std::abs(sinh ? std::sinh(s * first_root) : std::cosh(s * first_root));
  }

  [[nodiscard]] bool close() const { return a < closed_forms_end; }
  /// The stress in a half-plane: face^i a^(3-i)/r^4, times s < 1 for a stress that vanishes in the middle plane.
  [[nodiscard]] double stress(int i) const {
    const auto one = [&](double face, double r) {
      return std::pow(face / r, i) * std::pow(a / r, 3 - i) / r;
    };
    return close() ? 2 * (one(near_face, near) + one(far_face, far)) : 0;
  }
  [[nodiscard]] double shares() const { return near_face / near / near + far_face / far / far; }
};

double direct_stress(const FieldSize& field, bool along) {
  const bool normal = field.load == SheetLoad::normal;
  const Seen at(field, !normal);
  const double terms =
      normal ? at.of_sinh(0, false) + at.of_cosh(1, false) + at.s * at.of_sinh(1, true)
             : at.of_sinh(1, false) + (along ? 2 * at.of_cosh(0, false) : 0) + at.s * at.of_cosh(1, true);
  return (at.stress((normal ? 1 : 0) + (along ? 0 : 2)) + terms) / pi;
}

}  // namespace

double envelope_I1(double alpha) {
  const Complex tangent = std::tanh(first_root);
  return decaying(tangent * tangent / (2.0 * first_root), alpha);
}

double envelope_I3(double alpha) { return decaying(1.0 / (2.0 * root_cosine * root_cosine), alpha); }

double envelope_I7(double eta) {
  return decaying(std::sinh(first_root) / (2.0 * root_cosine * root_cosine), eta);
}

double envelope_r(double alpha) { return decaying(1.0 / (2.0 * first_root), alpha); }

double envelope_s(double eta) { return decaying(1.0 / (2.0 * first_root * root_cosine), eta); }

// The slopes are the integrals of x times the kernel's transform, which bound the kernel because |sin(x a)|
// <= x |a|.
double magnitude_I3(double alpha) { return bounded(0.76858, 0.787, alpha); }
double magnitude_I4(double eta) { return bounded(1.05372, 0.791, eta); }
double magnitude_I5(double eta) { return bounded(1.83496, 0.905, eta); }

double FieldSize::across() const { return direct_stress(*this, false); }
double FieldSize::along() const { return direct_stress(*this, true); }

double FieldSize::shear() const {
  const bool normal = load == SheetLoad::normal;
  const Seen at(*this, normal);
  const double terms = normal ? at.of_cosh(1, true) + at.s * at.of_sinh(1, false)
                              : at.of_sinh(1, true) + at.of_cosh(0, true) + at.s * at.of_cosh(1, false);
  return (std::min(1.0, at.s) * at.stress(normal ? 2 : 1) + terms) / pi;
}

double FieldSize::u(double poisson) const {
  const double t1 = 1 / (2 * (1 - poisson)), t2 = 1 - t1;
  const Seen at(*this, load == SheetLoad::shear);
  const double sine = at.a / at.near / at.far;
  if (load == SheetLoad::normal) {
    const double planes =
        at.close() ? std::log1p(4 * at.s / at.near / at.near) / 2 + t1 * 4 * at.s * sine * sine : 0;
    const double logarithm = std::isfinite(planes) ? planes : std::log(at.far / at.near);
    return (logarithm + at.of_sinh(-1, true) + t1 * (at.of_cosh(0, true) + at.s * at.of_sinh(0, false))) / pi;
  }
  double rest = at.s * pi / 4;
  if (at.close())
    rest = t2 * std::atan2(2 * at.s * at.a, at.near_face * at.far_face + at.a * at.a) +
           t1 * at.s * at.a * at.shares();
  return (rest + t2 * at.of_cosh(-1, true) + t1 * (at.of_sinh(0, true) + at.s * at.of_cosh(0, false))) / pi;
}

double FieldSize::v(double eta, double poisson) const {
  const double t1 = 1 / (2 * (1 - poisson)), t2 = 1 - t1;
  const Seen at(*this, load == SheetLoad::normal);
  if (load == SheetLoad::normal) {
    const double angles = std::atan2(at.a, at.near_face) + std::atan2(at.a, at.far_face);
    const double rest = at.close() ? t2 * angles + t1 * at.a * at.shares() : pi / 4;
    const double held = t2 * magnitude_I4(eta) + t1 * magnitude_I5(eta);
    return (rest + held + t2 * at.of_sinh(-1, false) +
            t1 * (at.of_cosh(0, false) + at.s * at.of_sinh(0, true))) /
           pi;
  }
  const double least = 4 * std::numeric_limits<double>::min();
  const double held = std::max(envelope_s(eta) + t1 * envelope_I7(eta), least);
  const double squares =
      at.near_face * (at.near_face / at.near / at.near) + at.far_face * (at.far_face / at.far / at.far);
  const double rest =
      at.close() ? std::fabs(eta) * pi / 4 + std::fabs(std::log(at.near)) + std::log(at.far) + t1 * squares
                 : std::fabs(std::fabs(eta) - at.a) * pi / 4;
  return (rest + held + at.of_cosh(-1, false) + t1 * (at.of_sinh(0, false) + at.s * at.of_cosh(0, true))) /
         pi;
}

}  // namespace nipref::verify
