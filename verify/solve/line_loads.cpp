#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/nip_results.hpp>
#include <nipref/verify/solve/internal/paths.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using fast::LineLoadNip;

/// The accuracy of the continuous contact to which line loads are compared; their distance to it is at least about
/// 1e-3.
constexpr double truth_accuracy = 1e-5;

/// The error of line loads is their distance to the truth, whose own error is added.
Estimate compared_with(const Estimate& truth, double value) {
  return {value, std::fabs(value - truth.value) + truth.error};
}

/// The error of each number of a list is its distance to the nearest of the truth's.
std::vector<Estimate> compared_with_nearest(const std::vector<Estimate>& truths,
                                            const std::vector<double>& values) {
  return mapped(values, [&](double value) {
    const auto distance = [&](const Estimate& truth) { return std::fabs(truth.value - value); };
    return compared_with(*std::ranges::min_element(truths, {}, distance), value);
  });
}

/// The continuous contact has one creep ratio, to which all three are compared.
std::vector<Estimate> creep_range(const LineLoadNip& loads, const SolvedContact<Estimate>& truth) {
  const auto creep = fast::thesis_creep(loads.creep_ranges);
  if (!creep)
    throw data::BadInput("contact_length", loads.contact_length(),
                         "no creep meets the thesis's conditions here: other elements may have one");
  const Estimate& creep_of_truth = truth.number(ResultId::creep_ratio);
  return {compared_with(creep_of_truth, creep->range.lower),
          compared_with(creep_of_truth, creep->range.upper), compared_with(creep_of_truth, creep->chosen)};
}

/// Line loads in double, whose functions have the names of the results; each is compared with the same result of the
/// continuous contact.
SolvedInDouble compared_with_truth(const auto& problem, const auto& for_load, const auto& for_length) {
  const std::shared_ptr<const SolvedContact<Estimate>> truth = solve_converged(problem, truth_accuracy);
  const auto loads = std::make_shared<const LineLoadNip>(solve_given(problem.given, for_load, for_length));
  auto contact = std::make_unique<SolvedContact<Estimate>>();
  const auto set = [&](ResultId id, auto function) {
    if constexpr (std::invocable<decltype(function), const LineLoadNip&, double>) {
      contact->set(
          id, [=](double y) { return compared_with(truth->at(id, y), std::invoke(function, *loads, y)); });
    } else if constexpr (std::is_same_v<std::invoke_result_t<decltype(function), const LineLoadNip&>,
                                        std::vector<double>>) {
      contact->set(id, [=](const Places&) {
        return compared_with_nearest(truth->get(id), std::invoke(function, *loads));
      });
    } else {
      contact->set(id, [=] { return compared_with(truth->number(id), std::invoke(function, *loads)); });
    }
  };
  set_nip_results<LineLoadNip>(set);
  contact->set(ResultId::creep_range, [=](const Places&) { return creep_range(*loads, *truth); });
  set_inner_fields<FastPath>(
      [&](ResultId id, auto function) {
        contact->set(id, [=](const Places& places) {
          std::vector<Estimate> numbers = function(places);
          const std::vector<Estimate>& truths = truth->get(id, places);
          for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = compared_with(truths[i], numbers[i].value);
          return numbers;
        });
      },
      line_load_fields<FastPath>(loads, problem));
  complete_nip(*contact, problem);
  contact->measure = Measure::truth;
  contact->work = [loads] { return loads->work(); };
  contact->error_work = [truth] { return truth->work(); };
  return contact;
}

fast::LineLoadMethod method_of(const data::LineLoads& wanted, double accuracy) {
  return {wanted.leading_elements, wanted.residue_terms, fast::Accuracy(accuracy)};
}

}  // namespace

SolvedInDouble solve_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& wanted,
                                double accuracy) {
  const auto method = method_of(wanted, accuracy);
  const data::Grip grip = grip_of(problem);
  return compared_with_truth(
      problem, [&](double load) { return fast::line_loads_for_load(problem.nip, method, load, grip); },
      [&](double length) { return fast::line_loads_for_length(problem.nip, method, length, grip); });
}

SolvedInDouble solve_line_loads(const data::ViscoelasticNipProblem& problem,
                                const data::ViscoelasticLineLoads& method, double /*accuracy*/) {
  const double leading = method.leading_elements;
  const double leading_part = leading / (leading + method.trailing_elements.value_or(leading));
  return compared_with_truth(
      problem, [&](double load) { return fast::line_loads_for_load(problem.nip, method, load); },
      [&](double length) { return fast::line_loads_for_length(problem.nip, method, length * leading_part); });
}

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
  const auto method = method_of(std::get<data::LineLoads>(problem.method), accuracy);
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
        if constexpr (!std::is_same_v<decltype(problem), const data::HalfSpaceProblem&>) {
          const auto* const load = std::get_if<data::GivenLoad>(&problem.given);
          if (load != nullptr && is_by_line_loads(scene))
            return steps_to(problem, load->per_length, scene.accuracy);
        }
        return {};
      },
      scene.system);
}

}  // namespace nipref::verify
