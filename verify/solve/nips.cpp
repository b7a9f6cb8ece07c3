#include <cstdint>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/partial_slip/line_loads.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/partial_slip/partial_slip.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

using data::ConvergedMethod;
using data::ElasticNipProblem;
using data::PartialSlipProblem;
using data::ViscoelasticNipProblem;
using fast::Estimate;

/// Calls for_load or for_length with the number that the scene gives.
auto for_given(const data::Given& given, const auto& for_load, const auto& for_length) {
  const auto* const load = std::get_if<data::GivenLoad>(&given);
  return load != nullptr ? for_load(load->per_length)
                         : for_length(std::get<data::GivenLength>(given).contact_length);
}

// fast takes an accuracy, a double, where the reference takes digits, an int.
using fast::converged_for_length, ref::converged_for_length, fast::converged_for_load,
    ref::converged_for_load;
using fast::partial_slip_for_length, ref::partial_slip_for_length, fast::partial_slip_for_load,
    ref::partial_slip_for_load;

auto solution(auto /*path*/, const auto& problem, const ConvergedMethod&, auto accuracy) {
  return with_nip(problem, [&](const auto&... nip) {
    return for_given(
        problem.given, [&](double load) { return converged_for_load(nip..., load, accuracy); },
        [&](double length) { return converged_for_length(nip..., length, accuracy); });
  });
}
auto solution(auto /*path*/, const PartialSlipProblem& problem, const ConvergedMethod&, auto accuracy) {
  return for_given(
      problem.given, [&](double load) { return partial_slip_for_load(problem.nip, load, accuracy); },
      [&](double length) { return partial_slip_for_length(problem.nip, length, accuracy); });
}

auto solution(FastPath, const ElasticNipProblem& problem, const data::LineLoads& by, double accuracy) {
  const fast::LineLoadMethod method(by.leading_elements, by.residue_terms, fast::Accuracy(accuracy));
  const data::Grip grip = grip_of(problem);
  return for_given(
      problem.given, [&](double load) { return fast::line_loads_for_load(problem.nip, method, load, grip); },
      [&](double length) { return fast::line_loads_for_length(problem.nip, method, length, grip); });
}
auto solution(FastPath, const PartialSlipProblem& problem, const data::LineLoads& by, double /*accuracy*/) {
  return fast::line_loads_for_load(problem.nip, by.leading_elements,
                                   std::get<data::GivenLoad>(problem.given).per_length);
}
[[noreturn]] ref::LineLoadNip solution(RefPath, const PartialSlipProblem&, const data::LineLoads&, int) {
  throw data::BadInput("method.kind", "line-loads",
                       "must be converged for the reference with Coulomb's friction");
}
auto solution(FastPath, const ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& method,
              double /*accuracy*/) {
  const double leading = method.leading_elements;
  const double leading_part = leading / (leading + method.trailing_elements.value_or(leading));
  return for_given(
      problem.given, [&](double load) { return fast::line_loads_for_load(problem.nip, method, load); },
      [&](double length) { return fast::line_loads_for_length(problem.nip, method, length * leading_part); });
}
auto solution(RefPath, const ElasticNipProblem& problem, const data::LineLoads& by, int digits) {
  const ref::LineLoadMethod method(by.leading_elements, by.residue_terms);
  const data::Grip grip = grip_of(problem);
  return for_given(
      problem.given,
      [&](double load) { return ref::line_loads_for_load(problem.nip, method, load, digits, grip); },
      [&](double length) { return ref::line_loads_for_length(problem.nip, method, length, digits, grip); });
}
auto solution(RefPath, const ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& method,
              int digits) {
  return for_given(
      problem.given, [&](double load) { return ref::line_loads_for_load(problem.nip, method, load, digits); },
      [&](double length) { return ref::line_loads_for_length(problem.nip, method, length, digits); });
}

fast::Work work_of(const auto& by_fast) { return by_fast.work(); }
/// Numbers of values of I1, of I3, and of the part of I6 that is not in I1.
fast::Work work_of(const ref::ConvergedNip& contact) {
  fast::Work work;
  const auto [normal, coupling, stretch] = contact.kernel_values();
  work.kernel_evaluations[0] = static_cast<std::uint64_t>(normal);
  work.kernel_evaluations[2] = static_cast<std::uint64_t>(coupling);
  work.kernel_evaluations[5] = static_cast<std::uint64_t>(stretch);
  work.unknowns = contact.unknowns();
  return work;
}
fast::Work work_of(const ref::PartialSlipNip& contact) { return {.unknowns = contact.unknowns()}; }
fast::Work work_of(const ref::LineLoadNip& loads) {
  return {.systems = static_cast<std::uint64_t>(loads.systems()), .unknowns = loads.unknowns()};
}

/// The creep ratio that the thesis chooses is the last one.
std::vector<Estimate> creep_range_of(const fast::LineLoadNip& loads) {
  const auto creep = fast::thesis_creep(loads.creep_ranges);
  if (!creep)
    throw data::BadInput("contact_length", loads.contact_length(),
                         "no creep meets the thesis's conditions here: other elements may have one");
  return {{creep->range.lower, 0}, {creep->range.upper, 0}, {creep->chosen, 0}};
}
std::vector<ref::Estimate> creep_range_of(const ref::LineLoadNip& loads) {
  const auto [lower, upper, chosen] = loads.creep_range();
  return {lower, upper, chosen};
}

/// A solution's members, functions or numbers, have the names of the results.
template <class Number, class Solution>
void set_results(SolvedContact<Number>& solved, const std::shared_ptr<Solution>& solution) {
  const auto set = [&](ResultId id, auto member) { solved.set(id, solution, member); };
  set(ResultId::contact_length, &Solution::contact_length);
  set(ResultId::leading_length, &Solution::leading_length);
  set(ResultId::trailing_length, &Solution::trailing_length);
  set(ResultId::load, &Solution::load);
  set(ResultId::indentation, &Solution::indentation);
  set(ResultId::edge_displacement, &Solution::leading_displacement);
  set(ResultId::trailing_displacement, &Solution::trailing_displacement);
  set(ResultId::rolling_resistance, &Solution::rolling_resistance);
  set(ResultId::creep_ratio, &Solution::creep_ratio);
  set(ResultId::pressure, &Solution::pressure);
  set(ResultId::peak_pressure, &Solution::peak_pressure);
  set(ResultId::peak_pressure_position, &Solution::peak_pressure_position);
  set(ResultId::shear, &Solution::shear);
  set(ResultId::peak_shear, &Solution::peak_shear);
  set(ResultId::peak_shear_position, &Solution::peak_shear_position);
  set(ResultId::normal_displacement, &Solution::normal_displacement);
  set(ResultId::tangential_displacement, &Solution::tangential_displacement);
  // Results that only some methods have.
  if constexpr (requires { &Solution::leading_moment; }) {
    set(ResultId::leading_moment, &Solution::leading_moment);
    set(ResultId::trailing_moment, &Solution::trailing_moment);
  }
  if constexpr (requires { &Solution::surface_strain; })
    set(ResultId::surface_strain, &Solution::surface_strain);
  if constexpr (requires { &Solution::shear_zeros; }) set(ResultId::shear_zeros, &Solution::shear_zeros);
  if constexpr (requires { &Solution::zone_boundaries; }) {
    set(ResultId::traction, &Solution::traction);
    set(ResultId::dissipation, &Solution::dissipation);
    set(ResultId::zone_boundaries, &Solution::zone_boundaries);
    solved.set(ResultId::heat, [&solved](double y) {
      const auto size = [&](ResultId id) {
        const Number& number = solved.at(id, y);
        return number * exactly(std::signbit(value_of(number)) ? -1 : 1, number);
      };
      return size(ResultId::shear) * size(ResultId::slip);
    });
    solved.set(ResultId::zone_signs, [=, &solved](const Places&) {
      return mapped<Number>(std::invoke(&Solution::zone_signs, *solution), [&](int sign) {
        Number number = exactly(sign, solved.number(ResultId::load));
        if constexpr (requires { number.proven; }) number.proven = false;
        return number;
      });
    });
  }
  if constexpr (requires { &Solution::slip; }) set(ResultId::slip, &Solution::slip);
  if constexpr (requires(const Solution& one) { creep_range_of(one); })
    solved.set(ResultId::creep_range, [=](const Places&) { return creep_range_of(*solution); });
}

/// The functions of line loads take the digits last, those of the reference.
auto with_digits(double /*accuracy*/, const auto& function) { return function(); }
auto with_digits(int digits, const auto& function) { return function(digits); }

/// Stresses inside, and displacements of an elastic sheet's alone.
template <class Path, class Problem, class Solution>
void set_inside(SolvedContact<typename Path::Number>& solved, const Problem& problem,
                typename Path::Accuracy accuracy, const std::shared_ptr<Solution>& solution) {
  using Stresses = typename Path::Stresses;
  using Displacements = typename Path::Displacements;
  using Greatest = typename Path::Greatest;
  const auto points_at = [](const Places& places) {
    return mapped(places, [](const Place& one) { return typename Path::Point{one.y, one.depth}; });
  };
  solved.template set_parts<Stresses>(
      [=](const Places& places) {
        const auto points = points_at(places);
        if constexpr (requires { solution->inner_stresses(points); }) {
          return solution->inner_stresses(points);
        } else {
          return with_digits(accuracy, [&](auto... digits) {
            return line_load_stresses(solution->face_loads(), problem.nip.half_thickness(), points,
                                      digits...);
          });
        }
      },
      {{ResultId::stress_across, &Stresses::across},
       {ResultId::stress_along, &Stresses::along},
       {ResultId::stress_shear, &Stresses::shear},
       {ResultId::highest_stress, &Stresses::highest},
       {ResultId::lowest_stress, &Stresses::lowest},
       {ResultId::maximum_shear, &Stresses::maximum_shear}});
  if constexpr (std::is_same_v<Problem, ElasticNipProblem>) {
    solved.template set_parts<Displacements>(
        [=](const Places& places) {
          const auto points = points_at(places);
          if constexpr (requires { solution->inner_displacements(points); }) {
            return solution->inner_displacements(points);
          } else {
            return with_digits(accuracy, [&](auto... digits) {
              return line_load_displacements(solution->face_loads(), problem.nip.half_thickness(),
                                             problem.nip.material, points, digits...);
            });
          }
        },
        {{ResultId::displacement_across, &Displacements::across},
         {ResultId::displacement_along, &Displacements::along}});
  }
  if constexpr (requires { solution->greatest_shear(); }) {
    solved.template set_parts<Greatest>(
        [=](const Places&) { return std::vector{solution->greatest_shear()}; },
        {{ResultId::greatest_shear, &Greatest::value},
         {ResultId::greatest_shear_position, &Greatest::y},
         {ResultId::greatest_shear_depth, &Greatest::depth}});
  }
}

double speed_of(const auto&) { return 1; }
double speed_of(const ViscoelasticNipProblem& problem) { return problem.nip.speed; }

/// Completes a contact that has the results of a solution: with their products, its ends and what is given.
template <class Number, class Problem>
void complete(SolvedContact<Number>& contact, const Problem& problem) {
  contact.is_symmetric = std::is_same_v<Problem, ElasticNipProblem>;
  contact.roller_radius = problem.nip.roller_radius;
  contact.speed = speed_of(problem);
  contact.ends = [&contact] {
    return ContactEnds{-value_of(contact.number(ResultId::trailing_length)),
                       value_of(contact.number(ResultId::leading_length))};
  };
  set_products(contact);
}

/// The contact by either path and any method, of which line loads in double have no errors yet.
template <class Path, class Problem, class Method>
Solved<Path> solved(const Problem& problem, const Method& method, typename Path::Accuracy accuracy) {
  constexpr bool converges = std::is_same_v<Method, ConvergedMethod>;
  auto contact = std::make_unique<SolvedContact<typename Path::Number>>();
  const auto found = std::make_shared<decltype(solution(Path(), problem, method, accuracy))>(
      solution(Path(), problem, method, accuracy));
  set_results(*contact, found);
  if constexpr (!std::is_same_v<Problem, PartialSlipProblem>)
    set_inside<Path>(*contact, problem, accuracy, found);
  complete(*contact, problem);
  contact->work = [found] { return work_of(*found); };
  if constexpr (Path::is_fast && converges) {
    set_moments(*contact);
    if constexpr (requires { found->refine(); }) contact->solve_again = [found] { return found->refine(); };
  } else if constexpr (converges && !std::is_same_v<Problem, PartialSlipProblem>) {
    set_slip(*contact, has_full_friction(problem));
  }
  if (!Path::is_fast && (!converges || contact->is_symmetric)) contact->measure = Measure::itself;
  return contact;
}

/// The accuracy of the continuous contact to which line loads are compared; their distance to it is at least about
/// 1e-3.
constexpr double truth_accuracy = 1e-5;

/// The error of each number of line loads is its distance to the truth, of a list to the nearest of the truth's numbers,
/// whose own error is added.
std::vector<Estimate> compared(std::vector<Estimate> numbers, const std::vector<Estimate>& truths,
                               bool is_list) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    auto& [value, error] = numbers[i];
    const auto distance = [value = value](const Estimate& truth) { return std::fabs(value - truth.value); };
    const Estimate& truth = is_list ? *std::ranges::min_element(truths, {}, distance) : truths[i];
    error = distance(truth) + truth.error;
  }
  return numbers;
}

/// Each length is the last one times the cube root of the load over that found. The steps end at a length for which no load
/// is found.
template <class Problem, class Method>
std::vector<SearchStep> steps_to(Problem problem, Method method, double load, double accuracy) {
  constexpr std::size_t most = 100;
  const auto loads_of = [&](const Problem& one) { return solution(FastPath(), one, method, accuracy); };
  double length = problem.nip.sheet_thickness, tolerance = 1e-2;
  if constexpr (std::is_same_v<Problem, ElasticNipProblem>) {
    tolerance = 2e-3;
    Problem slipping = problem;
    slipping.friction = data::Friction::none;
    if (has_full_friction(problem)) length = loads_of(slipping).contact_length();
  } else if (!method.trailing_elements) {
    method.trailing_elements = loads_of(problem).trailing_elements();
  }
  std::vector<SearchStep> steps;
  try {
    while (steps.size() < most) {
      problem.given = data::GivenLength{length};
      steps.push_back({length, loads_of(problem).load()});
      const double found = steps.back().load;
      if (!(found > 0) || std::fabs(found / load - 1) <= tolerance) break;
      length *= std::cbrt(load / found);
    }
  } catch (const data::BadInput&) {  // no creep meets the thesis's conditions there
  }
  return steps;
}

SolvedInDouble compared_with_truth(const auto& problem, const auto& line_loads, double accuracy) {
  const std::shared_ptr<const SolvedContact<Estimate>> truth =
      solved<FastPath>(problem, ConvergedMethod(), truth_accuracy);
  const std::shared_ptr<const SolvedContact<Estimate>> loads =
      solved<FastPath>(problem, line_loads, accuracy);
  auto contact = std::make_unique<SolvedContact<Estimate>>();
  for (const data::SceneResult& result : data::scene_results()) {
    if (!loads->has(result.id)) continue;
    contact->set(result.id, [=, id = result.id, shape = result.shape](const Places& places) {
      // The continuous contact has one creep ratio, to which all three are compared.
      const auto& truths =
          id == ResultId::creep_range ? truth->get(ResultId::creep_ratio) : truth->get(id, places);
      return compared(loads->get(id, places), truths, shape == data::Shape::list);
    });
  }
  complete(*contact, problem);
  contact->measure = Measure::truth;
  contact->work = [loads] { return loads->work(); };
  contact->error_work = [truth] { return truth->work(); };
  return contact;
}

}  // namespace

template <class Path, class Problem>
Solved<Path> solve_nip(const Problem& problem, typename Path::Accuracy accuracy) {
  const auto solve_by = [&](const auto& method) {
    if constexpr (Path::is_fast && requires { method.leading_elements; }) {
      return compared_with_truth(problem, method, accuracy);
    } else {
      return solved<Path>(problem, method, accuracy);
    }
  };
  return std::visit(solve_by, problem.method);
}

std::vector<SearchStep> thesis_search(const data::Scene& scene) {
  return std::visit(
      [&](const auto& problem) -> std::vector<SearchStep> {
        using Problem = std::remove_cvref_t<decltype(problem)>;
        if constexpr (requires { problem.method; } && !std::is_same_v<Problem, PartialSlipProblem>) {
          const auto* const load = std::get_if<data::GivenLoad>(&problem.given);
          const auto search = [&](const auto& method) -> std::vector<SearchStep> {
            if constexpr (requires { method.leading_elements; })
              if (load != nullptr) return steps_to(problem, method, load->per_length, scene.accuracy);
            return {};
          };
          return std::visit(search, problem.method);
        }
        return {};
      },
      scene.system);
}

template SolvedInDouble solve_nip<FastPath>(const ElasticNipProblem&, double);
template SolvedInDouble solve_nip<FastPath>(const ViscoelasticNipProblem&, double);
template SolvedInDouble solve_nip<FastPath>(const PartialSlipProblem&, double);
template SolvedByRef solve_nip<RefPath>(const ElasticNipProblem&, int);
template SolvedByRef solve_nip<RefPath>(const ViscoelasticNipProblem&, int);
template SolvedByRef solve_nip<RefPath>(const PartialSlipProblem&, int);

}  // namespace nipref::verify
