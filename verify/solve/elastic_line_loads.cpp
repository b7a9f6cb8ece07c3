#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/verify/solve/internal/line_load_contact.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using fast::LineLoadMethod;
using fast::Work;

const std::map<ResultId, double fast::LineLoadSolution::*> elastic_line_load_numbers{
    {ResultId::contact_length, &fast::LineLoadSolution::contact_length},
    {ResultId::load, &fast::LineLoadSolution::load},
    {ResultId::indentation, &fast::LineLoadSolution::indentation},
    {ResultId::edge_displacement, &fast::LineLoadSolution::edge_displacement},
    {ResultId::trailing_displacement, &fast::LineLoadSolution::edge_displacement},
    {ResultId::peak_pressure, &fast::LineLoadSolution::peak_pressure},
    {ResultId::peak_shear, &fast::LineLoadSolution::peak_shear},
};

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

class ElasticLineLoads : public LineLoadContact {
 public:
  ElasticLineLoads(const data::ElasticNipProblem& problem, LineLoadMethod method)
      : LineLoadContact(solve_converged(problem, truth_accuracy)),
        nip_(problem.nip),
        method_(std::move(method)),
        solution_(solve_loads(problem, method_, &work_)) {}

  /// The error of a zero of the shear is its distance to the nearest zero of the continuous contact.
  [[nodiscard]] std::vector<Estimate> list(ResultId id) const override {
    if (id == ResultId::creep_range) return creep_range();
    const std::vector<Estimate> zeros_of_truth = truth().list(id);
    std::vector<Estimate> zeros;
    for (const double place : fast::shear_borders(solution_)) {
      zeros.push_back(
          estimate(place, *std::ranges::min_element(zeros_of_truth, {}, [&](const Estimate& zero) {
                     return std::fabs(zero.value - place);
                   })));
    }
    return zeros;
  }
  [[nodiscard]] ProfileExtent profile_extent() const override { return {0, solution_.contact_length / 2}; }
  [[nodiscard]] Work work() const override { return work_; }

 private:
  /// The continuous contact has one creep ratio, to which all three are compared.
  [[nodiscard]] std::vector<Estimate> creep_range() const {
    const auto creep = fast::thesis_creep(nip_, method_, solution_.contact_length, &work_);
    if (!creep) refuse_without_creep("contact_length", solution_.contact_length);
    const Estimate creep_of_truth = truth().number(ResultId::creep_ratio);
    return {estimate(creep->range.lower, creep_of_truth), estimate(creep->range.upper, creep_of_truth),
            estimate(creep->chosen, creep_of_truth)};
  }
  /// The loads of one side are given; the other side mirrors them.
  [[nodiscard]] double moment(ResultId id) const override {
    double sum = 0;
    for (std::size_t k = 0; k < solution_.line_loads.size(); ++k)
      sum += solution_.line_loads[k] * (static_cast<double>(k) + 0.5) * solution_.element_width();
    return id == ResultId::leading_moment ? sum : -sum;
  }
  [[nodiscard]] double value(ResultId id) const override {
    if (id == ResultId::leading_length || id == ResultId::trailing_length)
      return solution_.contact_length / 2;
    if (id == ResultId::rolling_resistance) return 0;
    if (id == ResultId::peak_pressure_position) return fast::place_of_largest_pressure(solution_);
    if (id == ResultId::peak_shear_position) return fast::place_of_largest_shear(solution_);
    if (id == ResultId::creep_ratio) return fast::creep_ratio(nip_, solution_, method_, &work_);
    return solution_.*elastic_line_load_numbers.at(id);
  }
  [[nodiscard]] double profile(ResultId id, double y) const override {
    if (id == ResultId::pressure) return fast::element_pressure(solution_, y);
    if (id == ResultId::shear) return fast::element_shear(solution_, y);
    if (id == ResultId::normal_displacement) {
      return fast::normal_displacement(nip_, solution_, method_, y, &work_);
    }
    return fast::tangential_displacement(nip_, solution_, method_, y, &work_);
  }

  data::ElasticNip nip_;
  LineLoadMethod method_;
  mutable Work work_;  ///< grows with each result that is computed
  fast::LineLoadSolution solution_;
};

}  // namespace

SolvedInDouble solve_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& loads,
                                double accuracy) {
  return std::make_unique<ElasticLineLoads>(
      problem, LineLoadMethod(loads.leading_elements, loads.residue_terms, fast::Accuracy(accuracy)));
}

}  // namespace nipref::verify
