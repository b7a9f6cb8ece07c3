#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/witness/internal/calculix.hpp>
#include <nipref/verify/witness/witness.hpp>

namespace nipref::verify {
namespace {

using data::ResultId;

constexpr double witnessed_load = 100;

data::Scene witnessed_scene(double thickness, data::Friction friction) {
  data::ElasticNipProblem problem{.nip = data::seed::nip(thickness),
                                  .given = data::GivenLoad{witnessed_load},
                                  .friction = friction,
                                  .creep_ratio = {},
                                  .method = data::ConvergedMethod{},
                                  .profile = {}};
  return {.title = "witnessed",
          .wanted = {ResultId::contact_length, ResultId::indentation, ResultId::creep_ratio,
                     ResultId::normal_displacement, ResultId::tangential_displacement},
          .accuracy = 1e-9,
          .system = problem,
          .origin = {}};
}

using WitnessedContact = SceneSolution<fast::Estimate>;

WitnessedContact witnessed_at(data::Scene scene, std::vector<double> positions) {
  std::get<data::ElasticNipProblem>(scene.system).profile = data::Positions{std::move(positions)};
  return solve(scene);
}

/// The shape of the contact's surface by the solver.
calculix::IndentedStrip witnessed_strip(data::Scene scene) {
  const data::ElasticNipProblem& problem = std::get<data::ElasticNipProblem>(scene.system);
  const WitnessedContact contact = witnessed_at(scene, {0});
  calculix::IndentedStrip strip{.young = problem.nip.material.young,
                                .poisson = problem.nip.material.poisson,
                                .half_thickness = problem.nip.half_thickness(),
                                .contact_end = contact[ResultId::contact_length].value / 2,
                                .indentation = contact[ResultId::indentation].value,
                                .radius = problem.nip.roller_radius,
                                .creep = {}};
  if (problem.friction == data::Friction::full) strip.creep = contact[ResultId::creep_ratio].value;
  return strip;
}

/// The largest difference of the surfaces in the contact and in a part of the same length beside it.
struct SurfaceDifference {
  double normal;      ///< of the indentation
  double tangential;  ///< of the largest tangential displacement
};

SurfaceDifference surface_difference(const calculix::Response& witness, const calculix::IndentedStrip& strip,
                                     const data::Scene& scene) {
  std::vector<double> positions;
  for (const auto& [y, displacement] : witness.surface) {
    if (y < 2 * strip.contact_end) positions.push_back(y);
  }
  const WitnessedContact contact = witnessed_at(scene, positions);
  double normal = 0;
  double tangential = 0;
  double largest_tangential = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const calculix::SurfaceDisplacement& there = witness.surface.at(positions[i]);
    const double u = contact.profile(ResultId::normal_displacement)[i].value;
    const double v = contact.profile(ResultId::tangential_displacement)[i].value;
    normal = std::max(normal, std::abs(there.normal - u));
    tangential = std::max(tangential, std::abs(there.tangential - v));
    largest_tangential = std::max(largest_tangential, std::abs(v));
  }
  return {normal / strip.indentation, tangential / largest_tangential};
}

Witnessed witness_of(double thickness, data::Friction friction) {
  const data::Scene scene = witnessed_scene(thickness, friction);
  const calculix::IndentedStrip strip = witnessed_strip(scene);
  const calculix::Response response = calculix::respond(strip);
  const auto [normal, tangential] = surface_difference(response, strip, scene);
  return {thickness, friction == data::Friction::full, std::fabs(2 * response.reaction / witnessed_load - 1),
          normal, tangential};
}

}  // namespace

bool Witnessed::agrees() const {
  return load <= load_limit && normal <= normal_limit && tangential <= tangential_limit;
}

bool Witness::agrees() const { return std::ranges::all_of(contacts, &Witnessed::agrees); }

Witness outside_witness() {
  if (!calculix::is_installed()) return {};
  return {true,
          {witness_of(1.0, data::Friction::none), witness_of(0.0625, data::Friction::none),
           witness_of(0.25, data::Friction::full), witness_of(0.0625, data::Friction::full)}};
}

Json witness_json(const Witness& witness) {
  if (!witness.installed) return {};
  return json_list(witness.contacts, [](const Witnessed& contact) {
    return Json{{"thickness", contact.thickness},
                {"friction", contact.gripped ? "full" : "none"},
                {"load", contact.load},
                {"normal_displacement", contact.normal},
                {"tangential_displacement", contact.tangential},
                {"agrees", contact.agrees()}};
  });
}

}  // namespace nipref::verify
