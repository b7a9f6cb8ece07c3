#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/verify/solve/internal/compared_with_truth.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using fast::LineLoadMethod;
using fast::Work;

[[noreturn]] void refuse_without_creep(const char* argument, double value) {
  throw data::BadInput(
      argument, value,
      "no creep meets the thesis's conditions here: friction.creep_ratio must be given, or other elements");
}

/// Line loads without friction, with a given creep, or with the creep that meets the thesis's conditions.
fast::LineLoadSolution solve_loads(const data::ElasticNipProblem& problem, const LineLoadMethod& method,
                                   Work* work) {
  const data::ElasticNip& nip = problem.nip;
  if (problem.friction == data::Friction::none)
    return solve_given(
        problem.given, [&](double load) { return fast::line_loads_for_load(nip, method, load, {}, work); },
        [&](double length) { return fast::line_loads_for_length(nip, method, length, work); });
  if (const auto creep = problem.creep_ratio)
    return solve_given(
        problem.given,
        [&](double load) { return fast::gripped_line_loads_for_load(nip, method, load, *creep, {}, work); },
        [&](double length) {
          return fast::gripped_line_loads_for_length(nip, method, length, *creep, work);
        });
  return solve_given(
      problem.given,
      [&](double load) {
        auto solution = fast::thesis_line_loads_for_load(nip, method, load, {}, work);
        if (!solution) refuse_without_creep("load", load);
        return *std::move(solution);
      },
      [&](double length) {
        auto solution = fast::thesis_line_loads_for_length(nip, method, length, work);
        if (!solution) refuse_without_creep("contact_length", length);
        return *std::move(solution);
      });
}

/// Solved line loads: what they were solved for, and their results.
struct ElasticLineLoads {
  data::ElasticNip nip;
  LineLoadMethod method;
  Work work;  ///< grows with each result that is computed
  fast::LineLoadSolution solution;

  ElasticLineLoads(const data::ElasticNipProblem& problem, LineLoadMethod with)
      : nip(problem.nip), method(std::move(with)), solution(solve_loads(problem, method, &work)) {}

  [[nodiscard]] double contact_length() const { return solution.contact_length; }
  [[nodiscard]] double load() const { return solution.load; }
  [[nodiscard]] double indentation() const { return solution.indentation; }
  [[nodiscard]] double edge_displacement() const { return solution.edge_displacement; }
  [[nodiscard]] double peak_pressure() const { return solution.peak_pressure; }
  [[nodiscard]] double peak_shear() const { return solution.peak_shear; }
  [[nodiscard]] double peak_pressure_position() const { return fast::place_of_largest_pressure(solution); }
  [[nodiscard]] double peak_shear_position() const { return fast::place_of_largest_shear(solution); }
  [[nodiscard]] double creep_ratio() { return fast::creep_ratio(nip, solution, method, &work); }
  /// The moments of the loads of one side (thesis 7.13); the other side mirrors them.
  [[nodiscard]] double leading_moment() const {
    double sum = 0;
    for (std::size_t k = 0; k < solution.line_loads.size(); ++k)
      sum += solution.line_loads[k] * (static_cast<double>(k) + 0.5) * solution.element_width();
    return sum;
  }
  [[nodiscard]] double trailing_moment() const { return -leading_moment(); }
  [[nodiscard]] double pressure(double y) const { return fast::element_pressure(solution, y); }
  [[nodiscard]] double shear(double y) const { return fast::element_shear(solution, y); }
  [[nodiscard]] double normal_displacement(double y) {
    return fast::normal_displacement(nip, solution, method, y, &work);
  }
  [[nodiscard]] double tangential_displacement(double y) {
    return fast::tangential_displacement(nip, solution, method, y, &work);
  }
};

/// The error of a zero of the shear is its distance to the nearest zero of the continuous contact.
std::vector<Estimate> shear_zeros(const ElasticLineLoads& loads, const SolvedContact<Estimate>& truth) {
  const std::vector<Estimate>& zeros_of_truth = truth.get(ResultId::shear_zeros);
  std::vector<Estimate> zeros;
  for (const double place : fast::shear_borders(loads.solution)) {
    const auto distance = [&](const Estimate& zero) { return std::fabs(zero.value - place); };
    zeros.push_back(compared_with(*std::ranges::min_element(zeros_of_truth, {}, distance), place));
  }
  return zeros;
}

/// The continuous contact has one creep ratio, to which all three are compared.
std::vector<Estimate> creep_range(ElasticLineLoads& loads, const SolvedContact<Estimate>& truth) {
  const double length = loads.solution.contact_length;
  const auto creep = fast::thesis_creep(loads.nip, loads.method, length, &loads.work);
  if (!creep) refuse_without_creep("contact_length", length);
  const Estimate& creep_of_truth = truth.number(ResultId::creep_ratio);
  return {compared_with(creep_of_truth, creep->range.lower),
          compared_with(creep_of_truth, creep->range.upper), compared_with(creep_of_truth, creep->chosen)};
}

}  // namespace

SolvedInDouble solve_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& wanted,
                                double accuracy) {
  const std::shared_ptr<const SolvedContact<Estimate>> truth = solve_converged(problem, truth_accuracy);
  const auto loads = std::make_shared<ElasticLineLoads>(
      problem, LineLoadMethod(wanted.leading_elements, wanted.residue_terms, fast::Accuracy(accuracy)));
  SolvedInDouble contact = compared_with_truth(loads, truth, problem);
  contact->set(ResultId::shear_zeros, [=](const Places&) { return shear_zeros(*loads, *truth); });
  contact->set(ResultId::creep_range, [=](const Places&) { return creep_range(*loads, *truth); });
  contact->work = [loads] { return loads->work; };
  return contact;
}

}  // namespace nipref::verify
