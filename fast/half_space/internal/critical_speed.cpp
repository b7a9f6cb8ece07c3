#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <nipref/fast/half_space/internal/critical_speed.hpp>

namespace nipref::fast::internal {
namespace {

/// The speed along the motion at which the line psi has the speed `limit` of LineLimits.
double along_motion(double limit, Direction motion, Direction psi) {
  return limit * std::sqrt(squared_length(motion).high) / std::fabs(cosine_between(psi, motion).high);
}

/// The line at an angle from the motion, and its critical speeds along itself and along the motion.
struct CriticalLine {
  double from_motion, phase_speed, speed;
};

/// The critical speeds of the lines as a function of the angle between line and motion.
class CriticalSpeeds {
 public:
  CriticalSpeeds(const LineLimits& line, Direction motion) : line_(line), motion_(motion) {}

  [[nodiscard]] CriticalLine at(double from_motion) const {
    const Direction psi = turned(from_motion);
    const double limit = line_.limit(psi);
    return {from_motion, limit, along_motion(limit, motion_, psi)};
  }
  [[nodiscard]] Two in_two_words(double from_motion) const {
    const Direction psi = turned(from_motion);
    const Two cosine = cosine_between(psi, motion_);
    return line_.limit_in_two_words(psi) / (cosine.high < 0 ? -cosine : cosine);
  }

 private:
  [[nodiscard]] Direction turned(double from_motion) const {
    return Direction::of_angle(from_motion).turned(motion_);
  }

  const LineLimits& line_;
  Direction motion_;
};

/// Two lines and, between them, a line whose critical speed is not above theirs.
struct Bracket {
  double left, lowest, right;  ///< angles from the motion
};

/// Lines over half a turn, in order. An interval between neighbours is clear for a speed if this speed is proven to be
/// subcritical for all lines of the interval.
///
/// Let a field of the half-space be proportional to exp(i k.x) along the surface. Its strain is linear in k. Hence its
/// energy at (1 - t) k1 + t k2 is the weighted mean of the energies at k1 and k2 minus t (1 - t) times the energy of a
/// plane wave with the wave vector k2 - k1. Let w be the frequency at which a line with the wave vector k is critical.
/// Then a load of the velocity V is subcritical for all lines between the unit vectors k1 and k2 if
/// sqrt(w1^2 - (V.k1)^2) + sqrt(w2^2 - (V.k2)^2) is at least the frequency of the fastest wave with wave vector k2 - k1.
class LineGrid {
 public:
  LineGrid(const CriticalSpeeds& speeds, const AnisotropicLine& waves, Direction motion,
           std::size_t most_lines)
      : speeds_(speeds), waves_(waves), motion_(motion), most_lines_(most_lines) {
    constexpr double quarter = std::numbers::pi / 2, most_apart = 3000;
    for (const double from_motion : {-quarter, 0.0, quarter}) lines_.push_back(at(from_motion));
    if (wave_bound(0) > most_apart * least_ || wave_bound(quarter) > most_apart * least_) refuse_moduli();
  }

  /// Halves intervals until all are clear for the lowest critical speed found less this share of it, or until there are
  /// more lines than `enough`.
  void refine_to(double share, std::size_t enough) {
    while (lines_.size() <= enough && halve_unclear((1 - share) * least_))
      ;
  }

  /// All brackets that may contain the minimum.
  [[nodiscard]] std::vector<Bracket> brackets() const {
    std::vector<Bracket> result;
    for (std::size_t i = 1; i + 1 < lines_.size(); ++i) {
      const CriticalLine &left = lines_[i - 1], &here = lines_[i], &right = lines_[i + 1];
      const bool is_bracket = here.speed <= left.speed && here.speed <= right.speed;
      const bool may_be_lowest =
          here.speed == least_ || !is_clear(left, here, least_) || !is_clear(here, right, least_);
      if (is_bracket && may_be_lowest)
        result.push_back({left.from_motion, here.from_motion, right.from_motion});
    }
    return result;
  }

 private:
  [[noreturn]] static void refuse_moduli() {
    throw data::BadInput("solid", "(as given)", "must have moduli nearer to each other to search its lines");
  }

  CriticalLine at(double from_motion) {
    const CriticalLine line = speeds_.at(from_motion);
    least_ = std::min(least_, line.speed);
    return line;
  }

  [[nodiscard]] double wave_bound(double from_motion) const {
    return waves_.wave_bound(Direction::of_angle(from_motion).turned(motion_));
  }

  /// sqrt(w^2 - (V.k)^2)
  static double reserve(const CriticalLine& line, double speed) {
    const double share = speed / line.speed;
    return line.phase_speed * std::sqrt((1 - share) * (1 + share));
  }

  /// Evaluated in double.
  [[nodiscard]] bool is_clear(const CriticalLine& left, const CriticalLine& right, double speed) const {
    if (!(left.speed > speed && right.speed > speed)) return false;
    const double half = (right.from_motion - left.from_motion) / 2;
    const double across = left.from_motion + half + std::numbers::pi / 2;
    return reserve(left, speed) + reserve(right, speed) >= 2 * std::sin(half) * wave_bound(across);
  }

  /// Halves the intervals that are not clear; returns false if there are none.
  bool halve_unclear(double speed) {
    std::vector<CriticalLine> finer{lines_.front()};
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i) {
      const CriticalLine &left = lines_[i], &right = lines_[i + 1];
      if (!is_clear(left, right, speed))
        finer.push_back(at(left.from_motion + (right.from_motion - left.from_motion) / 2));
      finer.push_back(right);
      if (finer.size() > most_lines_) refuse_moduli();
    }
    const bool is_finer = finer.size() > lines_.size();
    lines_ = std::move(finer);
    return is_finer;
  }

  const CriticalSpeeds& speeds_;
  const AnisotropicLine& waves_;
  Direction motion_;
  std::size_t most_lines_;
  std::vector<CriticalLine> lines_;
  double least_ = HUGE_VAL;  ///< the lowest critical speed found
};

/// The minimum in a bracket, by Brent's search. A critical frequency is a minimum over functions that are quadratic in the
/// wave vector, so that minima are smooth and their curvature is bounded by the fastest wave.
double minimum_in(const Bracket& bracket, const CriticalSpeeds& speeds) {
  constexpr int bits = 26;
  const auto angle = [&](double share) {
    const double end = share < 0 ? bracket.left : bracket.right;
    return bracket.lowest + std::fabs(share) * (end - bracket.lowest);
  };
  std::uintmax_t most = 60;
  const auto found = boost::math::tools::brent_find_minima(
      [&](double share) { return speeds.at(angle(share)).speed; }, -1.0, 1.0, bits, most);
  return angle(found.first);
}

/// One Newton step towards the minimum, with slope and curvature from differences in two words, because rounding errors
/// of double would leave a narrow minimum too high.
double newton_step(const CriticalSpeeds& speeds, double from_motion) {
  constexpr double step = 0x1p-28, farthest = 0x1p-18;
  const Two here = speeds.in_two_words(from_motion);
  const double above = (speeds.in_two_words(from_motion + step) - here).high;
  const double below = (speeds.in_two_words(from_motion - step) - here).high;
  const double move = step * (below - above) / (2 * (above + below));
  return above + below > 0 && std::fabs(move) < farthest ? from_motion + move : from_motion;
}

}  // namespace

double speed_of_motion(const LineLimits& line, Direction motion, Direction psi) {
  return along_motion(line.limit(psi), motion, psi);
}

CriticalSpeed critical_at(double speed, double from_motion, Direction motion) {
  const double theta = std::atan2(motion.sine, motion.cosine);
  const double psi = std::remainder(theta + from_motion, std::numbers::pi);
  return {speed, psi == -std::numbers::pi / 2 ? -psi : psi};
}

CriticalSpeed critical_speed(const LineLimits& line, const AnisotropicLine& waves, Direction motion,
                             std::size_t most_lines) {
  const CriticalSpeeds speeds(line, motion);
  double least = HUGE_VAL, at = 0;
  const auto keep_lower = [&](double from_motion) {
    const double speed = speeds.at(from_motion).speed;
    if (speed < least) {
      least = speed;
      at = from_motion;
    }
  };
  LineGrid lines(speeds, waves, motion, most_lines);
  lines.refine_to(1e-3, most_lines);
  // At most half of what the callers allow, so that only the first share can end in a refusal.
  constexpr std::size_t enough_lines = 400;
  for (const double share : {1e-6, 1e-9, 1e-12}) lines.refine_to(share, enough_lines);
  for (const Bracket& bracket : lines.brackets()) {
    constexpr int steps = 3;
    keep_lower(bracket.lowest);
    double from_motion = minimum_in(bracket, speeds);
    for (int i = 0; i <= steps; ++i) {
      keep_lower(from_motion);
      from_motion = newton_step(speeds, from_motion);
    }
  }
  return critical_at(least, at, motion);
}

data::BadInput supercritical(double speed, const CriticalSpeed& critical) {
  return {"speed", speed,
          fmt::format("must be below {}, which is critical on the line psi = {:.6g} degrees", critical.speed,
                      critical.psi * 180 / std::numbers::pi)};
}

}  // namespace nipref::fast::internal
