#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <memory>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/fast/nip/line_load_field.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>
#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/nip_results.hpp>
#include <nipref/verify/solve/internal/paths.hpp>

namespace nipref::verify {
namespace {

/// The accuracy of the continuous contact to which line loads are compared; their distance to it is at least about
/// 1e-3.
constexpr double truth_accuracy = 1e-5;

/// The error of line loads is their distance to the truth, whose own error is added.
fast::Estimate compared_with(const fast::Estimate& truth, double value) {
  return {value, std::fabs(value - truth.value) + truth.error};
}

/// The contact of line loads in double, whose functions have the names of the results; each is compared with the same
/// result of the continuous contact.
template <class LineLoads>
SolvedInDouble compared_with_truth(const std::shared_ptr<LineLoads>& loads,
                                   const std::shared_ptr<const SolvedContact<fast::Estimate>>& truth,
                                   const auto& problem) {
  auto contact = std::make_unique<SolvedContact<fast::Estimate>>();
  const auto set = [&](ResultId id, auto function) {
    if constexpr (std::invocable<decltype(function), LineLoads&, double>) {
      contact->set(
          id, [=](double y) { return compared_with(truth->at(id, y), std::invoke(function, *loads, y)); });
    } else {
      contact->set(id, [=] { return compared_with(truth->number(id), std::invoke(function, *loads)); });
    }
  };
  set_nip_results<LineLoads>(set, [](const LineLoads&) { return 0.0; });
  set_inner_fields<FastPath>(
      [&](ResultId id, auto function) {
        contact->set(id, [=](const Places& places) {
          std::vector<fast::Estimate> numbers = function(places);
          const std::vector<fast::Estimate>& truths = truth->get(id, places);
          for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = compared_with(truths[i], numbers[i].value);
          return numbers;
        });
      },
      line_load_fields<FastPath>(loads, problem));
  complete_nip(*contact, problem);
  contact->measure = Measure::truth;
  contact->error_work = [truth] { return truth->work(); };
  return contact;
}

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
struct ElasticLineLoads : fast::LineLoadSolution {
  data::ElasticNip nip;
  LineLoadMethod method;
  Work work;  ///< grows with each result that is computed

  [[nodiscard]] double peak_pressure_position() const { return fast::place_of_largest_pressure(*this); }
  [[nodiscard]] double peak_shear_position() const { return fast::place_of_largest_shear(*this); }
  [[nodiscard]] double creep_ratio() { return fast::creep_ratio(nip, *this, method, &work); }
  /// The moments of the loads of one side (thesis 7.13); the other side mirrors them.
  [[nodiscard]] double leading_moment() const {
    double sum = 0;
    for (std::size_t k = 0; k < line_loads.size(); ++k)
      sum += line_loads[k] * (static_cast<double>(k) + 0.5) * element_width();
    return sum;
  }
  [[nodiscard]] double trailing_moment() const { return -leading_moment(); }
  [[nodiscard]] std::vector<fast::FaceLoad> face_loads() const {
    std::vector<fast::FaceLoad> all;
    for (std::size_t k = 0; k < line_loads.size(); ++k) {
      const double y = (static_cast<double>(k) + 0.5) * element_width(),
                   shear = shear_loads.empty() ? 0 : shear_loads[k];
      all.push_back({y, line_loads[k], shear});
      all.push_back({-y, line_loads[k], -shear});
    }
    return all;
  }
  [[nodiscard]] double pressure(double y) const { return fast::element_pressure(*this, y); }
  [[nodiscard]] double shear(double y) const { return fast::element_shear(*this, y); }
  [[nodiscard]] double normal_displacement(double y) {
    return fast::normal_displacement(nip, *this, method, y, &work);
  }
  [[nodiscard]] double tangential_displacement(double y) {
    return fast::tangential_displacement(nip, *this, method, y, &work);
  }
};

/// The error of a zero of the shear is its distance to the nearest zero of the continuous contact.
std::vector<Estimate> shear_zeros(const ElasticLineLoads& loads, const SolvedContact<Estimate>& truth) {
  const std::vector<Estimate>& zeros_of_truth = truth.get(ResultId::shear_zeros);
  std::vector<Estimate> zeros;
  for (const double place : fast::shear_borders(loads)) {
    const auto distance = [&](const Estimate& zero) { return std::fabs(zero.value - place); };
    zeros.push_back(compared_with(*std::ranges::min_element(zeros_of_truth, {}, distance), place));
  }
  return zeros;
}

/// The continuous contact has one creep ratio, to which all three are compared.
std::vector<Estimate> creep_range(ElasticLineLoads& loads, const SolvedContact<Estimate>& truth) {
  const double length = loads.contact_length;
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
  const LineLoadMethod method(wanted.leading_elements, wanted.residue_terms, fast::Accuracy(accuracy));
  Work work;
  const fast::LineLoadSolution solution = solve_loads(problem, method, &work);
  const auto loads =
      std::make_shared<ElasticLineLoads>(ElasticLineLoads{{solution}, problem.nip, method, work});
  SolvedInDouble contact = compared_with_truth(loads, truth, problem);
  contact->set(ResultId::shear_zeros, [=](const Places&) { return shear_zeros(*loads, *truth); });
  contact->set(ResultId::creep_range, [=](const Places&) { return creep_range(*loads, *truth); });
  contact->work = [loads] { return loads->work; };
  return contact;
}

namespace {

using fast::Estimate;
using fast::ViscoelasticLineLoadMethod;
using fast::ViscoelasticLineLoads;
using fast::Work;

/// Searches for the number of trailing elements for a load unless the method has it.
ViscoelasticLineLoads solve_loads(const data::ViscoelasticNipProblem& problem,
                                  const ViscoelasticLineLoadMethod& method, bool search) {
  const double leading_part =
      static_cast<double>(method.leading_elements) / (method.leading_elements + method.trailing_elements);
  return solve_given(
      problem.given,
      [&](double load) {
        return search ? fast::viscoelastic_line_loads_by_search(problem.nip, method, load)
                      : fast::viscoelastic_line_loads_for_load(problem.nip, method, load);
      },
      [&](double length) {
        return fast::viscoelastic_line_loads_for_length(problem.nip, method, length * leading_part);
      });
}

/// Solved line loads: what they were solved for, and their results. A search chooses the number of trailing elements.
struct RollingLineLoads : ViscoelasticLineLoads {
  data::ViscoelasticNip nip;
  ViscoelasticLineLoadMethod method;
  fast::ViscoelasticLineLoadSurface surface;

  RollingLineLoads(const data::ViscoelasticNipProblem& problem, const ViscoelasticLineLoadMethod& wanted,
                   bool search)
      : ViscoelasticLineLoads(solve_loads(problem, wanted, search)),
        nip(problem.nip),
        method{wanted.leading_elements, static_cast<int>(loads.size()) - wanted.leading_elements,
               wanted.approach, wanted.residue_terms},
        surface(nip, *this, method) {}

  [[nodiscard]] double peak_pressure_position() const {
    return place_of(static_cast<std::size_t>(std::ranges::max_element(loads) - loads.begin()));
  }
  [[nodiscard]] double creep_ratio() const { return fast::creep_ratio(nip, *this, method); }
  [[nodiscard]] double leading_moment() const { return moment(true); }
  [[nodiscard]] double trailing_moment() const { return moment(false); }
  [[nodiscard]] std::vector<fast::FaceLoad> face_loads() const {
    std::vector<fast::FaceLoad> all;
    for (std::size_t j = 0; j < loads.size(); ++j) all.push_back({place_of(j), loads[j], 0});
    return all;
  }
  [[nodiscard]] double pressure(double y) const { return fast::element_pressure(*this, y); }
  [[nodiscard]] double normal_displacement(double y) const { return surface.normal_displacement(y); }
  [[nodiscard]] double tangential_displacement(double y) const { return surface.tangential_displacement(y); }

 private:
  [[nodiscard]] double place_of(std::size_t number) const {
    return leading_length - (static_cast<double>(number) + 0.5) * element_width();
  }
  /// Of the loads of one side (thesis 7.13).
  [[nodiscard]] double moment(bool is_leading) const {
    double sum = 0;
    for (std::size_t j = 0; j < loads.size(); ++j) {
      const double y = place_of(j);
      if ((y > 0) == is_leading) sum += loads[j] * y;
    }
    return sum;
  }
};

}  // namespace

SolvedInDouble solve_line_loads(const data::ViscoelasticNipProblem& problem,
                                const data::ViscoelasticLineLoads& wanted, double /*accuracy*/) {
  const std::shared_ptr<const SolvedContact<Estimate>> truth = solve_converged(problem, truth_accuracy);
  const ViscoelasticLineLoadMethod method{wanted.leading_elements, wanted.trailing_elements.value_or(0),
                                          wanted.approach_lengths, wanted.residue_terms};
  const auto loads = std::make_shared<RollingLineLoads>(problem, method, !wanted.trailing_elements);
  SolvedInDouble contact = compared_with_truth(loads, truth, problem);
  contact->work = [loads] {
    Work work;
    work.systems = static_cast<std::uint64_t>(loads->systems);
    work.unknowns = static_cast<int>(loads->loads.size()) + 1;
    return work;
  };
  return contact;
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

}  // namespace

std::vector<SearchStep> thesis_search(const data::Scene& scene) {
  const auto of_problem = [&](auto problem) -> std::vector<SearchStep> {
    using Problem = decltype(problem);
    constexpr bool rolls = std::is_same_v<Problem, data::ViscoelasticNipProblem>;
    if constexpr (!std::is_same_v<Problem, data::HalfSpaceProblem>) {
      const auto* const load = std::get_if<data::GivenLoad>(&problem.given);
      if (load == nullptr || !is_by_line_loads(scene)) return {};
      const double wanted = load->per_length;
      const auto load_at = [&](const auto& method, auto... more) {
        return [&problem, method, more...](double length) {
          problem.given = data::GivenLength{length};
          return solve_loads(problem, method, more...).load;
        };
      };
      Work work;
      if constexpr (rolls) {
        const auto& given = std::get<data::ViscoelasticLineLoads>(problem.method);
        ViscoelasticLineLoadMethod method{given.leading_elements, given.trailing_elements.value_or(0),
                                          given.approach_lengths, given.residue_terms};
        if (!given.trailing_elements)
          method.trailing_elements =
              static_cast<int>(solve_loads(problem, method, true).loads.size()) - method.leading_elements;
        return steps_of_search(wanted, problem.nip.sheet_thickness, 1e-2, load_at(method, false));
      } else {
        const auto& given = std::get<data::LineLoads>(problem.method);
        const LineLoadMethod method(given.leading_elements, given.residue_terms,
                                    fast::Accuracy(scene.accuracy));
        auto frictionless = problem;
        frictionless.friction = data::Friction::none;
        const double first = problem.friction == data::Friction::none
                                 ? problem.nip.sheet_thickness
                                 : solve_loads(frictionless, method, &work).contact_length;
        return steps_of_search(wanted, first, 2e-3, load_at(method, &work));
      }
    }
    return {};
  };
  return std::visit(of_problem, scene.system);
}

}  // namespace nipref::verify
