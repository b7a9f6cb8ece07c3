#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <nipref/fast/half_space/internal/critical_speed.hpp>

namespace nipref::fast::internal {
namespace {

/// Over the lines, counted from the motion.
class CriticalSpeeds {
 public:
  CriticalSpeeds(const LineLimits& line, Direction motion) : line_(line), motion_(motion) {}

  double operator()(double from_motion) const { return speed_of_motion(line_, motion_, turned(from_motion)); }
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

/// The speed at some lines, in their order, where it may have its least value between any of them.
class Landscape {
 public:
  explicit Landscape(const CriticalSpeeds& speeds) : speeds_(speeds) {
    // A line of an odd number of steps, so that the line of motion is one of them. At both ends the speed is
    // infinite, so the lowest lines lie inside.
    constexpr int lines = 181;
    constexpr double step = std::numbers::pi / (lines + 1);
    for (int i = 1; i <= lines; ++i) points_.push_back(at(i * step - std::numbers::pi / 2));
    while (refine())
      ;
  }

  /// From the motion; the bottoms of all valleys that are nearly as low as the lowest.
  [[nodiscard]] std::vector<double> lowest() const {
    std::vector<double> result;
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
      const double speed = points_[i].speed;
      if (speed <= points_[i - 1].speed && speed <= points_[i + 1].speed && speed <= (1 + 1e-9) * least_)
        result.push_back(points_[i].from_motion);
    }
    return result;
  }

 private:
  struct Point {
    double from_motion, speed;
  };

  Point at(double from_motion) {
    const double speed = speeds_(from_motion);
    least_ = std::min(least_, speed);
    return {from_motion, speed};
  }

  /// Between points i and i + 1, were it nowhere steeper than twice the chords there and beyond. Branch points
  /// and Rayleigh waves that meet make valleys much narrower than a step, and these have steep sides.
  [[nodiscard]] double lower_bound(std::size_t i) const {
    const auto steepness = [&](std::size_t k) {
      return std::fabs(points_[k + 1].speed - points_[k].speed) /
             (points_[k + 1].from_motion - points_[k].from_motion);
    };
    const double steepest = 2 * std::max({steepness(i - 1), steepness(i), steepness(i + 1)});
    const Point &left = points_[i], &right = points_[i + 1];
    return (left.speed + right.speed - steepest * (right.from_motion - left.from_motion)) / 2;
  }

  /// Halves the intervals that may hold what is lower; false if there are none.
  bool refine() {
    constexpr double noise = 1e-13, narrowest = 1e-9;
    constexpr std::size_t most_points = 4000;
    std::vector<Point> finer{points_.front()};
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const double left = points_[i].from_motion, right = points_[i + 1].from_motion;
      const bool is_inner = i > 0 && i + 2 < points_.size();
      if (is_inner && right - left > narrowest && lower_bound(i) < (1 - noise) * least_)
        finer.push_back(at(left + (right - left) / 2));
      finer.push_back(points_[i + 1]);
    }
    const bool is_finer = finer.size() > points_.size();
    points_ = std::move(finer);
    return is_finer && points_.size() < most_points;
  }

  const CriticalSpeeds& speeds_;
  std::vector<Point> points_;
  double least_ = HUGE_VAL;
};

/// One step of Newton to the bottom of a smooth valley, its slope and curvature by differences in two words:
/// where valleys are narrow, comparing speeds in double leaves them too high.
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
  const double length = std::sqrt(squared_length(motion).high);
  return line.limit(psi) * length / std::fabs(cosine_between(psi, motion).high);
}

CriticalLine critical_line(const LineLimits& line, Direction motion) {
  const CriticalSpeeds speeds(line, motion);
  CriticalLine critical{HUGE_VAL, 0};
  for (double from_motion : Landscape(speeds).lowest()) {
    constexpr int steps = 3;
    for (int i = 0; i <= steps; ++i) {
      const double speed = speeds(from_motion);
      if (speed < critical.speed) critical = {speed, from_motion};
      from_motion = nearer_to_bottom(speeds, from_motion);
    }
  }
  return critical;
}

CriticalSpeed critical_speed(const CriticalLine& critical, Direction motion) {
  const double theta = std::atan2(motion.sine, motion.cosine);
  const double psi = std::remainder(theta + critical.from_motion, std::numbers::pi);
  return {critical.speed, psi == -std::numbers::pi / 2 ? -psi : psi};
}

}  // namespace nipref::fast::internal
