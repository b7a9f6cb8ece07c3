// Responses of half-spaces of any anisotropy along lines, and their critical speed. (brock2013 A.1-A.5)

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;

data::Stiffness stiffness_of(const NamedPoint& x) {
  data::Stiffness solid{{}, x["density"]};
  data::set_symmetric(solid.voigt, x.from("c11").begin());
  return solid;
}

ref::ExactStiffness exact_stiffness_of(const NamedExact& x) {
  const auto given = x.from("c11");
  data::Stiffness nearest{{}, x["density"].approximate()};
  data::set_symmetric(nearest.voigt, mapped(given, &ref::Exact::approximate).begin());
  nearest.check();
  ref::ExactStiffness solid;
  solid.density = x["density"].value();
  data::set_symmetric(solid.voigt, mapped(given, &ref::Exact::value).begin());
  return solid;
}

ExactLine subcritical_anisotropic(const NamedExact& x) {
  const ExactLine line{exact_stiffness_of(x), x["speed"], direction_of(x, "theta_deg"),
                       direction_of(x, "psi_deg")};
  return line.checked();
}

/// The seed's graphite epoxy with its axis along x2. The density is in g/cm^3, so that speeds are in km/s.
data::Stiffness epoxy() {
  data::Stiffness solid = data::Stiffness::of(data::seed::graphite_epoxy, data::SymmetryAxis::in_plane);
  solid.density = 1.688;
  return solid;
}

void put_stiffness(const NamedNumbers& x, const data::Stiffness& solid) {
  std::ranges::transform(data::upper_triangle, x.from("c11").begin(),
                         [&](const auto& at) { return solid.voigt[at.first][at.second]; });
  x["density"] = solid.density;
}

/// Draws a triclinic solid, a monoclinic one about x3 or an orthotropic one, whose moduli spread over one decade or
/// three. Sometimes it is the solid of the seed.
data::Stiffness draw_stiffness(Random& random) {
  if (random.chance(0.1)) return epoxy();
  const double spread = random.chance(0.3) ? 30 : 4;
  const std::size_t symmetry = random.index(3);
  const auto is_coupled = [&](std::size_t i, std::size_t k) {
    if (symmetry == 0 || i == k) return true;
    const bool in_plane[] = {true, true, true, false, false, true};  // parity in x3
    return symmetry == 1 ? in_plane[i] == in_plane[k] : i < 3 && k < 3;
  };
  data::Stiffness::Voigt factor{};
  for (std::size_t i = 0; i < 6; ++i) {
    const double size = random.log_uniform(1, spread);
    for (std::size_t k = 0; k <= i; ++k)
      factor[i][k] = !is_coupled(i, k) ? 0 : i == k ? size : size * random.uniform(-0.6, 0.6);
  }
  return {data::Stiffness::squared(factor), random.log_uniform(0.5, 20)};
}

/// Replaces a solid that is not physical, to which a step of the search of an audit may lead.
void keep_physical_stiffness(const NamedNumbers& x) {
  if (is_refused([&] { stiffness_of(x).check(); })) put_stiffness(x, epoxy());
}

/// The critical speed of the line, but at most 1e12: across the motion it is infinite.
double largest_speed(const NamedPoint& x) {
  return std::min(
      1e12, fast::rayleigh_speed(stiffness_of(x), direction_of(x, "theta_deg"), direction_of(x, "psi_deg")));
}

fast::AnisotropicHalfSpace anisotropic_surface(const NamedPoint& x) {
  return {stiffness_of(x), direction_of(x, "theta_deg"), x["speed"]};
}

double largest_answer(const NamedPoint& x) {
  const auto surface = anisotropic_surface(x);
  const Direction psi = direction_of(x, "psi_deg");
  const auto [in_line, across] = surface.shear_along(psi);
  return std::max({surface.along(psi).compliance, in_line, across});
}

double answer(const fast::AnisotropicHalfSpace& surface, Direction psi, double fast::LineResponse::*member) {
  return surface.along(psi).*member;
}
double answer(const fast::AnisotropicHalfSpace& surface, Direction psi, double fast::ShearResponse::*member) {
  return surface.shear_along(psi).*member;
}

template <class FastMember>
Quantity anisotropic_line(const char* name, FastMember of_fast, ref::Enclosure ref::LineResponse::*of_ref) {
  const Quantity entry = entry_of(
      name, component_of(subcritical_anisotropic, of_ref),
      [of_fast](NamedPoint x) { return answer(anisotropic_surface(x), direction_of(x, "psi_deg"), of_fast); },
      largest_answer);
  const auto draw = [](Random& random, NamedNumbers x) {
    x["theta_deg"] = drawn("degrees()", random);
    x["psi_deg"] = drawn("degrees()", random);
    put_stiffness(x, draw_stiffness(random));
    x["speed"] = drawn("share()", random) * largest_speed(x);
  };
  return sampled(entry, draw, [](NamedNumbers x) {
    keep_physical_stiffness(x);
    x["speed"] = std::min(x["speed"], (1 - 1e-9) * largest_speed(x));
  });
}

/// Draws a nearly isotropic solid. In other solids a bulk wave may (nearly) determine the smallest critical speed, but
/// the reference proves the speed of surface waves only.
data::Stiffness draw_mild_stiffness(Random& random) {
  const data::Stiffness isotropic =
      data::Stiffness::of(data::IsotropicSolid{random.log_uniform(1, 100), random.uniform(0, 0.4), 1});
  const double size = 0.15 * std::sqrt(isotropic.voigt[5][5]);
  data::Stiffness::Voigt factor{};
  for (auto& row : factor)
    for (double& entry : row) entry = random.uniform(-size, size);
  data::Stiffness solid{data::Stiffness::squared(factor), random.log_uniform(0.5, 20)};
  for (const auto& [i, k] : data::upper_triangle)
    solid.voigt[k][i] = solid.voigt[i][k] = solid.voigt[i][k] + isotropic.voigt[i][k];
  return solid;
}

Quantity entry_anisotropic_critical() {
  const Quantity entry = entry_of(
      "anisotropic.critical",
      [](NamedExact x, int digits) {
        return ref::critical_speed(exact_stiffness_of(x), direction_of(x, "theta_deg"), digits).speed;
      },
      [](NamedPoint x) { return fast::critical_speed(stiffness_of(x), direction_of(x, "theta_deg")).speed; });
  const auto draw = [](Random& random, NamedNumbers x) {
    x["theta_deg"] = drawn("angle()", random);
    put_stiffness(x, random.chance(0.2) ? epoxy() : draw_mild_stiffness(random));
  };
  return sampled(entry, draw, keep_physical_stiffness);
}

}  // namespace

std::vector<Quantity> anisotropic_entries() {
  using fast::LineResponse;
  using fast::ShearResponse;
  using Ref = ref::LineResponse;
  return {
      anisotropic_line("anisotropic.compliance", &LineResponse::compliance, &Ref::compliance),
      anisotropic_line("anisotropic.coupling", &LineResponse::coupling, &Ref::coupling),
      anisotropic_line("anisotropic.coupling_across", &LineResponse::coupling_across, &Ref::coupling_across),
      anisotropic_line("anisotropic.shear_compliance", &LineResponse::shear_compliance,
                       &Ref::shear_compliance),
      anisotropic_line("anisotropic.shear_compliance_across", &LineResponse::shear_compliance_across,
                       &Ref::shear_compliance_across),
      anisotropic_line("anisotropic.in_line", &ShearResponse::in_line, &Ref::in_line),
      anisotropic_line("anisotropic.across", &ShearResponse::across, &Ref::across),
      entry_anisotropic_critical()};
}

}  // namespace nipref::verify
