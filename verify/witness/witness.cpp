#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/witness/internal/calculix.hpp>
#include <nipref/verify/witness/witness.hpp>

namespace nipref::verify {
namespace {

/// The program gets the shape of the contact's surface, and the surfaces are compared in the contact and in a part of the same
/// length beside it.
Witnessed witness_of(double thickness, data::Friction friction) {
  constexpr double load = 100, accuracy = 1e-9;
  const data::ElasticNipProblem problem{
      .nip = data::seed::nip(thickness), .given = data::GivenLoad{load}, .friction = friction};
  const SolvedInDouble contact = solve_nip(problem, accuracy);
  const auto value = [&](ResultId id) { return contact->number(id).value; };
  const bool is_gripped = friction == data::Friction::full;
  calculix::IndentedStrip strip{.young = problem.nip.material.young,
                                .poisson = problem.nip.material.poisson,
                                .half_thickness = problem.nip.half_thickness(),
                                .contact_end = value(ResultId::contact_length) / 2,
                                .indentation = value(ResultId::indentation),
                                .radius = problem.nip.roller_radius,
                                .creep = {}};
  if (is_gripped) strip.creep = value(ResultId::creep_ratio);
  const calculix::Response response = calculix::respond(strip);
  double normal = 0, tangential = 0, largest_tangential = 0;
  for (const auto& [y, there] : response.surface) {
    if (y >= 2 * strip.contact_end) break;
    const double u = contact->at(ResultId::normal_displacement, y).value,
                 v = contact->at(ResultId::tangential_displacement, y).value;
    normal = std::max(normal, std::fabs(there.normal - u));
    tangential = std::max(tangential, std::fabs(there.tangential - v));
    largest_tangential = std::max(largest_tangential, std::fabs(v));
  }
  return {thickness, is_gripped, std::fabs(2 * response.reaction / load - 1), normal / strip.indentation,
          tangential / largest_tangential};
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
