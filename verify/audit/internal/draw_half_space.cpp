#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {
namespace {

using data::ResultId;

/// Poisson's ratios for which Lame's first constant is a product without rounding, see variants_of.
constexpr std::array short_poissons{-0.5, 0.0, 0.25, 0.375, 0.4375};

void set_isotropic(Random& random, const std::string& table, DrawnScene& drawn) {
  const double poisson = random.chance(0.3)   ? short_poissons[random.index(short_poissons.size())]
                         : random.chance(0.5) ? random.uniform(-0.9, 0.4999)
                                              : 0.5 - random.log_uniform(1e-4, 0.3);
  drawn.set(table + ".shear", random.log_uniform(1e-2, 1e12));
  drawn.set(table + ".poisson", poisson);
  drawn.set(table + ".density", random.log_uniform(1e-2, 1e4));
}

void set_transversely_isotropic(Random& random, DrawnScene& drawn) {
  const double c11 = random.log_uniform(1e-2, 1e12), c33 = c11 * random.log_uniform(1e-2, 1e2);
  const double c66 = c11 * random.uniform(0.02, 0.95);
  drawn.set("half_space.axis", random.chance(0.5) ? "normal" : "in-plane");
  drawn.set("half_space.c11", c11);
  drawn.set("half_space.c33", c33);
  drawn.set("half_space.c66", c66);
  drawn.set("half_space.c44", std::sqrt(c11 * c33) * random.log_uniform(1e-2, 1));
  drawn.set("half_space.c13", std::sqrt((c11 - c66) * c33) * random.uniform(-0.9, 0.95));
  drawn.set("half_space.density", random.log_uniform(1e-2, 1e4));
}

/// A positive definite stiffness as a triangular matrix times its transpose, with moduli within about a decade.
void set_anisotropic(Random& random, DrawnScene& drawn) {
  const double unit = random.log_uniform(1e-2, 1e12);
  std::array<std::array<double, 6>, 6> factor{};
  for (std::size_t i = 0; i < 6; ++i) {
    const double size = random.log_uniform(1, 4);
    for (std::size_t k = 0; k <= i; ++k) factor[i][k] = i == k ? size : size * random.uniform(-0.5, 0.5);
  }
  std::vector<double> upper;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = i; k < 6; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j <= i; ++j) sum += factor[i][j] * factor[k][j];
      upper.push_back(unit * sum);
    }
  }
  drawn.set("half_space.stiffness", upper);
  drawn.set("half_space.density", random.log_uniform(1e-2, 1e4));
}

/// Draws the body, and returns its smallest radius.
double set_body(Random& random, Body body, DrawnScene& drawn) {
  const double radius = random.log_uniform(1e-3, 10);
  if (body == Body::die) {
    const double ratio = random.chance(0.2) ? 1 : random.log_uniform(1e-4, 1e4);
    drawn.set("die.radius_along", radius);
    drawn.set("die.radius_across", radius * ratio);
    return radius * std::min(1.0, ratio);
  }
  if (body == Body::rolling_sphere) {
    drawn.set("rolling_sphere.radius", radius);
    return radius;
  }
  drawn.set("sphere.radius", radius);
  set_isotropic(random, "sphere", drawn);
  if (random.chance(0.5)) drawn.set("sphere.patch", "moving");
  return radius;
}

/// The approximate stiffness of the half-space.
double stiffness(const DrawnScene& drawn) {
  const std::string model = drawn.text("half_space.model");
  if (model == "anisotropic") return drawn.numbers("half_space.stiffness").back();
  return drawn.number(model == "isotropic" ? "half_space.shear" : "half_space.c44");
}

/// A speed that is 0, any fraction of the critical speed, or close to it; 0 if there is no critical speed.
double draw_speed(Random& random, DrawnScene drawn) {
  const double part = random.chance(0.1)   ? 0
                      : random.chance(0.5) ? random.uniform()
                                           : 1 - random.log_uniform(1e-9, 0.5);
  drawn.set("title", "its critical speed");
  drawn.set_wanted({ResultId::critical_speed});
  try {
    return part * solve(drawn.scene())[ResultId::critical_speed].value;
  } catch (const data::BadInput&) {
    return 0;
  }
}

std::vector<ResultId> results_of(data::ContourRule rule, Body body) {
  std::vector<ResultId> wanted{ResultId::span_along,    ResultId::span_across,    ResultId::span_ratio,
                               ResultId::normal_force,  ResultId::friction_force, ResultId::peak_pressure,
                               ResultId::span,          ResultId::compliance,     ResultId::coupling,
                               ResultId::critical_speed};
  wanted.insert(wanted.end(), {ResultId::centre_along, ResultId::centre_across, ResultId::leading_end,
                               ResultId::trailing_end, ResultId::peak_on_line});
  if (body == Body::rolling_sphere)
    wanted.insert(wanted.end(), {ResultId::creep, ResultId::compressed_radius});
  if (rule == data::ContourRule::similar_contour) std::erase(wanted, ResultId::peak_pressure);
  if (rule == data::ContourRule::exact)
    wanted.insert(wanted.end(), {ResultId::axis_ratio, ResultId::orientation, ResultId::approach});
  return wanted;
}

/// Replaces the directions by places on a line, in the contact and outside it: half of the span along the motion is about
/// `half`.
void set_line(Random& random, data::ContourRule rule, double half, DrawnScene& drawn) {
  auto wanted = drawn.wanted();
  std::erase_if(wanted, [](ResultId id) { return data::scene_result(id).shape == data::Shape::profile; });
  wanted.insert(wanted.end(), {ResultId::pressure, ResultId::shear});
  if (rule == data::ContourRule::exact)
    wanted.insert(wanted.end(), {ResultId::normal_displacement, ResultId::tangential_displacement,
                                 ResultId::transverse_displacement});
  if (rule == data::ContourRule::exact && random.chance(0.5)) {
    std::erase(wanted, ResultId::pressure);
    std::erase(wanted, ResultId::shear);
    drawn.set("profile.depth", half * random.log_uniform(1e-9, 1e4));
  }
  drawn.set_wanted(wanted);
  drawn.set("profile.direction", random.uniform(-90, 90));
  drawn.set("profile.positions",
            std::vector{0.0, half * random.uniform(-1, 1), -half * random.log_uniform(1e-6, 1),
                        half * random.log_uniform(1, 10), -half * random.log_uniform(1, 1e3)});
}

}  // namespace

DrawnScene draw_on_half_space(Random& random, Body body, data::ContourRule rule) {
  DrawnScene drawn;
  const bool isotropic = body == Body::rolling_sphere || random.chance(0.5);
  // The critical speed of an anisotropic solid takes a quarter of a second.
  const bool anisotropic = !isotropic && random.chance(0.1);
  drawn.set("half_space.model", isotropic     ? "isotropic"
                                : anisotropic ? "anisotropic"
                                              : "transversely-isotropic");
  if (isotropic) {
    set_isotropic(random, "half_space", drawn);
  } else if (anisotropic) {
    set_anisotropic(random, drawn);
  } else {
    set_transversely_isotropic(random, drawn);
  }
  const double radius = set_body(random, body, drawn);
  drawn.set("method.kind", rule == data::ContourRule::exact             ? "exact"
                           : rule == data::ContourRule::similar_contour ? "similar-contour"
                                                                        : "stationary-force");
  drawn.set("wanted", results_of(rule, body));
  const double angle = random.uniform(-90, 90);
  drawn.set("profile.positions", std::vector<double>{0, 90, angle, -angle, random.uniform(-90, 90)});
  const bool span_given = random.chance(0.5);
  const double half = radius * (span_given ? random.log_uniform(1e-6, 1) / 2 : random.log_uniform(1e-6, 0.3));
  if (span_given) {
    drawn.set("contact.span_along", 2 * half);
  } else {
    drawn.set("load.normal_force", stiffness(drawn) * half * half * half / radius);
  }
  if (random.chance(0.3)) set_line(random, rule, half, drawn);
  const std::string motion = body == Body::rolling_sphere ? "rolling" : "sliding";
  drawn.set(motion + ".speed", 0.0);
  if (body != Body::rolling_sphere) {
    drawn.set("sliding.direction",
              random.chance(0.2) ? 90 * (static_cast<double>(random.index(3)) - 1) : random.uniform(-90, 90));
    if (rule != data::ContourRule::exact && random.chance(0.7))
      drawn.set("sliding.friction", random.uniform(0, 1));
  }
  drawn.set(motion + ".speed", draw_speed(random, drawn));
  return drawn;
}

}  // namespace nipref::verify
