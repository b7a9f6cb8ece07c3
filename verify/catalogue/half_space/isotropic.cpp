// What isotropic half-spaces answer along lines, and their critical speed.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/line_entry.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using fast::LineResponse;
using fast::ShearResponse;
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

std::vector<Argument> line_arguments() {
  return {{"poisson", ArgumentKind::poisson, {}, {}},
          {"speed", ArgumentKind::nonnegative, {}, {}},
          {"psi_deg", ArgumentKind::degrees, "0", {}}};
}

template <class FastMember, class RefMember>
Quantity isotropic_line(std::string name, std::string definition, FastMember of_fast, RefMember of_ref) {
  Quantity entry =
      half_space_entry(std::move(name), std::move(definition), "brock2012 (18a), brock2013 (20)");
  entry.arguments = line_arguments();
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

/// Half-spaces answer to shear of both directions: also to that across the lines, which no sagittal motion has.
template <class FastMember, class RefMember>
Quantity isotropic_shear(std::string name, std::string definition, FastMember of_fast, RefMember of_ref,
                         SeedForm printed) {
  Quantity entry =
      half_space_entry(std::move(name), std::move(definition), "brock2012 (38), (39a) corrected");
  entry.arguments = line_arguments();
  draw_lines(entry);
  entry.by_ref = [of_ref](Exacts x, int digits) {
    const Line line(x);
    const ref::Exact unit(1.0);
    const auto solid =
        ref::exact_stiffness(ref::ExactTransverse::isotropic(unit, x[0], unit), data::SymmetryAxis::normal);
    // Near the critical speed the bounds are those of the compliance, which is much larger than what is across.
    const auto bound_over_value = [](const ref::Enclosure& found) {
      return mpfr_get_exp(found.error.get()) - mpfr_get_exp(found.value.get());
    };
    ref::Enclosure found = ref::line_response(solid, line.speed, line.motion, line.psi, digits).*of_ref;
    const auto asked = static_cast<long>(-digits / std::log10(2.0));
    if (const long lacking = bound_over_value(found) - asked; lacking > 0) {
      const int more = digits + 2 + static_cast<int>(static_cast<double>(lacking) * std::log10(2.0));
      found = ref::line_response(solid, line.speed, line.motion, line.psi, more).*of_ref;
      found.digits = digits;
    }
    return found;
  };
  set_fast(entry, [of_fast](Doubles x, Accuracy) {
    return fast::isotropic_shear_response(unit_isotropic(x[0]), x[1], fast::Direction::of_degrees(x[2])).*
           of_fast;
  });
  entry.seed_forms = {std::move(printed)};
  return entry;
}

Quantity entry_separation() {
  Quantity entry = half_space_entry(
      "halfspace.separation",
      "Psi_R, degrees: lines nearer to the motion see more than the Rayleigh speed, of which `speed` is beyond",
      "brock2012 (55)");
  entry.unit = "degree";
  // Its square is what the speed is beyond: two words of that, against one, leave so much at the first doubles beyond.
  entry.scale = "1e-5 or the value";
  entry.envelope = [](Doubles) { return 1e-5; };
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}}, {"speed", ArgumentKind::positive, {}, {}}};
  const auto next_to_rayleigh = [](double poisson) {
    return std::nextafter(fast::isotropic_rayleigh_speed(poisson), 1);
  };
  entry.draw = [=](Random& random) {
    const double poisson = draw_poisson(random), least = next_to_rayleigh(poisson);
    const double share = random.chance(0.5) ? random.log_uniform(1e-16, 1) : random.uniform(0, 1);
    return Point{poisson, least + share * (1 - least)};
  };
  entry.keep_off = [=](Point& x) {
    x[0] = std::clamp(x[0], -0.9, largest_poisson);
    x[1] = std::clamp(x[1], next_to_rayleigh(x[0]), 1.0);
  };
  entry.by_ref = [](Exacts x, int digits) {
    if (x[1].value() > 1)
      throw data::BadInput("speed", x[1].text(), "must be at most 1, that of shear waves");
    return ref::separation_degrees(exact_isotropic(x[0]), x[1], digits);
  };
  set_fast(entry,
           [](Doubles x, Accuracy) { return fast::separation_angle(x[0], x[1]) * (180 / std::numbers::pi); });
  return entry;
}

Quantity entry_condition() {
  Quantity entry = condition_entry("halfspace.condition", "of brock2012 (18a)");
  entry.arguments = line_arguments();
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
  constexpr auto in_line = "X wS/R: shear along such lines moves them, du/dx = -in_line H[tau], over 1/mu";
  constexpr auto across = "1/wS: shear across such lines moves them across, over 1/mu";
  constexpr auto coupling = "S of such lines: du3/dx = -K H[sigma33] - S tau, over 1/mu";
  return {
      isotropic_line("halfspace.compliance", compliance, &LineResponse::compliance,
                     &ref::LineResponse::compliance),
      isotropic_line("halfspace.coupling", coupling, &LineResponse::coupling, &ref::LineResponse::coupling),
      isotropic_shear("halfspace.in_line", in_line, &ShearResponse::in_line, &ref::LineResponse::in_line,
                      {"printed", "(39a) as it stands: M in place of R, which leaves nothing",
                       [](Doubles x) { return in_line_as_printed(x[0], x[1], x[2]); }}),
      isotropic_shear("halfspace.across", across, &ShearResponse::across, &ref::LineResponse::across,
                      {"printed", "(39a) as it stands: M in place of R",
                       [](Doubles x) { return across_as_printed(x[0], x[1], x[2]); }}),
      entry_condition(),
      entry_rayleigh(),
      entry_separation()};
}

}  // namespace nipref::verify
