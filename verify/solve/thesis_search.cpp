#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

/// (2.13): each length is the last one times the cube root of the load over that found, which load_at(length) gives. The
/// steps end at a length for which it finds none.
std::vector<SearchStep> steps_of_search(double load, double first_length, double tolerance,
                                        const auto& load_at) {
  constexpr std::size_t most = 100;
  std::vector<SearchStep> steps;
  double length = first_length;
  try {
    while (steps.size() < most) {
      steps.push_back({length, load_at(length)});
      const double found = steps.back().load;
      if (!(found > 0) || std::fabs(found / load - 1) <= tolerance) break;
      length *= std::cbrt(load / found);
    }
  } catch (const data::BadInput&) {  // no creep meets the thesis's conditions there
  }
  return steps;
}

std::vector<SearchStep> steps_to(const data::ElasticNipProblem& problem, double load, double accuracy) {
  const auto& by = std::get<data::LineLoads>(problem.method);
  const fast::LineLoadMethod method(by.leading_elements, by.residue_terms, fast::Accuracy(accuracy));
  const data::Grip grip = grip_of(problem);
  const double first = problem.friction == data::Friction::none
                           ? problem.nip.sheet_thickness
                           : fast::line_loads_for_load(problem.nip, method, load).contact_length();
  return steps_of_search(load, first, 2e-3, [&](double length) {
    return fast::line_loads_for_length(problem.nip, method, length, grip).load();
  });
}

std::vector<SearchStep> steps_to(const data::ViscoelasticNipProblem& problem, double load,
                                 double /*accuracy*/) {
  auto method = std::get<data::ViscoelasticLineLoads>(problem.method);
  if (!method.trailing_elements)
    method.trailing_elements = fast::line_loads_for_load(problem.nip, method, load).trailing_elements();
  const double leading_part =
      static_cast<double>(method.leading_elements) / (method.leading_elements + *method.trailing_elements);
  return steps_of_search(load, problem.nip.sheet_thickness, 1e-2, [&](double length) {
    return fast::line_loads_for_length(problem.nip, method, length * leading_part).load();
  });
}

}  // namespace

std::vector<SearchStep> thesis_search(const data::Scene& scene) {
  return std::visit(
      [&](const auto& problem) -> std::vector<SearchStep> {
        if constexpr (requires { steps_to(problem, 0, 0); }) {
          const auto* const load = std::get_if<data::GivenLoad>(&problem.given);
          if (load != nullptr && is_by_line_loads(scene))
            return steps_to(problem, load->per_length, scene.accuracy);
        }
        return {};
      },
      scene.system);
}

}  // namespace nipref::verify
