#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

std::vector<double> places_between(const data::Profile& profile, const ContactEnds& ends) {
  if (const auto* const given = std::get_if<data::Positions>(&profile)) return given->y;
  const int points = std::get<data::EvenlySpaced>(profile).points;
  return mapped(std::views::iota(0, points), [&](int i) {
    return std::lerp(ends.first, ends.last, static_cast<double>(i) / (points - 1));
  });
}

/// The key of what a scene gives (load, length or speed), its value, and the name of the argument of the solver.
struct GivenKey {
  const char* key;
  double value;
  std::string_view argument;
};
GivenKey given_key(const data::HalfSpaceProblem& problem) {
  const bool rolls = std::holds_alternative<data::RigidRollingSphere>(problem.body);
  return {rolls ? "rolling.speed" : "sliding.speed", problem.speed, "speed"};
}
GivenKey given_key(const auto& nip) {
  if (const auto* const load = std::get_if<data::GivenLoad>(&nip.given))
    return {"load.per_length", load->per_length, "load"};
  return {"contact.length", std::get<data::GivenLength>(nip.given).contact_length, "contact_length"};
}

/// The keys of the solvers' other arguments.
constexpr std::pair<std::string_view, const char*> other_keys[] = {
    {"nip.material", "material"},
    {"method.kind", "method.kind"},
    {"elements_per_side", "method.leading_elements"},
    {"residue_terms", "method.residue_terms"},
    {"force_per_length", "traction.force_per_length"},
    {"friction_coefficient", "friction.coefficient"}};

/// A value or an error overflows only if the scene's own numbers are at the ends of the range of double.
bool is_finite(const fast::Estimate& number) {
  return std::isfinite(number.value) && std::isfinite(number.error);
}
/// No scene leaves the range of these numbers.
bool is_finite(const ref::Estimate&) { return true; }

long double magnitude_of(const fast::Estimate& number) { return std::fabs(number.value); }
long double magnitude_of(const ref::Estimate& number) {
  return std::fabs(mpfr_get_ld(ref::raw(number.value), MPFR_RNDN));
}

/// Collects what a scene wants of its contact.
template <class Number>
struct Collector {
  using Result = typename SceneSolution<Number>::Result;
  const data::Scene& scene;
  const SolvedContact<Number>& contact;
  SceneSolution<Number>& solution;

  /// The result at this place of the scene's list.
  [[nodiscard]] Result result(std::size_t wanted) const {
    Result found{&data::scene_result(scene.wanted[wanted]), {}};
    const Places places = places_of(found.what->shape);
    found.numbers = found.what->shape == data::Shape::profile ? profile(found.what->id, places)
                                                              : contact.get(found.what->id, places);
    if (!std::ranges::all_of(found.numbers, [](const Number& number) { return is_finite(number); }))
      scene.origin.refuse(fmt::format("wanted[{}]", wanted), found.what->name,
                          "must be left out: in this scene it leaves the range of doubles");
    if (contact.measure != Measure::truth) found.allowed = allowed_errors(found, places);
    return found;
  }

 private:
  [[nodiscard]] Places places_of(data::Shape shape) const {
    Places places;
    if (shape == data::Shape::profile)
      for (const double y : solution.positions) places.push_back({y});
    if (shape == data::Shape::field) {
      for (const double depth : solution.field.depths)
        for (const double y : solution.field.positions) places.push_back({y, depth});
    }
    return places;
  }
  /// The numbers of a profile. BadInput names the position that is refused.
  [[nodiscard]] std::vector<Number> profile(ResultId id, const Places& places) const {
    std::vector<Number> numbers;
    for (const Place& place : places) {
      try {
        numbers.push_back(contact.at(id, place.y));
      } catch (const data::BadInput& error) {
        scene.origin.refuse_as(fmt::format("profile.positions[{}]", numbers.size()), error);
      }
    }
    return numbers;
  }
  /// The largest error of each number that meets the accuracy. The digits of the reference are relative to the largest
  /// number of the result.
  [[nodiscard]] std::vector<long double> allowed_errors(const Result& found, const Places& places) const {
    auto magnitudes = mapped(found.numbers, [](const Number& number) { return magnitude_of(number); });
    if (std::is_same_v<Number, ref::Estimate> && !magnitudes.empty())
      magnitudes.assign(magnitudes.size(), std::ranges::max(magnitudes));
    std::vector<long double> allowed;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) {
      const double y = places.empty() ? 0 : places[i].y, accuracy = static_cast<double>(solution.accuracy);
      const long double least = result_size(contact, found.what->id, y, accuracy);
      allowed.push_back(solution.accuracy * std::max(least, magnitudes[i]));
    }
    return allowed;
  }
};

/// The largest ratio of an error of the result to its allowed error.
long double excess(const SceneSolution<fast::Estimate>::Result& result) {
  long double largest = 0;
  for (std::size_t i = 0; i < result.numbers.size(); ++i)
    largest = std::max(largest, result.numbers[i].error / result.allowed[i]);
  return largest;
}

/// Computes again, by a contact that was refined, the results that miss the accuracy. More terms may increase rounding
/// errors, so that a result is replaced only by a better one.
void collect_better(const data::Scene& scene, const SolvedContact<fast::Estimate>& contact,
                    SceneSolution<fast::Estimate>& solution) {
  for (std::size_t wanted = 0; wanted < solution.results.size(); ++wanted) {
    auto& result = solution.results[wanted];
    if (result.met().value_or(true)) continue;
    auto refined = Collector<fast::Estimate>{scene, contact, solution}.result(wanted);
    if (excess(refined) < excess(result)) result = std::move(refined);
  }
  solution.work = contact.work();
}

/// Whether the scene is solved by line loads.
bool is_by_line_loads(const data::Scene& scene) {
  return std::visit(
      [](const auto& problem) {
        if constexpr (requires { problem.method; })
          return !std::holds_alternative<data::ConvergedMethod>(problem.method);
        return false;
      },
      scene.system);
}

void refuse_moments_by_ref(const data::Scene& scene) {
  if (std::holds_alternative<data::ViscoelasticNipProblem>(scene.system) && is_by_line_loads(scene)) return;
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    if (is_moment(scene.wanted[i])) {
      scene.origin.refuse(
          fmt::format("wanted[{}]", i), data::scene_result(scene.wanted[i]).name,
          "must be wanted of the fast path: the reference has the eccentricity, their sum over the load, "
          "and moments of rolling line loads");
    }
  }
}

/// Throws a solver's error again and names the key of the scene: the solver may refuse what Scene::check has accepted.
[[noreturn]] void refuse_by_key(const data::Scene& scene, const data::BadInput& error) {
  const auto [key, value, argument] =
      std::visit([](const auto& problem) { return given_key(problem); }, scene.system);
  if (const auto* const material = dynamic_cast<const data::NoMaterial*>(&error))
    scene.origin.refuse_as(material->key(), error);
  if (error.argument() == "digits") throw data::BadInput(error);
  if (error.argument().ends_with(" rate")) scene.origin.refuse_as("material", error);
  for (const auto& [name, its_key] : other_keys)
    if (error.argument() == name) scene.origin.refuse_as(its_key, error);
  if (error.argument() == argument) scene.origin.refuse_as(key, error);
  scene.origin.refuse(key, value, fmt::format("cannot be solved ({})", error.what()));
}

}  // namespace

bool wants(const data::Scene& scene, data::Shape shape) {
  return std::ranges::any_of(scene.wanted,
                             [&](ResultId id) { return data::scene_result(id).shape == shape; });
}

template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact) {
  const auto of_problem = [&](const auto& problem) -> std::vector<BeyondTheory> {
    if constexpr (requires { problem.nip; }) {
      const double indentation = value_of(contact.number(ResultId::indentation)),
                   half = problem.nip.half_thickness();
      const auto [key, given, argument] = given_key(problem);
      if (!(indentation < half))
        scene.origin.refuse(
            key, given,
            fmt::format(
                "must be smaller: the faces of the rollers would meet, each {:.3g} into the sheet, of "
                "which half is {:g}",
                indentation, half));
      const auto [first, last] = contact.ends();
      const double farther = std::max(std::fabs(first), std::fabs(last));
      std::vector<BeyondTheory> found{
          {"compressive_strain", indentation / half, linear_theory_limit},
          {"roller_slope", farther / problem.nip.roller_radius, linear_theory_limit}};
      std::erase_if(found, [](const BeyondTheory& one) { return one.value <= one.limit; });
      return found;
    }
    return {};
  };
  return std::visit(of_problem, scene.system);
}

template std::vector<BeyondTheory> beyond_theory(const data::Scene&, const SolvedContact<fast::Estimate>&);
template std::vector<BeyondTheory> beyond_theory(const data::Scene&, const SolvedContact<ref::Estimate>&);

template <class Number>
SceneSolution<Number> collect_results(const data::Scene& scene, const SolvedContact<Number>& contact,
                                      long double accuracy) {
  SceneSolution<Number> solution;
  solution.title = scene.title;
  solution.accuracy = accuracy;
  solution.is_discrete = is_by_line_loads(scene);
  solution.warnings = beyond_theory(scene, contact);
  std::visit(
      [&](const auto& problem) {
        if (wants(scene, data::Shape::profile))
          solution.positions = places_between(*problem.profile, contact.profile_ends());
        if constexpr (requires { problem.field; })
          if (wants(scene, data::Shape::field)) solution.field = *problem.field;
      },
      scene.system);
  for (std::size_t wanted = 0; wanted < scene.wanted.size(); ++wanted)
    solution.results.push_back(Collector<Number>{scene, contact, solution}.result(wanted));
  solution.work = contact.work();
  solution.error_work = contact.error_work();
  return solution;
}

template SceneSolution<fast::Estimate> collect_results(const data::Scene&,
                                                       const SolvedContact<fast::Estimate>&, long double);
template SceneSolution<ref::Estimate> collect_results(const data::Scene&, const SolvedContact<ref::Estimate>&,
                                                      long double);

template <class Path>
Solved<Path> solved(const data::Scene& scene, typename Path::Accuracy accuracy) try {
  const auto solve_one = [&](const auto& problem) -> Solved<Path> {
    if constexpr (requires { problem.nip; }) {
      return solve_nip<Path>(problem, accuracy);
    } else if constexpr (Path::is_fast) {
      return solve_half_space(problem);
    } else {
      const ref::JointResponse surface(problem, accuracy);
      surface.check_subcritical();
      return solve_ref_half_space(surface, problem, accuracy);
    }
  };
  return std::visit(solve_one, scene.system);
} catch (const data::BadInput& error) {
  refuse_by_key(scene, error);
}

template Solved<FastPath> solved<FastPath>(const data::Scene&, double);
template Solved<RefPath> solved<RefPath>(const data::Scene&, int);

SceneSolution<fast::Estimate> solve(const data::Scene& scene) {
  scene.check();
  auto [solution, seconds] = timed([&] {
    const auto contact = solved<FastPath>(scene, scene.accuracy);
    auto found = collect_results(scene, *contact, scene.accuracy);
    while (!found.missed().empty() && contact->refine()) collect_better(scene, *contact, found);
    return found;
  });
  solution.seconds = seconds;
  return solution;
}

SceneSolution<ref::Estimate> solve_by_ref(const data::Scene& scene, int digits) {
  scene.check();
  refuse_moments_by_ref(scene);
  auto [solution, seconds] = timed(
      [&] { return collect_results(scene, *solved<RefPath>(scene, digits), std::pow(10.0L, -digits)); });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
