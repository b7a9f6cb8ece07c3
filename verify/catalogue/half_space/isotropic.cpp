// What isotropic half-spaces answer along lines, and their critical speed.
#include <algorithm>
#include <utility>

#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/line_entry.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using fast::LineResponse;
using ref::Exact;
using ref::SurfaceDirection;

constexpr double largest_poisson = 0.4999;

double draw_poisson(Random& random) {
  return random.chance(0.3) ? 0.5 - random.log_uniform(1e-4, 1) : random.uniform(-0.9, largest_poisson);
}

void draw_lines(Quantity& entry) {
  entry.draw = [](Random& random) {
    const double poisson = draw_poisson(random);
    return Point{poisson, draw_share(random) * fast::isotropic_rayleigh_speed(poisson), draw_degrees(random)};
  };
  entry.keep_off = [](Point& x) {
    x[0] = std::clamp(x[0], -0.9, largest_poisson);
    x[1] = std::min(x[1], nearest_critical * fast::isotropic_rayleigh_speed(x[0]));
  };
}

/// What ref takes: poisson, speed, psi_deg.
struct Line {
  ref::ExactStiffness solid;
  Exact speed;
  SurfaceDirection motion, psi;

  /// Refuses what is not subcritical: line_response() solves the equations beyond the Rayleigh speed too.
  explicit Line(Exacts x)
      : solid(exact_isotropic(x[0])),
        speed(x[1]),
        motion(SurfaceDirection::of_degrees(Exact(0.0))),
        psi(SurfaceDirection::of_degrees(x[2])) {
    ref::check_subcritical(solid, speed, motion, psi);
  }
};

template <class FastMember, class RefMember>
Quantity isotropic_line(std::string name, std::string definition, FastMember of_fast, RefMember of_ref) {
  Quantity entry =
      half_space_entry(std::move(name), std::move(definition), "brock2012 (18a), brock2013 (20)");
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}}};
  draw_lines(entry);
  entry.by_ref = [of_ref](Exacts x, int digits) {
    const Line line(x);
    return ref::line_response(line.solid, line.speed, line.motion, line.psi, digits).*of_ref;
  };
  set_fast(entry, [of_fast](Doubles x, Accuracy) {
    return fast::isotropic_response(unit_isotropic(x[0]), x[1], fast::Direction::of_degrees(x[2])).*of_fast;
  });
  return entry;
}

Quantity entry_condition() {
  Quantity entry = condition_entry("halfspace.condition", "of brock2012 (18a)");
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}}};
  entry.promise = 16;
  draw_lines(entry);
  entry.by_ref = [](Exacts x, int digits) {
    const Line line(x);
    return exact_condition(line.solid, line.speed, line.motion, line.psi, digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::isotropic_condition(unit_isotropic(x[0]), x[1], fast::Direction::of_degrees(x[2]));
  });
  return entry;
}

Quantity entry_rayleigh() {
  Quantity entry = half_space_entry("halfspace.rayleigh", "speed of Rayleigh waves over that of shear waves",
                                    "brock2012, root of R (16b)");
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}}};
  entry.draw = [](Random& random) { return Point{draw_poisson(random)}; };
  entry.keep_off = [](Point& x) { x[0] = std::clamp(x[0], -0.9, largest_poisson); };
  entry.by_ref = [](Exacts x, int digits) {
    const auto line = SurfaceDirection::of_degrees(Exact(0.0));
    return ref::surface_wave_speed(exact_isotropic(x[0]), line, line, digits).value();
  };
  set_fast(entry, [](Doubles x, Accuracy) { return fast::isotropic_rayleigh_speed(x[0]); });
  return entry;
}

}  // namespace

std::vector<Quantity> half_space_entries() {
  constexpr auto compliance = "K of lines at psi from the motion, speed in that of shear waves, over 1/mu";
  constexpr auto coupling = "S of such lines: du3/dx = -K H[sigma33] - S tau, over 1/mu";
  return {
      isotropic_line("halfspace.compliance", compliance, &LineResponse::compliance,
                     &ref::LineResponse::compliance),
      isotropic_line("halfspace.coupling", coupling, &LineResponse::coupling, &ref::LineResponse::coupling),
      entry_condition(), entry_rayleigh()};
}

}  // namespace nipref::verify
