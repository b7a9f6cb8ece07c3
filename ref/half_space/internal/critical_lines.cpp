#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/critical_lines.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>

namespace nipref::ref {
namespace {

SurfaceDirection degrees(double angle) { return SurfaceDirection::of_degrees(Exact(angle)); }

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

}  // namespace

std::vector<CriticalLine> lowest_lines(const ExactStiffness& solid, const SurfaceDirection& motion) {
  return Landscape(solid, motion).bottoms();
}

}  // namespace nipref::ref
