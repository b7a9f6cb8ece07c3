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

/// The critical speeds of the lines as a function of the angle between line and motion.
class CriticalSpeeds {
 public:
  CriticalSpeeds(const LineLimits& line, Direction motion) : line_(line), motion_(motion) {}

  double operator()(double from_motion) const { return both(from_motion).second; }
  /// The critical speed along the line, and the corresponding speed along the motion.
  [[nodiscard]] std::pair<double, double> both(double from_motion) const {
    const Direction psi = turned(from_motion);
    const double limit = line_.limit(psi);
    return {limit, along_motion(limit, motion_, psi)};
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

/// A sequence of lines so close to each other that, up to a given relative step, no line between them has a critical
/// speed below the lowest found.
///
/// Let a field of the half-space be proportional to exp(i k.x) along the surface. Its strain is linear in k. Hence its
/// energy at (1 - t) k1 + t k2 is the weighted mean of the energies at k1 and k2 minus t (1 - t) times the energy of a
/// plane wave with the wave vector k2 - k1. Let w be the frequency at which a line with the wave vector k is critical.
/// Then a load of the velocity V is subcritical for all lines between the unit vectors k1 and k2 if
/// sqrt(w1^2 - (V.k1)^2) + sqrt(w2^2 - (V.k2)^2) is at least the frequency of the fastest wave with wave vector k2 - k1.
class Landscape {
 public:
  Landscape(const CriticalSpeeds& speeds, const AnisotropicLine& waves, Direction motion,
            std::size_t most_lines)
      : speeds_(speeds), waves_(waves), motion_(motion), most_lines_(most_lines) {
    constexpr double quarter = std::numbers::pi / 2, most_apart = 3000;
    for (const double from_motion : {-quarter, 0.0, quarter}) lines_.push_back(at(from_motion));
    if (wave_bound(0) > most_apart * least_ || wave_bound(quarter) > most_apart * least_) refuse_moduli();
    for (const double step : {1e-3, 1e-6, 1e-9, 1e-12}) {
      while ((step == 1e-3 || lines_.size() <= enough_lines) && refine((1 - step) * least_))
        ;
    }
  }

  /// The line with the lowest critical speed found in a valley, and its neighbours.
  struct Valley {
    double left, lowest, right;
  };
  /// All valleys that may contain the minimum.
  [[nodiscard]] std::vector<Valley> lowest() const {
    std::vector<Valley> result;
    for (std::size_t i = 1; i + 1 < lines_.size(); ++i) {
      const Line &left = lines_[i - 1], &here = lines_[i], &right = lines_[i + 1];
      const bool is_bottom = here.speed <= left.speed && here.speed <= right.speed;
      const bool may_be_lowest =
          here.speed == least_ || !is_clear(left, here, least_) || !is_clear(here, right, least_);
      if (is_bottom && may_be_lowest)
        result.push_back({left.from_motion, here.from_motion, right.from_motion});
    }
    return result;
  }

 private:
  /// Steps after the first stop refining when there are more lines than this, at most half of what the caller allows.
  /// Only the first step can therefore end in a refusal.
  static constexpr std::size_t enough_lines = 400;

  struct Line {
    double from_motion;
    double phase_speed, speed;  ///< the critical speeds along the line and along the motion
  };

  [[noreturn]] static void refuse_moduli() {
    throw data::BadInput("solid", "(as given)", "must have moduli nearer to each other to search its lines");
  }

  Line at(double from_motion) {
    const auto [phase_speed, speed] = speeds_.both(from_motion);
    least_ = std::min(least_, speed);
    return {from_motion, phase_speed, speed};
  }

  [[nodiscard]] double wave_bound(double from_motion) const {
    return waves_.wave_bound(Direction::of_angle(from_motion).turned(motion_));
  }

  /// sqrt(w^2 - (V.k)^2)
  static double reserve(const Line& line, double speed) {
    const double share = speed / line.speed;
    return line.phase_speed * std::sqrt((1 - share) * (1 + share));
  }

  /// Whether all lines between these two are subcritical, evaluated in double.
  [[nodiscard]] bool is_clear(const Line& left, const Line& right, double speed) const {
    if (!(left.speed > speed && right.speed > speed)) return false;
    const double half = (right.from_motion - left.from_motion) / 2;
    const double across = left.from_motion + half + std::numbers::pi / 2;
    return reserve(left, speed) + reserve(right, speed) >= 2 * std::sin(half) * wave_bound(across);
  }

  /// Halves the intervals that are not clear; returns false if there are none.
  bool refine(double speed) {
    std::vector<Line> finer{lines_.front()};
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i) {
      const Line &left = lines_[i], &right = lines_[i + 1];
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
  std::vector<Line> lines_;
  double least_ = HUGE_VAL;
};

/// The minimum in a valley, by Brent's search over its width. A critical frequency is a minimum over functions that are
/// quadratic in the wave vector, so that minima are smooth and their curvature is bounded by the fastest wave.
double bottom_of(const CriticalSpeeds& speeds, const Landscape::Valley& valley) {
  constexpr int bits = 26;
  const auto at = [&](double share) {
    const double end = share < 0 ? valley.left : valley.right;
    return valley.lowest + std::fabs(share) * (end - valley.lowest);
  };
  std::uintmax_t most = 60;
  const auto found = boost::math::tools::brent_find_minima([&](double share) { return speeds(at(share)); },
                                                           -1.0, 1.0, bits, most);
  return at(found.first);
}

/// One Newton step towards the minimum, with slope and curvature from differences in two words, because in a narrow
/// valley rounding errors of double would leave the minimum too high.
double nearer_to_bottom(const CriticalSpeeds& speeds, double from_motion) {
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
    const double speed = speeds(from_motion);
    if (speed < least) {
      least = speed;
      at = from_motion;
    }
  };
  for (const Landscape::Valley& valley : Landscape(speeds, waves, motion, most_lines).lowest()) {
    constexpr int steps = 3;
    keep_lower(valley.lowest);
    double from_motion = bottom_of(speeds, valley);
    for (int i = 0; i <= steps; ++i) {
      keep_lower(from_motion);
      from_motion = nearer_to_bottom(speeds, from_motion);
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
