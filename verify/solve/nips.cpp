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
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

using data::ConvergedMethod;
using data::ElasticNipProblem;
using data::PartialSlipProblem;
using data::ViscoelasticNipProblem;
using fast::Estimate;

data::LineLoadFriction line_load_friction_of(const ElasticNipProblem& problem) {
  if (problem.friction == data::Friction::none) return {};
  if (problem.creep_ratio) return data::LineLoadFriction::full(*problem.creep_ratio);
  return {data::LineLoadFriction::Kind::thesis_creep};
}

/// Calls for_load or for_length with the number that the scene gives.
auto for_given(const data::Given& given, const auto& for_load, const auto& for_length) {
  const auto* const load = std::get_if<data::GivenLoad>(&given);
  return load != nullptr ? for_load(load->per_length)
                         : for_length(std::get<data::GivenLength>(given).contact_length);
}

// Overloads: fast takes an accuracy, a double, where the reference takes digits, an int.
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
  const data::LineLoadFriction friction = line_load_friction_of(problem);
  return for_given(
      problem.given,
      [&](double load) { return fast::line_loads_for_load(problem.nip, method, load, friction); },
      [&](double length) { return fast::line_loads_for_length(problem.nip, method, length, friction); });
}
auto solution(FastPath, const PartialSlipProblem& problem, const data::LineLoads& by, double /*accuracy*/) {
  return fast::line_loads_for_load(problem.nip, by.leading_elements,
                                   std::get<data::GivenLoad>(problem.given).per_length);
}
[[noreturn]] ref::PartialSlipNip solution(RefPath, const PartialSlipProblem&, const data::LineLoads&, int) {
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
  const data::LineLoadFriction friction = line_load_friction_of(problem);
  return for_given(
      problem.given,
      [&](double load) { return ref::line_loads_for_load(problem.nip, method, load, digits, friction); },
      [&](double length) {
        return ref::line_loads_for_length(problem.nip, method, length, digits, friction);
      });
}
auto solution(RefPath, const ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& method,
              int digits) {
  return for_given(
      problem.given, [&](double load) { return ref::line_loads_for_load(problem.nip, method, load, digits); },
      [&](double length) { return ref::line_loads_for_length(problem.nip, method, length, digits); });
}

fast::Work work_of(const auto& by_fast) { return by_fast.work(); }
/// The reference counts its values of I1, of I3, and of the part of I6 that is not in I1.
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

/// The lowest and the highest creep ratio of the range that the thesis's conditions leave, and the one that it chooses.
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

// Stresses and displacements inside the sheet.
auto stresses(const auto& converged, const auto&, const auto& points, auto) {
  return converged.inner_stresses(points);
}
auto stresses(const fast::LineLoadNip& by, const auto& nip, const auto& points, double) {
  return fast::line_load_stresses(by.face_loads(), nip.half_thickness(), points);
}
auto stresses(const ref::LineLoadNip& by, const auto& nip, const auto& points, int digits) {
  return ref::line_load_stresses(by.face_loads(), nip.half_thickness(), points, digits);
}
auto displacements(const auto& converged, const auto&, const auto& points, auto) {
  return converged.inner_displacements(points);
}
auto displacements(const fast::LineLoadNip& by, const auto& nip, const auto& points, double) {
  return fast::line_load_displacements(by.face_loads(), nip.half_thickness(), nip.material, points);
}
auto displacements(const ref::LineLoadNip& by, const auto& nip, const auto& points, int digits) {
  return ref::line_load_displacements(by.face_loads(), nip.half_thickness(), nip.material, points, digits);
}

/// Sets the properties of the contact that are those of its problem.
template <class Number, class Problem>
void describe(SolvedContact<Number>& contact, const Problem& problem, Measure measure) {
  contact.is_symmetric = std::is_same_v<Problem, ElasticNipProblem>;
  contact.roller_radius = problem.nip.roller_radius;
  if constexpr (requires { problem.nip.speed; }) contact.speed = problem.nip.speed;
  if constexpr (requires { problem.nip.friction_coefficient; })
    contact.friction = problem.nip.friction_coefficient;
  contact.measure = measure;
}

/// A contact by either path and any method. The numbers of line loads in double have no error estimates yet.
template <class Path, class Problem, class Solution>
class SolvedNip final : public SolvedContact<typename Path::Number> {
  using Number = typename Path::Number;
  static constexpr bool slips = std::is_same_v<Problem, PartialSlipProblem>;

 public:
  SolvedNip(const Problem& problem, Solution solution, typename Path::Accuracy accuracy, Measure measured)
      : nip_(problem.nip), solution_(std::move(solution)), accuracy_(accuracy) {
    describe(*this, problem, measured);
  }
  [[nodiscard]] fast::Work work() const override { return work_of(solution_); }

 private:
  bool solve_again() override {
    if constexpr (requires { solution_.refine(); }) return solution_.refine();
    return false;
  }

  /// The solution's members, functions or numbers, have the names of the results.
  void answer(Asked<Number>& asked) const override {
    using enum ResultId;
    const auto set = [&](ResultId id, auto member) {
      asked.set(id, std::bind_front(member, std::cref(solution_)));
    };
    set(contact_length, &Solution::contact_length);
    set(leading_length, &Solution::leading_length);
    set(trailing_length, &Solution::trailing_length);
    set(load, &Solution::load);
    set(indentation, &Solution::indentation);
    set(edge_displacement, &Solution::leading_displacement);
    set(trailing_displacement, &Solution::trailing_displacement);
    set(rolling_resistance, &Solution::rolling_resistance);
    set(creep_ratio, &Solution::creep_ratio);
    set(pressure, &Solution::pressure);
    set(peak_pressure, &Solution::peak_pressure);
    set(peak_pressure_position, &Solution::peak_pressure_position);
    set(shear, &Solution::shear);
    set(peak_shear, &Solution::peak_shear);
    set(peak_shear_position, &Solution::peak_shear_position);
    set(normal_displacement, &Solution::normal_displacement);
    set(tangential_displacement, &Solution::tangential_displacement);
    // Results that only some methods have.
    if constexpr (requires { &Solution::leading_moment; }) {
      set(leading_moment, &Solution::leading_moment);
      set(trailing_moment, &Solution::trailing_moment);
    }
    if constexpr (requires { &Solution::surface_strain; }) set(surface_strain, &Solution::surface_strain);
    if constexpr (requires { &Solution::slip; }) set(slip, &Solution::slip);
    if constexpr (requires { &Solution::shear_zeros; }) set(shear_zeros, &Solution::shear_zeros);
    if constexpr (requires { creep_range_of(solution_); })
      asked.set(creep_range, [&] { return creep_range_of(solution_); });
    if constexpr (slips) {
      set(traction, &Solution::traction);
      set(dissipation, &Solution::dissipation);
      set(zone_boundaries, &Solution::zone_boundaries);
      asked.set(zone_signs, [&] {
        return mapped(std::invoke(&Solution::zone_signs, solution_),
                      [&](int sign) { return as_number(sign); });
      });
    } else {
      answer_inside(asked);
    }
  }

  Number as_number(int sign) const {
    Number number = exactly(sign, this->number(ResultId::load));
    if constexpr (requires { number.proven; }) number.proven = false;
    return number;
  }

  /// Answers with stresses inside the sheet and, in an elastic nip, displacements inside it.
  void answer_inside(Asked<Number>& asked) const {
    using enum ResultId;
    const auto points = mapped(asked.places, [](const Place& one) {
      return typename Path::Point{one.y, one.depth};
    });
    const auto at = [&] { return stresses(solution_, nip_, points, accuracy_); };
    using Stresses = typename decltype(at())::value_type;
    asked.set_parts(
        at, std::pair(stress_across, &Stresses::across), std::pair(stress_along, &Stresses::along),
        std::pair(stress_shear, &Stresses::shear), std::pair(highest_stress, &Stresses::highest),
        std::pair(lowest_stress, &Stresses::lowest), std::pair(maximum_shear, &Stresses::maximum_shear));
    if constexpr (std::is_same_v<Problem, ElasticNipProblem>) {
      const auto moved = [&] { return displacements(solution_, nip_, points, accuracy_); };
      using Displacements = typename decltype(moved())::value_type;
      asked.set_parts(moved, std::pair(displacement_across, &Displacements::across),
                      std::pair(displacement_along, &Displacements::along));
    }
    if constexpr (requires { solution_.greatest_shear(); }) {
      using Greatest = decltype(solution_.greatest_shear());
      asked.set_parts([&] { return std::array{solution_.greatest_shear()}; },
                      std::pair(greatest_shear, &Greatest::value),
                      std::pair(greatest_shear_position, &Greatest::y),
                      std::pair(greatest_shear_depth, &Greatest::depth));
    }
  }

  decltype(Problem::nip) nip_;
  Solution solution_;
  typename Path::Accuracy accuracy_;
};

template <class Path, class Problem, class Method>
Solved<Path> solved_by(const Problem& problem, const Method& method, typename Path::Accuracy accuracy) {
  constexpr bool converges = std::is_same_v<Method, ConvergedMethod>;
  const bool has_errors_of_itself =
      !Path::is_fast && (!converges || std::is_same_v<Problem, ElasticNipProblem>);
  auto found = solution(Path(), problem, method, accuracy);
  return std::make_unique<SolvedNip<Path, Problem, decltype(found)>>(
      problem, std::move(found), accuracy, has_errors_of_itself ? Measure::itself : Measure::size);
}

/// The accuracy of the continuous contact to which line loads are compared; their distance to it is at least about
/// 1e-3.
constexpr double truth_accuracy = 1e-5;

/// Line loads in double. The error of each number is its distance to the number of the continuous contact, in a list to
/// the nearest number, plus the error of that number.
class ComparedLineLoads final : public SolvedContact<Estimate> {
 public:
  ComparedLineLoads(const auto& problem, const auto& method, double accuracy)
      : loads_(solved_by<FastPath>(problem, method, accuracy)),
        truth_(solved_by<FastPath>(problem, ConvergedMethod(), truth_accuracy)) {
    describe(*this, problem, Measure::truth);
  }
  [[nodiscard]] fast::Work work() const override { return loads_->work(); }
  [[nodiscard]] fast::Work error_work() const override { return truth_->work(); }

 private:
  void answer(Asked<Estimate>& asked) const override {
    if (is_product(asked.id)) return;  // a product of numbers that were compared
    // The continuous contact has one creep ratio, to which all three are compared.
    const auto& truths = asked.id == ResultId::creep_range ? truth_->get(ResultId::creep_ratio)
                                                           : truth_->get(asked.id, asked.places);
    const bool is_list = data::scene_result(asked.id).shape == data::Shape::list;
    std::vector<Estimate> numbers = loads_->get(asked.id, asked.places);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      auto& [value, error] = numbers[i];
      const auto distance = [value = value](const Estimate& one) { return std::fabs(value - one.value); };
      const Estimate& truth = is_list ? *std::ranges::min_element(truths, {}, distance) : truths[i];
      error = distance(truth) + truth.error;
    }
    asked.answer[asked.id] = std::move(numbers);
  }

  SolvedInDouble loads_, truth_;
};

/// The steps of thesis_search() for a scene of this problem and these line loads. Each length is the last one times the
/// cube root of the wanted load over the load found. The steps end at a length for which no load is found.
template <class Problem, class Method>
std::vector<SearchStep> steps_of(const data::Scene& scene) {
  const auto* const given = std::get_if<Problem>(&scene.system);
  if (given == nullptr || !std::holds_alternative<Method>(given->method)) return {};
  const auto* const wanted = std::get_if<data::GivenLoad>(&given->given);
  if (wanted == nullptr) return {};
  Problem problem = *given;
  Method method = std::get<Method>(given->method);
  const auto loads_of = [&](const Problem& one) { return solution(FastPath(), one, method, scene.accuracy); };
  double length = problem.nip.sheet_thickness, tolerance = 1e-2;
  if constexpr (std::is_same_v<Problem, ElasticNipProblem>) {
    tolerance = 2e-3;
    Problem slipping = problem;
    slipping.friction = data::Friction::none;
    if (has_full_friction(problem)) length = loads_of(slipping).contact_length();
  } else if (!method.trailing_elements) {
    method.trailing_elements = loads_of(problem).trailing_elements();
  }
  constexpr std::size_t most = 100;
  std::vector<SearchStep> steps;
  try {
    while (steps.size() < most) {
      problem.given = data::GivenLength{length};
      steps.push_back({length, loads_of(problem).load()});
      const double found = steps.back().load;
      if (!(found > 0) || std::fabs(found / wanted->per_length - 1) <= tolerance) break;
      length *= std::cbrt(wanted->per_length / found);
    }
  } catch (const data::BadInput&) {  // no creep meets the thesis's conditions there
  }
  return steps;
}

}  // namespace

template <class Path, class Problem>
Solved<Path> solve_nip(const Problem& problem, typename Path::Accuracy accuracy) {
  const auto solve_by = [&](const auto& method) -> Solved<Path> {
    if constexpr (Path::is_fast && requires { method.leading_elements; })
      return std::make_unique<ComparedLineLoads>(problem, method, accuracy);
    return solved_by<Path>(problem, method, accuracy);
  };
  return std::visit(solve_by, problem.method);
}

std::vector<SearchStep> thesis_search(const data::Scene& scene) {
  const auto steps = steps_of<ElasticNipProblem, data::LineLoads>(scene);
  return steps.empty() ? steps_of<ViscoelasticNipProblem, data::ViscoelasticLineLoads>(scene) : steps;
}

template SolvedInDouble solve_nip<FastPath>(const ElasticNipProblem&, double);
template SolvedInDouble solve_nip<FastPath>(const ViscoelasticNipProblem&, double);
template SolvedInDouble solve_nip<FastPath>(const PartialSlipProblem&, double);
template SolvedByRef solve_nip<RefPath>(const ElasticNipProblem&, int);
template SolvedByRef solve_nip<RefPath>(const ViscoelasticNipProblem&, int);
template SolvedByRef solve_nip<RefPath>(const PartialSlipProblem&, int);

}  // namespace nipref::verify
