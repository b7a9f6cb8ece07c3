// What half-spaces of any anisotropy answer along lines, and their critical speed. (brock2013 A.1-A.5)
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/line_entry.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using fast::Direction;
using ref::Exact;
using ref::SurfaceDirection;

// Arguments: theta_deg, then psi_deg and speed where they have them, then the 21 constants row by row of the upper
// triangle of Voigt's matrix, then the density.

constexpr std::size_t constants = 21, of_line = 3;

/// Voigt's row and column of each constant.
constexpr auto places = [] {
  std::array<std::pair<std::size_t, std::size_t>, constants> all{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = i; k < 6; ++k) all[next++] = {i, k};
  return all;
}();

data::Stiffness stiffness_at(Doubles x, std::size_t at) {
  data::Stiffness solid{{}, x[at + constants]};
  for (std::size_t n = 0; n < constants; ++n) {
    const auto [i, k] = places[n];
    solid.voigt[i][k] = solid.voigt[k][i] = x[at + n];
  }
  return solid;
}

ref::ExactStiffness exact_stiffness_at(Exacts x, std::size_t at) {
  Point nearest;
  for (const Exact& argument : x) nearest.push_back(argument.approximate());
  stiffness_at(nearest, at).check();
  ref::ExactStiffness solid;
  solid.density = x[at + constants].value();
  for (std::size_t n = 0; n < constants; ++n) {
    const auto [i, k] = places[n];
    solid.voigt[i][k] = solid.voigt[k][i] = x[at + n].value();
  }
  return solid;
}

/// The seed's graphite epoxy, its axis along x2; in g/cm^3 speeds are in km/s.
data::Stiffness epoxy() {
  data::Stiffness solid = data::Stiffness::of(data::seed::graphite_epoxy, data::SymmetryAxis::in_plane);
  solid.density = 1.688;
  return solid;
}

void append_stiffness_arguments(std::vector<Argument>& arguments) {
  const data::Stiffness standard = epoxy();
  for (const auto& [i, k] : places) {
    arguments.push_back({fmt::format("c{}{}", i + 1, k + 1),
                         i == k ? ArgumentKind::positive : ArgumentKind::amplitude,
                         fmt::format("{:.15g}", standard.voigt[i][k]),
                         {}});
  }
  arguments.push_back({"density", ArgumentKind::positive, fmt::format("{}", standard.density), {}});
}

void append_stiffness(Point& x, const data::Stiffness& solid) {
  for (const auto& [i, k] : places) x.push_back(solid.voigt[i][k]);
  x.push_back(solid.density);
}

using Factor = data::Stiffness::Voigt;

/// The product with its transpose, symmetric to the last bit.
data::Stiffness squared(const Factor& factor, double density) {
  data::Stiffness solid{{}, density};
  for (const auto& [i, k] : places) {
    double sum = 0;
    for (std::size_t j = 0; j < 6; ++j) sum += factor[i][j] * factor[k][j];
    solid.voigt[i][k] = solid.voigt[k][i] = sum;
  }
  return solid;
}

/// Triclinic, monoclinic about x3, orthotropic: moduli over one decade or three; now and then the seed's.
data::Stiffness draw_stiffness(Random& random) {
  if (random.chance(0.1)) return epoxy();
  const double spread = random.chance(0.3) ? 30 : 4;
  const std::size_t symmetry = random.index(3);
  const auto is_coupled = [&](std::size_t i, std::size_t k) {
    if (symmetry == 0 || i == k) return true;
    const bool in_plane[] = {true, true, true, false, false, true};  // parity in x3
    return symmetry == 1 ? in_plane[i] == in_plane[k] : i < 3 && k < 3;
  };
  Factor factor{};
  for (std::size_t i = 0; i < 6; ++i) {
    const double size = random.log_uniform(1, spread);
    for (std::size_t k = 0; k <= i; ++k)
      factor[i][k] = !is_coupled(i, k) ? 0 : i == k ? size : size * random.uniform(-0.6, 0.6);
  }
  return squared(factor, random.log_uniform(0.5, 20));
}

bool is_physical_stiffness(Doubles x, std::size_t at) {
  try {
    stiffness_at(x, at).check();
    return true;
  } catch (const data::BadInput&) {
    return false;
  }
}

/// In x, from `at` on.
void put_stiffness(Point& x, std::size_t at, const data::Stiffness& solid) {
  x.resize(at);
  append_stiffness(x, solid);
}

/// At which the line is critical; finite across the motion too.
double largest_speed(Doubles x) {
  return std::min(1e12, fast::rayleigh_speed(stiffness_at(x, of_line), Direction::of_degrees(x[0]),
                                             Direction::of_degrees(x[1])));
}

fast::AnisotropicHalfSpace anisotropic_surface(Doubles x) {
  return {stiffness_at(x, of_line), Direction::of_degrees(x[0]), x[2]};
}

double largest_answer(Doubles x) {
  const auto surface = anisotropic_surface(x);
  const Direction psi = Direction::of_degrees(x[1]);
  const auto [in_line, across] = surface.shear_along(psi);
  return std::max({surface.along(psi).compliance, in_line, across});
}

template <class Fast, class RefMember>
Quantity anisotropic_line(std::string name, std::string definition, Fast of_fast, RefMember of_ref) {
  Quantity entry = half_space_entry(std::move(name), std::move(definition), "brock2013 (A.1)-(A.5)");
  entry.unit = "1/stress";
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}}};
  append_stiffness_arguments(entry.arguments);
  entry.scale = "the largest of compliance, in_line and across";
  entry.draw = [](Random& random) {
    Point x{draw_degrees(random), draw_degrees(random), 0};
    append_stiffness(x, draw_stiffness(random));
    x[2] = draw_share(random) * largest_speed(x);
    return x;
  };
  entry.keep_off = [](Point& x) {
    if (!is_physical_stiffness(x, of_line)) put_stiffness(x, of_line, epoxy());
    x[2] = std::min(x[2], nearest_critical * largest_speed(x));
  };
  entry.by_ref = [of_ref](Exacts x, int digits) {
    const ref::ExactStiffness solid = exact_stiffness_at(x, of_line);
    const auto motion = SurfaceDirection::of_degrees(x[0]), psi = SurfaceDirection::of_degrees(x[1]);
    ref::check_subcritical(solid, x[2], motion, psi);
    return ref::line_response(solid, x[2], motion, psi, digits).*of_ref;
  };
  set_fast(entry, [of_fast](Doubles x, Accuracy) {
    return of_fast(anisotropic_surface(x), Direction::of_degrees(x[1]));
  });
  entry.envelope = largest_answer;
  return entry;
}

auto member(double fast::LineResponse::*of) {
  return [of](const fast::AnisotropicHalfSpace& surface, Direction psi) { return surface.along(psi).*of; };
}

auto member(double fast::ShearResponse::*of) {
  return
      [of](const fast::AnisotropicHalfSpace& surface, Direction psi) { return surface.shear_along(psi).*of; };
}

/// Near isotropic: in others the line that is critical first may be so by a bulk wave, or all but, and the reference
/// proves the speed of surface waves.
data::Stiffness draw_mild_stiffness(Random& random) {
  const data::Stiffness isotropic =
      data::Stiffness::of(data::IsotropicSolid{random.log_uniform(1, 100), random.uniform(0, 0.4), 1});
  const double size = 0.15 * std::sqrt(isotropic.voigt[5][5]);
  Factor factor{};
  for (auto& row : factor)
    for (double& entry : row) entry = random.uniform(-size, size);
  data::Stiffness solid = squared(factor, random.log_uniform(0.5, 20));
  for (const auto& [i, k] : places)
    solid.voigt[k][i] = solid.voigt[i][k] = solid.voigt[i][k] + isotropic.voigt[i][k];
  return solid;
}

Quantity entry_anisotropic_critical() {
  Quantity entry = half_space_entry("anisotropic.critical", "smallest speed at which some line is critical",
                                    "brock2013 (46), for all solids and lines, surface waves included");
  entry.unit = "sqrt(stress/density)";
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}}};
  append_stiffness_arguments(entry.arguments);
  entry.promise = 16;
  entry.audit_points = 6;
  entry.draw = [](Random& random) {
    Point x{random.uniform(-90, 90)};
    append_stiffness(x, random.chance(0.2) ? epoxy() : draw_mild_stiffness(random));
    return x;
  };
  // The search's steps would leave the mild ones.
  entry.keep_off = [](Point& x) {
    if (!is_physical_stiffness(x, 1)) put_stiffness(x, 1, epoxy());
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::critical_speed(exact_stiffness_at(x, 1), SurfaceDirection::of_degrees(x[0]), digits).speed;
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::critical_speed(stiffness_at(x, 1), Direction::of_degrees(x[0])).speed;
  });
  return entry;
}

}  // namespace

std::vector<Quantity> anisotropic_entries() {
  using fast::LineResponse;
  using fast::ShearResponse;
  const std::string general = " of a half-space of any anisotropy, C_kl in Voigt's order";
  return {
      anisotropic_line("anisotropic.compliance", "K" + general, member(&LineResponse::compliance),
                       &ref::LineResponse::compliance),
      anisotropic_line("anisotropic.coupling", "S" + general, member(&LineResponse::coupling),
                       &ref::LineResponse::coupling),
      anisotropic_line("anisotropic.coupling_across", "S' of shear across the line" + general,
                       member(&LineResponse::coupling_across), &ref::LineResponse::coupling_across),
      anisotropic_line("anisotropic.shear_compliance", "du3/dx over -H[tau], tau along the line" + general,
                       member(&LineResponse::shear_compliance), &ref::LineResponse::shear_compliance),
      anisotropic_line(
          "anisotropic.shear_compliance_across", "du3/dx over -H[tau'], tau' across the line" + general,
          member(&LineResponse::shear_compliance_across), &ref::LineResponse::shear_compliance_across),
      anisotropic_line("anisotropic.in_line", "du/dx over -H[tau], along the line" + general,
                       member(&ShearResponse::in_line), &ref::LineResponse::in_line),
      anisotropic_line("anisotropic.across", "du'/dx over -H[tau'], across the line" + general,
                       member(&ShearResponse::across), &ref::LineResponse::across),
      entry_anisotropic_critical()};
}

}  // namespace nipref::verify
