#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

mpfr_prec_t inertia_bits(double nats) { return static_cast<mpfr_prec_t>(nats / std::numbers::ln2) + 16; }

/// The speed of a load whose phase speed on a line has this inertia. `cosine` is that between motion and line.
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

/// A direction in degrees and the critical speed of its lines over sqrt(C33/density), to about 12 digits.
struct CriticalLine {
  double psi, speed;
};

constexpr double radian = std::numbers::pi / 180;

[[noreturn]] void refuse_moduli() {
  throw data::BadInput("solid", "(as given)", "must have moduli nearer to each other to search its lines");
}

/// A line, its critical phase speed and load speed, and the fraction of both at which it is proven to be subcritical.
struct Line {
  double psi, phase_speed, speed, proven;
};

/// Lines so close to each other that no line between them has a critical speed that is lower than the lowest found by
/// more than a given step. Proof: ref/half_space/README.md, Critical speeds.
class LineGrid {
 public:
  LineGrid(const ExactStiffness& solid, const SurfaceDirection& motion) : solid_(solid), motion_(motion) {
    constexpr double most_apart = 3000;
    const double theta = motion.degrees();
    for (const double from_motion : {-90.0, 0.0, 90.0}) lines_.push_back(at(theta + from_motion));
    const double fastest = std::max(wave_bound(theta), wave_bound(theta + 90));
    if (fastest > most_apart * least_) refuse_moduli();
    while (refine(1e-3))
      ;
    for (const double step : {1e-6, 1e-9}) {
      while (lines_.size() <= enough_lines && proven_ > (1 - step) * least_ && refine(step))
        ;
    }
  }

  /// The local minima that may be the lowest.
  [[nodiscard]] std::vector<CriticalLine> minima() const {
    std::vector<CriticalLine> result;
    for (std::size_t i = 1; i + 1 < lines_.size(); ++i) {
      const Line &left = lines_[i - 1], &here = lines_[i], &right = lines_[i + 1];
      const bool is_minimum = here.speed <= left.speed && here.speed <= right.speed;
      const bool may_be_lowest =
          here.speed == least_ || !is_clear(left, here, least_) || !is_clear(here, right, least_);
      if (is_minimum && may_be_lowest) result.push_back(minimum_between(left.psi, here, right.psi));
    }
    return result;
  }

 private:
  /// The largest numbers of lines: most_lines for the first step, enough_lines for the others. Only the first step
  /// refuses a solid for which most_lines do not suffice.
  static constexpr std::size_t enough_lines = 200, most_lines = 800;

  [[nodiscard]] double cosine(const SurfaceDirection& psi) const {
    return std::fabs(mpfi_get_d(cosine_between(motion_, psi, 64).get()));
  }

  Line at(double psi) {
    const SurfaceDirection direction = degrees(psi);
    const double inertia = approximate_critical_inertia(solid_, direction);
    const double phase_speed = std::sqrt(inertia), speed = phase_speed / cosine(direction);
    for (const double margin : {1e-10, 1e-7, 1e-4}) {
      const double slower = inertia * (1 - margin) * (1 - margin);
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

  /// The reserve g of the proof for a unit wave vector and a load of this speed.
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

  /// Halves the intervals between lines that may contain a line whose speed is lower than the lowest by more than the
  /// step; returns false if there are none.
  bool refine(double step) {
    const double speed = (1 - step) * least_;
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

  /// The minimum between `left` and `right`, by Brent's method.
  [[nodiscard]] CriticalLine minimum_between(double left, const Line& lowest, double right) const {
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
/// than 1e-3, 1e-6 or 1e-9 of the lowest. The smallest of these steps is taken for which 200 lines suffice and to which
/// the speeds of the lines are proven. BadInput "solid" if the fastest wave along the surface is 3000 times as fast, if
/// 800 lines do not suffice for the step 1e-3, or if no proof is found for a line.
std::vector<CriticalLine> lowest_lines(const ExactStiffness& solid, const SurfaceDirection& motion) {
  return LineGrid(solid, motion).minima();
}

/// The smooth minimum next to psi.
CriticalSpeed smooth_minimum(const ExactStiffness& solid, const SurfaceDirection& motion, Float psi,
                             int digits) {
  // The vertex of a parabola of width h, at most 10 h from its middle point, is off by at most 50 h^2 c/b, where b and
  // c are the second and the third derivative. So the speed found is too high by at most 1250 h^4 c^2/b. The error
  // stated is 100 h^4 b, which covers |c/b| up to 0.28 per degree. If the vertex is farther, a new parabola is taken
  // about it.
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
    // Close to the speed of the wave, the angle is proportional to the square root of the difference of the speeds.
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
      fmt::format("must be below {}, which is critical on lines {:.6g} degrees from the motion",
                  critical_speed_along(solid, motion, psi, 16).to_double(),
                  std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi));
}

void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion) {
  const CriticalLine line = std::ranges::min(lowest_lines(solid, motion), {}, &CriticalLine::speed);
  if (is_subcritical(solid, speed, motion, SurfaceDirection::of_degrees(Exact(line.psi)))) return;
  throw data::BadInput("speed", speed.text(),
                       fmt::format("must be below {}, which is critical on the line psi = {:.6g} degrees",
                                   line.speed * unit_of_speed(solid), line.psi));
}

CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits) {
  if (digits < 16 || digits > most_critical_digits) {
    throw data::BadInput("digits", std::to_string(digits),
                         fmt::format("must be from 16 to {} for a critical speed", most_critical_digits));
  }
  std::optional<CriticalSpeed> least;
  for (const CriticalLine& line : lowest_lines(solid, motion)) {
    CriticalSpeed found = smooth_minimum(solid, motion, line.psi, digits);
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
  // The relative error of the speed is half that of the eigenvalue; the other half is a margin. Entries and residual
  // are rounded by some ten units of the norm, of which 2^16 is an upper bound.
  const Float rounding = matrix.norm() * pow(Float(2), 16 - static_cast<long>(precision));
  const Float error = speed * (residual + rounding) / eigenvalue;
  return {speed, error, digits};
}

}  // namespace nipref::ref
