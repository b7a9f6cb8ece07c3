#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/calculix.hpp"
#include "support/solved_scene.hpp"

// An outside program is given the shape under the contact that the solver found, and finds the load, the free
// surface beside the contact and, without friction, the slip under it. An indentation off by 1e-5, and a
// length or creep off by 1e-3, which the load hardly feels, each exceed at least one of the limits.

using namespace nipref;
namespace calculix = nipref::test::calculix;

namespace {

// The mesh's own errors: elements that grow by 1.3 instead of 1.15 make them up to eight times larger, half
// the largest element up to four times smaller.
constexpr double load_error = 3e-6;
constexpr double normal_error = 1e-5;
constexpr double tangential_error = 1e-4;

constexpr double given_load = 100;

data::Scene scene_of_sheet(double thickness, data::Friction friction) {
  data::ElasticNipProblem problem{.nip = data::seed::nip(thickness),
                                  .given = data::GivenLoad{given_load},
                                  .friction = friction,
                                  .creep_ratio = {},
                                  .method = data::ConvergedMethod{},
                                  .profile = {}};
  return {.title = "test",
          .wanted = {"contact_length", "indentation", "creep_ratio", "normal_displacement",
                     "tangential_displacement"},
          .accuracy = 1e-9,
          .system = problem,
          .origin = {}};
}

using Contact = verify::SceneSolution<fast::Estimate>;

Contact solved_at(data::Scene scene, std::vector<double> positions) {
  problem_of(scene).profile = data::Positions{std::move(positions)};
  return verify::solve(scene);
}

/// The shape of the contact's surface, as the solver has it.
calculix::IndentedStrip strip_of(data::Scene scene) {
  const data::ElasticNipProblem& problem = problem_of(scene);
  const Contact contact = solved_at(scene, {0});
  calculix::IndentedStrip strip{.young = problem.nip.material.young,
                                .poisson = problem.nip.material.poisson,
                                .half_thickness = problem.nip.half_thickness(),
                                .contact_end = contact["contact_length"].value / 2,
                                .indentation = contact["indentation"].value,
                                .radius = problem.nip.roller_radius,
                                .creep = {}};
  if (problem.friction == data::Friction::full) strip.creep = contact["creep_ratio"].value;
  return strip;
}

/// Largest difference of the surfaces under the contact and as far again beside it.
struct Deviation {
  double normal;      ///< of the indentation
  double tangential;  ///< of the largest tangential displacement
};

Deviation deviation(const calculix::Response& witness, const calculix::IndentedStrip& strip,
                    const data::Scene& scene) {
  std::vector<double> positions;
  for (const auto& [y, displacement] : witness.surface) {
    if (y < 2 * strip.contact_end) positions.push_back(y);
  }
  const Contact contact = solved_at(scene, positions);
  double normal = 0;
  double tangential = 0;
  double largest_tangential = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const calculix::SurfaceDisplacement& there = witness.surface.at(positions[i]);
    const double u = contact.profile("normal_displacement")[i].value;
    const double v = contact.profile("tangential_displacement")[i].value;
    normal = std::max(normal, std::abs(there.normal - u));
    tangential = std::max(tangential, std::abs(there.tangential - v));
    largest_tangential = std::max(largest_tangential, std::abs(v));
  }
  return {normal / strip.indentation, tangential / largest_tangential};
}

void check_witnessed(double thickness, data::Friction friction) {
  const data::Scene scene = scene_of_sheet(thickness, friction);
  const calculix::IndentedStrip strip = strip_of(scene);
  const calculix::Response witness = calculix::respond(strip);
  const double load = 2 * witness.reaction / given_load - 1;
  const auto [normal, tangential] = deviation(witness, strip, scene);
  MESSAGE("thickness ", thickness,
          std::string(friction == data::Friction::full ? ", full friction" : ", no friction"), ": load ",
          load, ", normal displacements ", normal, ", tangential ", tangential);
  CHECK(std::abs(load) <= load_error);
  CHECK(normal <= normal_error);
  CHECK(tangential <= tangential_error);
}

}  // namespace

TEST_CASE("an outside finite-element program confirms converged contacts") {
  if (!calculix::is_installed()) {
    MESSAGE("skipped: CalculiX (ccx) is not installed");
    return;
  }
  check_witnessed(1.0, data::Friction::none);
  check_witnessed(0.0625, data::Friction::none);
  check_witnessed(0.25, data::Friction::full);
  check_witnessed(0.0625, data::Friction::full);
}
