#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

namespace nipref::ref {
namespace {

/// q + s (r + r^T) + s^2 t at rest, in floating point.
template <class Scalar>
struct AcousticPencil {
  using Square = DenseMatrix<Scalar>;
  using EigenSolver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Scalar, 3, 3>>;
  Square q, r, t;

  explicit AcousticPencil(const AcousticMatrices& x)
      : q(middle(x.q).re.cast<Scalar>()),
        r(middle(x.r).re.cast<Scalar>()),
        t(middle(x.t).re.cast<Scalar>()) {}

  [[nodiscard]] Square at(const Scalar& s) const { return q + s * (r + r.transpose()) + s * s * t; }
  [[nodiscard]] Scalar lowest_value(const Scalar& s) const {
    return EigenSolver(at(s), Eigen::EigenvaluesOnly).eigenvalues()(0);
  }
  /// The eigenvector of the smallest eigenvalue.
  [[nodiscard]] Square lowest_vector(const Scalar& s) const {
    return EigenSolver(at(s)).eigenvectors().col(0);
  }
};
using RoughPencil = AcousticPencil<double>;

/// The s = tan(phi), in a scan of half a turn, for which the smallest eigenvalue is smallest lies between these.
struct Valley {
  double left, right;

  explicit Valley(const RoughPencil& pencil) {
    constexpr int steps = 360;
    const auto s_at = [](int k) { return std::tan(std::numbers::pi * (k / double{steps} - 0.5)); };
    double lowest = HUGE_VAL;
    for (int k = 2; k <= steps - 2; ++k) {
      const double eigenvalue = pencil.lowest_value(s_at(k));
      if (eigenvalue < lowest) lowest = eigenvalue, left = s_at(k - 1), right = s_at(k + 1);
    }
  }
  /// The s of the minimum between them, to half of the bits of a number, and the eigenvalue there, to all. Moduli may be so far
  /// apart that the scan has seen rounding alone and no minimum is there: the search ends after the steps of a golden section.
  template <class Scalar>
  [[nodiscard]] std::pair<Scalar, Scalar> lowest_point(const AcousticPencil<Scalar>& pencil,
                                                       mpfr_prec_t bits) const {
    const auto value = [&](const Scalar& s) { return pencil.lowest_value(s); };
    auto most_steps = static_cast<std::uintmax_t>(bits);
    return boost::math::tools::brent_find_minima(value, Scalar(left), Scalar(right),
                                                 static_cast<int>(bits / 2), most_steps);
  }
};

AcousticMatrices at_rest(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t precision) {
  return acoustic_matrices(solid, psi, Interval(precision));
}

/// The Rayleigh quotient x.(q + s (r + r^T) + s^2 t).x/x.x, whose upper end is an upper bound of the limiting inertia.
Interval rayleigh_quotient(const AcousticMatrices& matrices, const Float& s, const Vector& x) {
  const mpfr_prec_t precision = matrices.q.precision();
  const Interval si = interval_of(s, precision);
  Interval numerator(precision);
  Interval denominator(precision);
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval xi = interval_of(x(static_cast<Matrix::Index>(i)), precision);
    denominator = denominator + square(xi);
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval entry =
          matrices.q(i, k).re + 2 * (si * matrices.r(i, k).re) + square(si) * matrices.t(i, k).re;
      numerator = numerator + xi * interval_of(x(static_cast<Matrix::Index>(k)), precision) * entry;
    }
  }
  return numerator / denominator;
}

double determinant(const RoughPencil& pencil, double inertia) {
  const auto impedance = barnett_lothe_impedance<double>(
      pencil.q - inertia * RoughPencil::Square::Identity(3, 3), pencil.r, pencil.t, 1e-7, 60);
  if (!impedance) return -1;
  Eigen::Matrix3cd hermitian;
  hermitian.real() = impedance->re;
  hermitian.imag() = impedance->im;
  return hermitian.determinant().real();
}

constexpr auto surface_wave = "surface wave";

[[noreturn]] void refuse_proof(const SurfaceDirection& psi, const char* what) {
  throw data::BadInput(
      "solid", "(as given)",
      fmt::format("must be one whose {} in the direction psi = {:.6g} degrees can be proven: no "
                  "moduli many powers of ten apart, no surface wave next to the limiting speed",
                  what, psi.degrees()));
}

/// The inertia limit (1 - w^2), nearest < w < 1, at which a determinant is 0; nothing if it is not below 0 at `nearest`.
template <class Scalar, class Determinant>
std::optional<Scalar> wave_inertia(const SurfaceDirection& psi, const Scalar& limit,
                                   const Determinant& determinant_at, const Scalar& nearest,
                                   const Scalar& tolerance) {
  const auto inertia = [&](const Scalar& w) -> Scalar { return limit * (1 - w * w); };
  const auto f = [&](const Scalar& w) { return determinant_at(inertia(w)); };
  if (!(f(nearest) < 0)) return std::nullopt;
  const auto w = bracketed_root(f, Scalar(1), nearest, tolerance);
  if (!w) refuse_proof(psi, surface_wave);
  return inertia(*w);
}

Float power_of_two(mpfr_prec_t exponent) { return ldexp(Float(1), exponent); }

/// det M as an interval; nothing where the impedance is proven neither at this precision nor at a few times this
/// precision, which moduli that differ by many powers of ten need.
std::optional<Interval> determinant(const ExactStiffness& solid, const SurfaceDirection& psi,
                                    const Float& inertia, mpfr_prec_t precision) {
  constexpr int most_attempts = 3;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const auto impedance = surface_impedance(acoustic_matrices(solid, psi, interval_of(inertia, precision)));
    if (impedance) return hermitian_determinant(*impedance);
  }
  return std::nullopt;
}

/// The least number of bits for which a bracket of the root is below the limiting speed.
constexpr mpfr_prec_t fewest_bits = 48;

// Phase speeds as inertia = density speed^2/C33, enclosed to a relative width of about 2^-bits. BadInput "solid" where
// this is not proven, which happens if moduli differ by many powers of ten or a surface wave is close to the limiting
// speed.

/// The inertia at the limiting speed.
Interval limiting_inertia(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t bits) {
  const Valley valley(RoughPencil(at_rest(solid, psi, 64)));
  constexpr int most_attempts = 3;
  // The proof below contains powers of Im s, which is of the order of the square root of the distance to the limit.
  mpfr_prec_t precision = 3 * bits + 64;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const WorkingDigits working(digits_of(precision));
    const AcousticMatrices matrices = at_rest(solid, psi, precision);
    const AcousticPencil<Float> pencil(matrices);
    const Float s = valley.lowest_point(pencil, precision).first;
    const Interval quotient = rayleigh_quotient(matrices, s, pencil.lowest_vector(s));
    const Float below = middle_of(quotient) * (1 - power_of_two(-bits));
    if (surface_impedance(acoustic_matrices(solid, psi, interval_of(below, precision)))) {
      Float above = zero_of_bits(precision);
      mpfi_get_right(raw(above), quotient.get());
      return {below, above, precision};
    }
  }
  refuse_proof(psi, "limiting speed");
}

/// The inertia of the surface wave; nothing if no surface wave is slower than 1 - 2^(-bits - 8) of the limiting speed.
std::optional<Interval> surface_wave_inertia(const ExactStiffness& solid, const SurfaceDirection& psi,
                                             mpfr_prec_t wanted_bits) {
  const mpfr_prec_t bits = std::max(wanted_bits, fewest_bits), precision = 3 * bits + 64;
  const WorkingDigits working(digits_of(precision));
  const Float limit = middle_of(limiting_inertia(solid, psi, bits + 24));
  // Close to a direction in which the limiting wave has a traction-free surface, the surface wave is arbitrarily
  // close to the limiting speed.
  const auto root = wave_inertia<Float>(
      psi, limit,
      [&](const Float& inertia) {
        const auto value = determinant(solid, psi, inertia, precision);
        if (!value) refuse_proof(psi, surface_wave);
        return middle_of(*value);
      },
      power_of_two(-bits / 2 - 4), power_of_two(-bits - 8));
  if (!root) return std::nullopt;
  const auto proven = proven_bracket(*root, *root * power_of_two(-bits), *root * power_of_two(-bits / 2), 16,
                                     1, [&](const Float& at) {
                                       const auto value = determinant(solid, psi, at, precision);
                                       return value ? sign_of(*value) : 0;
                                     });
  if (!proven) refuse_proof(psi, surface_wave);
  return proven;
}

/// The surface wave's inertia, or the limiting one if there is no surface wave, to some 12 digits; not proven.
double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi) {
  const RoughPencil pencil(at_rest(solid, psi, 64));
  const double limit = Valley(pencil).lowest_point(pencil, std::numeric_limits<double>::digits).second;
  const auto determinant_at = [&](double inertia) { return determinant(pencil, inertia); };
  return wave_inertia<double>(psi, limit, determinant_at, 1e-4, 1e-13).value_or(limit);
}

/// Whether an inertia along psi is proven to be below that of the limiting speed and of the surface wave. The proof
/// fails close to them, at a distance far below the spacing of doubles.
bool is_subcritical(const ExactStiffness& solid, const SurfaceDirection& psi,
                    const std::function<Interval(mpfr_prec_t precision)>& inertia) {
  for (const mpfr_prec_t precision : {128, 256, 512}) {
    const auto impedance = surface_impedance(acoustic_matrices(solid, psi, inertia(precision)));
    if (impedance && is_positive_definite(*impedance)) return true;
  }
  return false;
}

mpfr_prec_t inertia_bits(double nats) { return static_cast<mpfr_prec_t>(nats / std::numbers::ln2) + 16; }

/// The speed of a load that has this inertia along psi.
Interval load_speed(const ExactStiffness& solid, const Interval& inertia, const Interval& cosine) {
  const Exact squared_unit(mpq_class(solid.voigt[2][2] / solid.density));
  return abs(sqrt(inertia * Interval(squared_unit, inertia.precision())) / cosine);
}

Interval oblique_cosine(const SurfaceDirection& motion, const SurfaceDirection& psi, mpfr_prec_t precision) {
  Interval cosine = cosine_between(motion, psi, precision);
  if (mpfi_has_zero(cosine.get()) > 0) {
    throw data::BadInput("psi", "perpendicular", "must not be perpendicular to the motion");
  }
  return cosine;
}

SurfaceDirection degrees(const Float& angle) { return SurfaceDirection::of_degrees(to_exact(angle)); }
SurfaceDirection degrees(double angle) { return SurfaceDirection::of_degrees(Exact(angle)); }

Enclosure critical_speed_along(const ExactStiffness& solid, const SurfaceDirection& motion,
                               const SurfaceDirection& psi, int digits) {
  auto wave = surface_wave_speed(solid, motion, psi, digits);
  return wave ? *std::move(wave) : limiting_speed(solid, motion, psi, digits);
}

double unit_of_speed(const ExactStiffness& solid) {
  return std::sqrt(Exact(mpq_class(solid.voigt[2][2] / solid.density)).approximate());
}

/// Bounds of the distance from the parabola's middle point to its vertex, in units of its width. Below the first the
/// vertex is accepted as the minimum; above the second the minimum is taken not to be smooth.
constexpr double widths_of_error = 10, farthest_vertex = 1e4;
constexpr int most_parabolas = 8;
/// The widths are 10^-4, 10^-8, 10^-16 ..., and the speeds need four times as many digits.
constexpr int most_critical_digits = 508;

[[noreturn]] void refuse_motion(const SurfaceDirection& motion) {
  throw data::BadInput("motion", fmt::format("{:.10g} degrees", motion.degrees()),
                       "must be one whose critical speed has a smooth minimum over the lines");
}

bool is_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                    const SurfaceDirection& psi) {
  return is_subcritical(solid, psi, [&](mpfr_prec_t precision) {
    return inertia_of(solid, speed, cosine_between(motion, psi, precision));
  });
}

/// A direction in degrees and the smallest speed at which its lines are critical, over sqrt(C33/density), to some 12
/// digits.
struct CriticalLine {
  double psi, speed;
};

constexpr double radian = std::numbers::pi / 180;

[[noreturn]] void refuse_moduli() {
  throw data::BadInput("solid", "(as given)", "must have moduli nearer to each other to search its lines");
}

/// A line, its critical speed along the motion, and the share of that speed at which it is proven to be subcritical.
struct Line {
  double psi, phase_speed, speed, proven;
};

/// Lines so close to each other that no line between them has a critical speed below the lowest found by more than a
/// given step.
/// Proof: ref/half_space/README.md, Critical speeds.
class Landscape {
 public:
  Landscape(const ExactStiffness& solid, const SurfaceDirection& motion) : solid_(solid), motion_(motion) {
    constexpr double most_apart = 3000;
    const double theta = motion.degrees();
    for (const double from_motion : {-90.0, 0.0, 90.0}) lines_.push_back(at(theta + from_motion));
    const double fastest = std::max(wave_bound(theta), wave_bound(theta + 90));
    if (fastest > most_apart * least_) refuse_moduli();
    for (const double step : {1e-3, 1e-6, 1e-9}) {
      const auto goes_on = [&] {
        return step == 1e-3 || (lines_.size() <= enough_lines && proven_ > (1 - step) * least_);
      };
      while (goes_on() && refine((1 - step) * least_))
        ;
    }
  }

  [[nodiscard]] std::vector<CriticalLine> bottoms() const {
    std::vector<CriticalLine> result;
    for (std::size_t i = 1; i + 1 < lines_.size(); ++i) {
      const Line &left = lines_[i - 1], &here = lines_[i], &right = lines_[i + 1];
      const bool is_bottom = here.speed <= left.speed && here.speed <= right.speed;
      const bool may_be_lowest =
          here.speed == least_ || !is_clear(left, here, least_) || !is_clear(here, right, least_);
      if (is_bottom && may_be_lowest) result.push_back(bottom(left.psi, here, right.psi));
    }
    return result;
  }

 private:
  /// Limits of lines: the second for the first step, the first for all others, so that only the first step can end in a
  /// refusal.
  static constexpr std::size_t enough_lines = 200, most_lines = 800;

  [[nodiscard]] double cosine(const SurfaceDirection& psi) const {
    return std::fabs(mpfi_get_d(cosine_between(motion_, psi, 64).get()));
  }

  Line at(double psi) {
    const SurfaceDirection direction = degrees(psi);
    const double inertia = approximate_critical_inertia(solid_, direction);
    const double phase_speed = std::sqrt(inertia), speed = phase_speed / cosine(direction);
    for (const double margin : {1e-10, 1e-7, 1e-4}) {
      const double slower = inertia * (1 - 2 * margin);
      if (!is_subcritical(solid_, direction,
                          [&](mpfr_prec_t precision) { return Interval(slower, precision); }))
        continue;
      least_ = std::min(least_, speed);
      proven_ = std::min(proven_, (1 - margin) * speed);
      return {psi, phase_speed, speed, 1 - margin};
    }
    refuse_proof(direction, "critical speed");
  }

  /// An upper bound of the speed of the fastest plane wave along psi, from the largest row sum of Christoffel's matrix.
  [[nodiscard]] double wave_bound(double psi) const {
    constexpr double rounding = 1e-12;
    const IntervalMatrix q = acoustic_matrices(solid_, degrees(psi), Interval(64)).q;
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(mpfi_get_d(q(i, k).re.get()));
      largest = std::max(largest, sum);
    }
    return (1 + rounding) * std::sqrt(largest);
  }

  /// The reserve g for a unit wave vector.
  static double reserve(const Line& line, double speed) {
    const double share = speed / (line.proven * line.speed);
    return line.proven * line.phase_speed * std::sqrt((1 - share) * (1 + share));
  }

  [[nodiscard]] bool is_clear(const Line& left, const Line& right, double speed) const {
    if (!(left.proven * left.speed > speed && right.proven * right.speed > speed)) return false;
    const double middle = (left.psi + right.psi) / 2;
    const double apart = 2 * std::sin((right.psi - left.psi) / 2 * radian);
    return reserve(left, speed) + reserve(right, speed) >= apart * wave_bound(middle + 90);
  }

  /// Halves the intervals that are not clear; false if there are none.
  bool refine(double speed) {
    std::vector<Line> finer{lines_.front()};
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i) {
      if (!is_clear(lines_[i], lines_[i + 1], speed))
        finer.push_back(at((lines_[i].psi + lines_[i + 1].psi) / 2));
      finer.push_back(lines_[i + 1]);
      if (finer.size() > most_lines) refuse_moduli();
    }
    const bool is_finer = finer.size() > lines_.size();
    lines_ = std::move(finer);
    return is_finer;
  }

  /// The minimum in a valley, by Brent's search over its width.
  [[nodiscard]] CriticalLine bottom(double left, const Line& lowest, double right) const {
    constexpr int bits = 20;
    const auto psi_at = [&](double share) {
      return lowest.psi + std::fabs(share) * ((share < 0 ? left : right) - lowest.psi);
    };
    const auto speed_at = [&](double share) {
      const SurfaceDirection direction = degrees(psi_at(share));
      return std::sqrt(approximate_critical_inertia(solid_, direction)) / cosine(direction);
    };
    std::uintmax_t most = 40;
    const auto [share, speed] = boost::math::tools::brent_find_minima(speed_at, -1.0, 1.0, bits, most);
    return speed < lowest.speed ? CriticalLine{psi_at(share), speed} : CriticalLine{lowest.psi, lowest.speed};
  }

  const ExactStiffness& solid_;
  const SurfaceDirection& motion_;
  std::vector<Line> lines_;
  double least_ = HUGE_VAL, proven_ = HUGE_VAL;
};

/// The local minima that may be the lowest. Apart from rounding in double it is proven that no line is lower by more
/// than 1e-3, 1e-6 or 1e-9 of the lowest: the smallest of these for which 200 lines suffice and to which the lines'
/// own speeds are proven. BadInput "solid" where the fastest wave along the surface is 3000 times as fast, where 800
/// lines do not suffice, or where no proof for a line is found.
std::vector<CriticalLine> lowest_lines(const ExactStiffness& solid, const SurfaceDirection& motion) {
  return Landscape(solid, motion).bottoms();
}

/// The smooth minimum next to psi.
CriticalSpeed bottom(const ExactStiffness& solid, const SurfaceDirection& motion, Float psi, int digits) {
  // A parabola of width h has an error of the order of h^2 in psi and h^4 in the speed. It is repeated about its vertex
  // where that was too far away.
  for (int width_digits = 4;; width_digits *= 2) {
    const int working_digits = std::max(digits, 4 * width_digits) + 8;
    const WorkingDigits working(working_digits + 16);
    const Float width = pow(Float(10), -width_digits);
    psi = at_working_precision(psi);
    const auto f = [&](const Float& angle) {
      return at_working_precision(critical_speed_along(solid, motion, degrees(angle), working_digits).value);
    };
    Float curvature = 0, vertex = widths_of_error;
    for (int attempt = 0; !(abs(vertex) < widths_of_error); ++attempt) {
      const Float left = f(psi - width), centre = f(psi), right = f(psi + width);
      curvature = left - 2 * centre + right;
      vertex = (left - right) / (2 * curvature);
      if (!(curvature > 0 && abs(vertex) < farthest_vertex && attempt < most_parabolas))
        refuse_motion(motion);
      psi += vertex * width;
    }
    if (4 * width_digits < digits + 10) continue;
    Estimate speed = critical_speed_along(solid, motion, degrees(psi), digits);
    const Float miss = curvature * pow(widths_of_error * width, 2);
    mpfr_add(raw(speed.error), raw(speed.error), raw(miss), MPFR_RNDU);
    speed.proven = false;  // the curvature is an estimate
    return {std::move(speed), static_cast<double>(psi)};
  }
}

/// The indices of the eigenvectors in the order of BulkWave; the eigenvalues are in ascending order.
std::array<Matrix::Index, 3> in_order(const Matrix& vectors) {
  Matrix::Index upright = 0;
  for (const Matrix::Index k : {1, 2}) {
    if (abs(vectors(2, k)) > abs(vectors(2, upright))) upright = k;
  }
  const Matrix::Index slower = upright == 0 ? 1 : 0, faster = upright == 2 ? 1 : 2;
  return {upright, faster, slower};
}

}  // namespace

Enclosure limiting_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                         const SurfaceDirection& psi, int digits) {
  return enclose(digits, 0, [&](double nats) {
    const Interval inertia = limiting_inertia(solid, psi, inertia_bits(nats));
    return load_speed(solid, inertia, oblique_cosine(motion, psi, inertia.precision()));
  });
}

std::optional<Enclosure> surface_wave_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                                            const SurfaceDirection& psi, int digits) {
  check_digits(digits);
  oblique_cosine(motion, psi, 4 * digits);
  if (!surface_wave_inertia(solid, psi, inertia_bits(digits * std::numbers::ln10))) return std::nullopt;
  return enclose(digits, 0, [&](double nats) {
    const auto inertia = surface_wave_inertia(solid, psi, inertia_bits(nats));
    if (!inertia) {
      throw data::BadInput("psi", fmt::format("{:.10g} degrees", psi.degrees()),
                           "must be a direction whose surface wave is farther from the limiting speed");
    }
    return load_speed(solid, *inertia, oblique_cosine(motion, psi, inertia->precision()));
  });
}

Enclosure separation_degrees(const ExactStiffness& solid, const Exact& speed, int digits) {
  const auto line = SurfaceDirection::of_degrees(Exact(0.0));
  return enclose(digits, 0, [&](double nats) {
    // Close to the speed of the wave the angle is proportional to the square root of the difference of the speeds.
    const auto inertia = surface_wave_inertia(solid, line, inertia_bits(2 * nats));
    if (!inertia) refuse_proof(line, surface_wave);
    const Interval wave = load_speed(solid, *inertia, Interval(1L, inertia->precision()));
    const Interval given(speed, wave.precision());
    if (mpfr_less_p(given.upper(), wave.lower()) != 0) {
      throw data::BadInput(
          "speed", speed.text(),
          fmt::format("must be at least {:.17g}, that of Rayleigh waves", mpfi_get_d(wave.get())));
    }
    Interval squared_sine = 1 - square(wave / given);
    if (mpfr_sgn(squared_sine.lower()) < 0) mpfr_set_zero(&squared_sine.get()->left, 1);
    return 180 * atan(sqrt(squared_sine) * given / wave) / Interval::pi(wave.precision());
  });
}

void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                       const SurfaceDirection& psi) {
  if (is_subcritical(solid, speed, motion, psi)) return;
  const double cosine = std::fabs(mpfi_get_d(cosine_between(motion, psi, 64).get()));
  throw data::BadInput(
      "speed", speed.text(),
      fmt::format("must be below {:.6g}, which is critical on lines {:.6g} degrees from the motion",
                  critical_speed_along(solid, motion, psi, 16).to_double(),
                  std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi));
}

void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion) {
  const CriticalLine line = std::ranges::min(lowest_lines(solid, motion), {}, &CriticalLine::speed);
  if (is_subcritical(solid, speed, motion, SurfaceDirection::of_degrees(Exact(line.psi)))) return;
  throw data::BadInput(
      "speed", speed.text(),
      fmt::format("must be below {:.10g}, which is critical on the line psi = {:.6g} degrees",
                  line.speed * unit_of_speed(solid), line.psi));
}

CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits) {
  if (digits < 16 || digits > most_critical_digits) {
    throw data::BadInput("digits", std::to_string(digits),
                         fmt::format("must be from 16 to {} for a critical speed", most_critical_digits));
  }
  std::optional<CriticalSpeed> least;
  for (const CriticalLine& line : lowest_lines(solid, motion)) {
    CriticalSpeed found = bottom(solid, motion, line.psi, digits);
    if (!least || mpfr_less_p(raw(found.speed.value), raw(least->speed.value)) != 0) least = std::move(found);
  }
  return *std::move(least);
}

Estimate bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                         int digits) {
  check_digits(digits);
  const mpfr_prec_t precision = static_cast<mpfr_prec_t>(3.33 * digits) + 128;
  const WorkingDigits working(digits_of(precision));
  const IntervalMatrix q = acoustic_matrices(solid, direction, Interval(precision)).q;
  const Matrix matrix = middle(q).re;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Float, 3, 3>> eigen(matrix);
  const Matrix vectors = eigen.eigenvectors();
  const Matrix::Index number = in_order(vectors)[static_cast<std::size_t>(wave)];
  const Vector vector = vectors.col(number);
  const Float eigenvalue = eigen.eigenvalues()(number);
  const Float residual = (matrix * vector - eigenvalue * vector).norm() / vector.norm();
  const Float modulus = to_float(solid.voigt[2][2]);
  const Float density = to_float(solid.density);
  const Float speed = sqrt(eigenvalue * modulus / density);
  // The speed has half the relative error of the eigenvalue, rounding included.
  const Float rounding = matrix.norm() * pow(Float(2), 16 - static_cast<long>(precision));
  const Float error = speed * (residual + rounding) / eigenvalue;
  return {speed, error, digits};
}

}  // namespace nipref::ref
