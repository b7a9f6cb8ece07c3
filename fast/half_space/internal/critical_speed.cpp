#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <nipref/fast/half_space/internal/critical_speed.hpp>

namespace nipref::fast::internal {
namespace {

// A line of an odd number of steps between -90 and 90 degrees, so that the line of motion is one of them.
constexpr int lines = 181;
constexpr double step = std::numbers::pi / (lines + 1);

Direction turned(Direction motion, double angle) {
  const Direction turn = Direction::of_angle(angle);
  return {motion.cosine * turn.cosine - motion.sine * turn.sine,
          motion.sine * turn.cosine + motion.cosine * turn.sine};
}

}  // namespace

double speed_of_motion(const TransverselyIsotropicLine& line, Direction motion, Direction psi) {
  const Two cosine = two_product(psi.cosine, motion.cosine) + two_product(psi.sine, motion.sine);
  return line.limit(psi) / std::fabs(rounded(cosine));
}

CriticalLine critical_line(const TransverselyIsotropicLine& line, Direction motion) {
  const auto speed = [&](double from_motion) {
    return speed_of_motion(line, motion, turned(motion, from_motion));
  };
  const auto angle = [](int index) { return (index + 1) * step - std::numbers::pi / 2; };
  std::array<double, lines> speeds;
  for (int i = 0; i < lines; ++i) speeds[static_cast<std::size_t>(i)] = speed(angle(i));

  CriticalLine critical{INFINITY, 0};
  const auto consider = [&](double candidate, double from_motion) {
    if (candidate < critical.speed) critical = {candidate, from_motion};
  };
  // At both ends the speed is infinite, so the lowest lines lie inside. All valleys are searched: where
  // branch points cross, there are several.
  for (std::size_t i = 1; i + 1 < lines; ++i) {
    if (speeds[i] > speeds[i - 1] || speeds[i] > speeds[i + 1]) continue;
    const double at = angle(static_cast<int>(i));
    consider(speeds[i], at);
    std::uintmax_t iterations = 100;
    const auto [place, value] =
        boost::math::tools::brent_find_minima(speed, at - step, at + step, 27, iterations);
    consider(value, place);
  }
  return critical;
}

}  // namespace nipref::fast::internal
