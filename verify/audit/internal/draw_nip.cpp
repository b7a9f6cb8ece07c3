#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>

namespace nipref::verify {
namespace {

using data::ResultId;

struct Size {
  double thickness, radius, length;
};

Size draw_size(Random& random, double longest = 1e3) {
  const double ratio = random.log_uniform(1e-4, longest);
  const double thickness = random.log_uniform(1e-3, 10);
  // The parabola alone enters the sheet by L^2/(8R); the roller is so large that the faces do not meet.
  const double least = std::max({1.0, 1.01 * ratio, ratio * ratio});
  return {thickness, thickness * random.log_uniform(least, std::max(1e4, 100 * least)), thickness * ratio};
}

double draw_poisson(Random& random) {
  return random.chance(0.5) ? random.uniform(-0.9, 0.4999) : 0.5 - random.log_uniform(1e-4, 0.3);
}

double draw_modulus(Random& random) { return random.log_uniform(1e-2, 1e7); }

/// Positions in the contact, at its ends, close to them and outside, on both sides.
std::vector<double> draw_positions(Random& random, double length) {
  const double half = length / 2;
  std::vector<double> positions{0, half * random.uniform(), half * (1 - random.log_uniform(1e-8, 0.1)),
                                half * (1 + random.log_uniform(1e-8, 0.1)),
                                half * random.log_uniform(1, 100)};
  const std::size_t inside = positions.size();
  for (std::size_t i = 1; i < inside; ++i) positions.push_back(-positions[i]);
  return positions;
}

/// Places of the field in the contact, next to its end and outside, at two depths of the same shares and on a face.
void set_field(DrawnScene& drawn, const std::vector<double>& positions, double length) {
  const double half = length / 2;
  drawn.set("field.positions", std::vector{positions[1], positions[2], positions[4]});
  drawn.set("field.depths", std::vector{positions[1] / half, positions[2] / half, -1.0});
}

/// The results of converged nips that need no friction, but for the moments, which the eccentricity has.
std::vector<ResultId> results_of_every_nip() {
  std::vector<ResultId> wanted;
  for (const data::SceneResult& result : data::scene_results()) {
    const bool is_moment = result.id == ResultId::leading_moment || result.id == ResultId::trailing_moment;
    const bool is_of_all = result.needs == data::Needs::nothing || result.needs == data::Needs::converged ||
                           result.needs == data::Needs::inside;
    if (result.is_of(data::SceneKind::nip) && is_of_all && !is_moment) wanted.push_back(result.id);
  }
  return wanted;
}

DrawnScene of_size(Random& random, const Size& size) {
  DrawnScene drawn;
  drawn.set("roller.radius", size.radius);
  drawn.set("sheet.thickness", size.thickness);
  drawn.set("contact.length", size.length);
  drawn.set("method.kind", "converged");
  const std::vector<double> positions = draw_positions(random, size.length);
  drawn.set("profile.positions", positions);
  set_field(drawn, positions, size.length);
  drawn.set_wanted(results_of_every_nip());
  return drawn;
}

/// The approximate load for a length: the sum of those on a half-space and on independent springs.
double about_load(const Size& size, double half_space_compliance, double spring_compliance) {
  const double half = size.length / 2;
  return std::numbers::pi / 2 * half * half / (size.radius * half_space_compliance) +
         8.0 / 3 * half * half * half / (size.radius * size.thickness * spring_compliance);
}

void give_load(DrawnScene& drawn, double load) {
  drawn.remove("contact.length");
  drawn.set("load.per_length", load);
}

double long_or_short(Random& random, const data::MaterialFunction& function) {
  return random.chance(0.5) ? function.instantaneous : function.long_time();
}

/// Relaxation time for a relaxation length of 1e-8 to 1e8 contact lengths.
double draw_time(Random& random, const Size& size, double speed) {
  return random.log_uniform(1e-8, 1e8) * size.length / speed;
}

double bulk_of(double shear, double poisson) { return shear * 2 * (1 + poisson) / (3 * (1 - 2 * poisson)); }

void draw_standard_linear(Random& random, const Size& size, DrawnScene& drawn) {
  const double speed = drawn.number("rolling.speed");
  const double shear = draw_modulus(random), bulk = bulk_of(shear, draw_poisson(random));
  if (random.chance(0.6)) {
    drawn.set("material.model", random.chance(0.8) ? "standard-linear-solid" : "thesis-misprint");
    drawn.set("material.shear", shear);
    drawn.set("material.bulk", bulk);
    drawn.set("material.relaxation_time", draw_time(random, size, speed));
    return;
  }
  drawn.set("material.model", "standard-linear-solid");
  drawn.set("material.shear_1", shear);
  drawn.set("material.bulk_1", bulk);
  for (const auto& [name, modulus] : {std::pair{"shear", shear}, std::pair{"bulk", bulk}}) {
    const double second = modulus * random.log_uniform(1e-2, 1e2);
    drawn.set(std::string("material.") + name + "_2", second);
    drawn.set(std::string("material.") + name + "_viscosity", second * draw_time(random, size, speed));
  }
}

/// theta2 is a constant fraction of theta1, so that Poisson's ratio is constant, or each of its terms is about that
/// fraction, which may not be a physical material.
void draw_prony(Random& random, const Size& size, DrawnScene& drawn) {
  const double speed = drawn.number("rolling.speed");
  const double compliance = 1 / draw_modulus(random), part = 1 - 2 * draw_poisson(random);
  const bool constant_ratio = random.chance(0.7);
  std::vector<double> rates(1 + random.index(3)), amplitudes, parts;
  for (double& rate : rates) {
    rate = 1 / draw_time(random, size, speed);
    amplitudes.push_back(compliance * random.log_uniform(1e-3, 1e2) * rate);
    parts.push_back(part * amplitudes.back() * (constant_ratio ? 1 : random.uniform(0.9, 1.1)));
  }
  drawn.set("material.model", "prony");
  drawn.set("material.theta1_instantaneous", compliance);
  drawn.set("material.theta1_amplitudes", amplitudes);
  drawn.set("material.theta1_rates", rates);
  drawn.set("material.theta2_instantaneous", part * compliance);
  drawn.set("material.theta2_amplitudes", parts);
  drawn.set("material.theta2_rates", rates);
}

/// One relaxation in shear alone, one in shear and in dilatation, or a complex pair of rates at a constant Poisson's
/// ratio, with weak or strong damping.
void draw_operators(Random& random, const Size& size, DrawnScene& drawn) {
  const double speed = drawn.number("rolling.speed");
  const double shear = draw_modulus(random), bulk = bulk_of(shear, draw_poisson(random));
  const auto set = [&](const char* name, const std::vector<double>& coefficients) {
    drawn.set(std::string("material.") + name, coefficients);
  };
  drawn.set("material.model", "operators");
  const double damping = 1 / draw_time(random, size, speed), softer = random.log_uniform(1e-2, 1e2);
  const std::size_t variant = random.index(3);
  if (variant < 2) {
    set("P", {(1 + softer) * damping, 1});
    set("Q", {shear * damping, shear});
    const double own = 1 / draw_time(random, size, speed);
    set("P_dilatation", variant == 0 ? std::vector<double>{1} : std::vector<double>{(1 + softer) * own, 1});
    set("Q_dilatation", variant == 0 ? std::vector<double>{bulk} : std::vector<double>{bulk * own, bulk});
    return;
  }
  const double frequency = damping * random.log_uniform(0.05, 30);
  const double square = damping * damping + frequency * frequency;
  // The numerator of the compliance: the material loses energy if at_rate * square <= 2 damping * at_rest, and the
  // compliance is positive at every frequency unless at_rest is many times damping * sqrt(square).
  const bool swings = frequency > damping;
  const double at_rest = damping * (swings ? std::min(softer, 3.0) * std::sqrt(square) : softer * damping);
  const double at_rate = swings ? 1.8 * random.uniform() * damping * at_rest / square : softer * damping;
  const std::vector<double> q{square, 2 * damping, 1};
  const auto times = [&](double factor) {
    std::vector<double> product = q;
    for (double& coefficient : product) coefficient *= factor;
    return product;
  };
  const std::vector<double> p{square + at_rest, 2 * damping + at_rate, 1};
  set("P", p);
  set("Q", times(shear));
  set("P_dilatation", p);
  set("Q_dilatation", times(bulk));
}

void draw_material(Random& random, RollingMaterial material, const Size& size, DrawnScene& drawn) {
  if (material == RollingMaterial::standard_linear) return draw_standard_linear(random, size, drawn);
  if (material == RollingMaterial::prony) return draw_prony(random, size, drawn);
  if (material == RollingMaterial::operators) return draw_operators(random, size, drawn);
  drawn.set("material.model", "elastic");
  drawn.set("material.young", draw_modulus(random));
  drawn.set("material.poisson", draw_poisson(random));
}

data::ElasticMaterial draw_elastic_material(DrawnScene& drawn, Random& random) {
  const data::ElasticMaterial material{draw_modulus(random), draw_poisson(random)};
  drawn.set("material.model", "elastic");
  drawn.set("material.young", material.young);
  drawn.set("material.poisson", material.poisson);
  return material;
}

}  // namespace

DrawnScene draw_elastic_nip(Random& random, data::Friction friction) {
  const Size size = draw_size(random);
  DrawnScene drawn = of_size(random, size);
  const data::ElasticMaterial material = draw_elastic_material(drawn, random);
  const bool grips = friction == data::Friction::full;
  drawn.set("friction.model", grips ? "full" : "none");
  auto wanted = drawn.wanted();
  wanted.insert(wanted.end(), {ResultId::displacement_across, ResultId::displacement_along});
  if (grips) wanted.insert(wanted.end(), {ResultId::peak_shear_position, ResultId::shear_zeros});
  drawn.set_wanted(std::move(wanted));
  if (random.chance(0.5)) {
    // With full friction the sheet cannot widen.
    const double confined =
        2 * (1 + material.poisson) * (1 - 2 * material.poisson) / ((1 - material.poisson) * material.young);
    give_load(drawn, about_load(size, material.normal_compliance(),
                                grips ? confined : material.normal_compliance()));
  }
  return drawn;
}

DrawnScene draw_partial_slip(Random& random) {
  const Size size = draw_size(random, 5);
  DrawnScene drawn = of_size(random, size);
  const data::ElasticMaterial material = draw_elastic_material(drawn, random);
  const double friction = random.log_uniform(1e-2, 2);
  drawn.set("friction.model", "coulomb");
  drawn.set("friction.coefficient", friction);
  const double compliance = material.normal_compliance(), load = about_load(size, compliance, compliance);
  drawn.set("traction.force_per_length",
            random.chance(0.3) ? 0.0 : friction * load * random.uniform(-0.7, 0.7));
  std::vector<ResultId> wanted = drawn.wanted();
  std::erase_if(wanted, [](ResultId id) {
    return data::scene_result(id).needs == data::Needs::inside || id == ResultId::power_loss;
  });
  wanted.insert(wanted.end(), {ResultId::traction, ResultId::dissipation, ResultId::peak_shear_position,
                               ResultId::zone_boundaries, ResultId::heat});
  drawn.set_wanted(std::move(wanted));
  drawn.remove("field.positions");
  drawn.remove("field.depths");
  if (random.chance(0.5)) give_load(drawn, load);
  return drawn;
}

DrawnScene draw_rolling_nip(Random& random, RollingMaterial material) {
  const Size size = draw_size(random);
  DrawnScene drawn = of_size(random, size);
  drawn.set("friction.model", "none");
  drawn.set("rolling.speed", random.log_uniform(1e-2, 1e2));
  draw_material(random, material, size, drawn);
  if (!random.chance(0.5)) return drawn;
  try {
    drawn.set("title", "its material");
    const auto problem = std::get<data::ViscoelasticNipProblem>(drawn.scene().system);
    const double compliance =
        long_or_short(random, fast::material_functions(problem.nip.material).normal_compliance());
    give_load(drawn, about_load(size, compliance, compliance));
  } catch (const data::BadInput&) {
    // Reading the scene again reports the refusal.
  }
  return drawn;
}

}  // namespace nipref::verify
