#include <complex>

#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

using Complex = std::complex<double>;

/// First root of sinh 2z + 2z = 0 in the first quadrant.
const Complex first_root{1.1253643058009303, 2.1061961152453303};

double decaying(Complex coefficient, double argument) {
  return 2 * std::numbers::pi * std::abs(coefficient) * std::exp(-first_root.imag() * std::fabs(argument));
}

double bounded(double slope, double largest, double argument) {
  return std::min(slope * std::fabs(argument), largest);
}

}  // namespace

double envelope_I1(double alpha) {
  const Complex tangent = std::tanh(first_root);
  return decaying(tangent * tangent / (2.0 * first_root), alpha);
}

double envelope_I3(double alpha) {
  const Complex cosine = std::cosh(first_root);
  return decaying(1.0 / (2.0 * cosine * cosine), alpha);
}

double envelope_I7(double eta) {
  const Complex cosine = std::cosh(first_root);
  return decaying(std::sinh(first_root) / (2.0 * cosine * cosine), eta);
}

double envelope_r(double alpha) { return decaying(1.0 / (2.0 * first_root), alpha); }

double envelope_s(double eta) { return decaying(1.0 / (2.0 * first_root * std::cosh(first_root)), eta); }

// The slopes are the integrals of x times the kernel's transform, which bound the kernel because |sin(x a)|
// <= x |a|.
double magnitude_I3(double alpha) { return bounded(0.76858, 0.787, alpha); }
double magnitude_I4(double eta) { return bounded(1.05372, 0.791, eta); }
double magnitude_I5(double eta) { return bounded(1.83496, 0.905, eta); }

namespace {

using data::SheetLoad;
using std::numbers::pi;

constexpr double closed_forms_end = 1.25;

/// |c| of the functions of the slowest residue times |cosh(s z)| or |sinh(s z)|.
class SlowestResidue {
 public:
  SlowestResidue(const FieldSize& at, bool odd_in_alpha)
      : grows_(std::abs(std::cosh(std::fabs(at.depth) * z))),
        rises_(std::abs(std::sinh(std::fabs(at.depth) * z))) {
    const double a = std::fabs(at.alpha);
    // Subnormal numbers have fewer bits.
    size_ = 2 * pi * std::max(std::exp(-z.imag() * a), std::numeric_limits<double>::min()) *
            (odd_in_alpha ? std::min(1.0, a) : 1.0);
  }

  [[nodiscard]] double of_cosh(int power, bool sinh) const {
    return term(1 / std::abs(2.0 * cosine), power, sinh);
  }
  [[nodiscard]] double of_sinh(int power, bool sinh) const {
    return term(std::abs(z / (2.0 * cosine * cosine * cosine)), power, sinh);
  }

 private:
  inline static const std::complex<double> z{1.1253643058009303, 2.1061961152453303};
  inline static const std::complex<double> cosine = std::cosh(z);

  [[nodiscard]] double term(double c, int power, bool sinh) const {
    return size_ * c * std::pow(std::abs(z), power) * (sinh ? rises_ : grows_);
  }

  double grows_, rises_, size_;
};

/// Distances from the load on the nearer face and from that on the other face, and functions of them.
struct Seen {
  double a, s, near_face, far_face, near, far;

  explicit Seen(const FieldSize& at)
      : a(std::fabs(at.alpha)),
        s(std::fabs(at.depth)),
        near_face(1 - s),
        far_face(1 + s),
        near(std::hypot(a, near_face)),
        far(std::hypot(a, far_face)) {}

  [[nodiscard]] bool close() const { return a < closed_forms_end; }
  /// The stress in a half-plane: face^i a^(3-i)/r^4, times s < 1 for a stress that vanishes in the middle plane.
  [[nodiscard]] double stress(int i) const {
    const auto one = [&](double face, double r) {
      return std::pow(face / r, i) * std::pow(a / r, 3 - i) / r;
    };
    return close() ? 2 * (one(near_face, near) + one(far_face, far)) : 0;
  }
};

}  // namespace

double FieldSize::across() const {
  const bool normal = load == SheetLoad::normal;
  const SlowestResidue r(*this, !normal);
  const Seen at(*this);
  const double terms = normal ? r.of_sinh(0, false) + r.of_cosh(1, false) + at.s * r.of_sinh(1, true)
                              : r.of_sinh(1, false) + at.s * r.of_cosh(1, true);
  return (at.stress(normal ? 3 : 2) + terms) / pi;
}

double FieldSize::along() const {
  const bool normal = load == SheetLoad::normal;
  const SlowestResidue r(*this, !normal);
  const Seen at(*this);
  const double terms = normal ? r.of_sinh(0, false) + r.of_cosh(1, false) + at.s * r.of_sinh(1, true)
                              : r.of_sinh(1, false) + 2 * r.of_cosh(0, false) + at.s * r.of_cosh(1, true);
  return (at.stress(normal ? 1 : 0) + terms) / pi;
}

double FieldSize::shear() const {
  const bool normal = load == SheetLoad::normal;
  const SlowestResidue r(*this, normal);
  const Seen at(*this);
  const double terms = normal ? r.of_cosh(1, true) + at.s * r.of_sinh(1, false)
                              : r.of_sinh(1, true) + r.of_cosh(0, true) + at.s * r.of_cosh(1, false);
  return (std::min(1.0, at.s) * at.stress(normal ? 2 : 1) + terms) / pi;
}

double FieldSize::u(double poisson) const {
  const double t1 = 1 / (2 * (1 - poisson)), t2 = 1 - t1;
  const SlowestResidue r(*this, load == SheetLoad::shear);
  const Seen at(*this);
  const double sine = at.a / at.near / at.far;
  if (load == SheetLoad::normal) {
    const double planes =
        at.close() ? std::log1p(4 * at.s / at.near / at.near) / 2 + t1 * 4 * at.s * sine * sine : 0;
    const double logarithm = std::isfinite(planes) ? planes : std::log(at.far / at.near);
    return (logarithm + r.of_sinh(-1, true) + t1 * (r.of_cosh(0, true) + at.s * r.of_sinh(0, false))) / pi;
  }
  double rest = at.s * pi / 4;
  if (at.close()) {
    const double apart = at.near_face / at.near / at.near + at.far_face / at.far / at.far;
    rest =
        t2 * std::atan2(2 * at.s * at.a, at.near_face * at.far_face + at.a * at.a) + t1 * at.s * at.a * apart;
  }
  return (rest + t2 * r.of_cosh(-1, true) + t1 * (r.of_sinh(0, true) + at.s * r.of_cosh(0, false))) / pi;
}

double FieldSize::v(double eta, double poisson) const {
  const double t1 = 1 / (2 * (1 - poisson)), t2 = 1 - t1;
  const SlowestResidue r(*this, load == SheetLoad::normal);
  const Seen at(*this);
  const double shares = at.near_face / at.near / at.near + at.far_face / at.far / at.far;
  if (load == SheetLoad::normal) {
    const double angles = std::atan2(at.a, at.near_face) + std::atan2(at.a, at.far_face);
    const double rest = at.close() ? t2 * angles + t1 * at.a * shares : pi / 4;
    const double held = t2 * magnitude_I4(eta) + t1 * magnitude_I5(eta);
    return (rest + held + t2 * r.of_sinh(-1, false) +
            t1 * (r.of_cosh(0, false) + at.s * r.of_sinh(0, true))) /
           pi;
  }
  const double least = 4 * std::numeric_limits<double>::min();
  const double held = std::max(envelope_s(eta) + t1 * envelope_I7(eta), least);
  const double squares =
      at.near_face * (at.near_face / at.near / at.near) + at.far_face * (at.far_face / at.far / at.far);
  const double rest =
      at.close() ? std::fabs(eta) * pi / 4 + std::fabs(std::log(at.near)) + std::log(at.far) + t1 * squares
                 : std::fabs(std::fabs(eta) - at.a) * pi / 4;
  return (rest + held + r.of_cosh(-1, false) + t1 * (r.of_sinh(0, false) + at.s * r.of_cosh(0, true))) / pi;
}

}  // namespace nipref::verify
