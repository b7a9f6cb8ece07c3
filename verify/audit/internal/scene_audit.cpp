#include <exception>

#include <nipref/data/number/with_error.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using Solution = SceneSolution<Estimate>;

constexpr double best_accuracy = 1e-13;
/// The digits asked of the reference: for half-spaces, and for nips, of which each digit costs more.
constexpr int ref_digits = 20, ref_digits_of_nips = 16;
constexpr double longest_by_ref = 20, longest_inside_by_ref = 1;  // L/B
constexpr double most_seconds_by_ref = 20;                        // estimated
/// The shares of scenes whose costly results are compared: those for which the reference takes seconds, or about ten
/// seconds where the lines of a half-space differ.
constexpr double costly_share = 1.0 / 16, costliest_share = 1.0 / 64;
/// The largest speed over the critical speed. Beyond it, integrals over lines that differ need thousands of lines.
constexpr double fastest_by_ref = 0.98;

/// A value of the reference, with more digits than a double has.
using RefNumber = data::WithError<long double, double>;
using Others = std::vector<std::optional<RefNumber>>;

/// A number of the reference; its error includes the rounding to a long double, which has 19 digits.
RefNumber ref_number(const ref::Estimate& number) {
  const long double value = mpfr_get_ld(ref::raw(number.value), MPFR_RNDN);
  return {value,
          mpfr_get_d(ref::raw(number.error), MPFR_RNDU) + 1e-19 * std::fabs(static_cast<double>(value))};
}

/// The numbers of a result in double, to be compared with.
Others others_of(const std::vector<Estimate>& numbers) {
  return mapped(numbers, [](const Estimate& one) -> std::optional<RefNumber> {
    return RefNumber{one.value, one.error};
  });
}

/// The numbers of one solved scene with the findings of all comparisons.
class Comparisons {
 public:
  /// The comparisons note the largest ratio in `scene`, and finish() adds their counts to `findings`. `given` are results
  /// that the scene itself gives, whose error is 0.
  Comparisons(SceneTally& findings, AuditedScene& scene, const Solution& solved, std::vector<ResultId> given)
      : findings_(findings), scene_(scene), solved_(solved), given_(std::move(given)) {
    for (const Solution::Result& result : solved.results) checked_.emplace_back(result.numbers.size());
  }

  /// Compares each number of these results with its counterpart in others_of(result), if there is one: the truth, or
  /// what follows from an identity.
  void against(const std::string& name, bool is_truth, const std::vector<ResultId>& results,
               const auto& others_of) {
    for (std::size_t k = 0; k < solved_.results.size(); ++k) {
      const Solution::Result& result = solved_.results[k];
      if (std::ranges::find(results, result.what->id) == results.end()) continue;
      const Others others = others_of(result);
      for (std::size_t i = 0; i < result.numbers.size(); ++i) {
        const std::optional<RefNumber> other = counterpart(result, i, others);
        if (other) compare(name, k, i, *other, is_truth);
      }
    }
  }

  /// Adds the counts of numbers to the findings.
  void finish() {
    for (std::size_t k = 0; k < checked_.size(); ++k) {
      const Solution::Result& result = solved_.results[k];
      findings_.numbers += result.numbers.size();
      for (std::size_t i = 0; i < checked_[k].size(); ++i) {
        const Checked& checked = checked_[k][i];
        if (!checked.at_all) ++findings_.unchecked;
        if (checked.uncovered) ++findings_.uncovered;
        if (checked.missed) ++findings_.miss_unreported;
        if (!result.allowed.empty() && !(result.numbers[i].error <= result.allowed[i]))
          ++findings_.miss_reported;
        if (checked.overestimate) findings_.overestimates.add(*checked.overestimate);
      }
    }
  }

 private:
  struct Checked {
    bool at_all = false, uncovered = false, missed = false;
    std::optional<double> overestimate;
  };

  /// The other number with the same index; in a list the nearest one, as two lists may differ in length.
  static std::optional<RefNumber> counterpart(const Solution::Result& result, std::size_t i,
                                              const Others& others) {
    if (result.what->shape != data::Shape::list) return i < others.size() ? others[i] : std::nullopt;
    const auto nearest = std::ranges::min_element(
        others, {}, [&](const auto& other) { return std::fabs(other->value - result.numbers[i].value); });
    return nearest == others.end() ? std::nullopt : *nearest;
  }

  void compare(const std::string& name, std::size_t k, std::size_t i, const RefNumber& other, bool is_truth) {
    const Solution::Result& result = solved_.results[k];
    const Estimate& mine = result.numbers[i];
    Checked& checked = checked_[k][i];
    const double difference = distance(*result.what, mine.value, other.value);
    const double both = mine.error + other.error;
    const bool covered = difference <= both;
    if (!covered) checked.uncovered = true;
    // An identity is as accurate as the scene itself, except for a rounding or two.
    if (!covered || other.error <= (is_truth ? 1 : 2) * mine.error) checked.at_all = true;
    if (!result.allowed.empty() && mine.error <= result.allowed[i] &&
        difference - other.error > result.allowed[i])
      checked.missed = true;
    // The first truth is the best one.
    const bool is_given = std::ranges::find(given_, result.what->id) != given_.end();
    if (is_truth && !is_given && !checked.overestimate && mine.error > 0 && other.error <= 0.1 * mine.error) {
      const double least = std::max(other.error, 0x1p-53 * std::fabs(mine.value));
      checked.overestimate = mine.error / std::max(difference, least);
    }
    note_largest(ratio_of(difference, both, mine.value, covered), name, result, i, other);
  }

  static double distance(const data::SceneResult& what, long double mine, long double other) {
    const long double difference = mine - other;
    return static_cast<double>(
        std::fabs(what.id == ResultId::orientation ? std::remainder(difference, 180.0L) : difference));
  }

  /// The difference over the sum of the estimates, or over a rounding error of the value if that sum is smaller.
  static double ratio_of(double difference, double both, double value, bool covered) {
    if (difference == 0) return 0;
    if (std::isnan(difference)) return std::numeric_limits<double>::infinity();
    const double ratio = difference / std::max(both, 0x1p-53 * std::fabs(value));
    return covered ? ratio : std::max(ratio, 1.0);
  }

  void note_largest(double ratio, const std::string& name, const Solution::Result& result, std::size_t i,
                    const RefNumber& other) {
    if (ratio <= scene_.largest_ratio) return;
    scene_.largest_ratio = ratio;
    const Estimate& mine = result.numbers[i];
    scene_.where = fmt::format("{}{} = {:.17g}, estimate {:.2g}; {}: {:.17g}, estimate {:.2g}",
                               result.what->name, place_of(result, i), mine.value, mine.error, name,
                               static_cast<double>(other.value), other.error);
  }

  [[nodiscard]] std::string place_of(const Solution::Result& result, std::size_t i) const {
    const auto [position, depth] = solved_.place(*result.what, i);
    return (position ? fmt::format(" at {}", *position) : "") +
           (depth ? fmt::format(", depth {}", *depth) : "");
  }

  SceneTally& findings_;
  AuditedScene& scene_;
  const Solution& solved_;
  std::vector<ResultId> given_;
  std::vector<std::vector<Checked>> checked_;
};

/// Whether the result needs an integral over all lines or a scan of them.
bool is_costly(const data::HalfSpaceProblem& problem, const ref::JointResponse& surface, ResultId id) {
  if (id == ResultId::compliance || id == ResultId::coupling) return false;
  if (id == ResultId::critical_speed) return !surface.all_lines_are_alike();
  if (problem.rule == data::ContourRule::exact || id == ResultId::normal_force ||
      id == ResultId::friction_force)
    return true;
  return id != ResultId::span_ratio && std::holds_alternative<data::GivenNormalForce>(problem.given);
}

/// Whether the reference may take minutes for the result: for twofold integrals, which are slow close to the critical
/// speed, and for integrals over lines that differ, close to this speed or with 21 constants.
bool is_too_costly(const data::HalfSpaceProblem& problem, const ref::JointResponse& surface, ResultId id,
                   double critical_speed) {
  if (std::holds_alternative<data::Stiffness>(problem.half_space)) return is_costly(problem, surface, id);
  if (problem.rule != data::ContourRule::exact &&
      (id == ResultId::centre_along || id == ResultId::centre_across))
    return true;
  const bool lines_crowd = !surface.all_lines_are_alike() && problem.speed > fastest_by_ref * critical_speed;
  return lines_crowd && id != ResultId::critical_speed && is_costly(problem, surface, id);
}

/// Compares a half-space with the reference. Results that take seconds are compared in a share of the scenes.
void compare_with_ref(Comparisons& comparisons, const data::HalfSpaceProblem& problem,
                      const std::vector<ResultId>& wanted, const Solution& solved, Random& random) {
  const ref::JointResponse surface(problem, ref_digits);
  const bool includes_costly = random.chance(surface.all_lines_are_alike() ? costly_share : costliest_share);
  const auto contact = solve_ref_half_space(surface, problem, ref_digits);
  const double critical_speed = solved[ResultId::critical_speed].value;
  comparisons.against("ref", true, wanted, [&](const Solution::Result& result) {
    const ResultId id = result.what->id;
    Others others(result.numbers.size());
    if (is_too_costly(problem, surface, id, critical_speed) ||
        (!includes_costly && is_costly(problem, surface, id)))
      return others;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const bool is_profile = result.what->shape == data::Shape::profile;
      // Nothing where no proof is found, or the digits are not reached.
      others[i] = unless_refused([&] {
        return ref_number(contact->get(id, is_profile ? Places{{solved.positions[i]}} : Places{}).front());
      });
    }
    return others;
  });
}

/// Compares a nip with the reference: every nip without friction and memory, for which this takes up to about a second,
/// and a share of the others.
void compare_with_ref(Comparisons& comparisons, DrawnScene drawn, const Solution& solved, Random& random,
                      const SceneSolvers& solvers) {
  const double ratio = solved[ResultId::contact_length].value / drawn.number("sheet.thickness");
  const bool is_quick = !drawn.has("rolling.speed") && drawn.text("friction.model") == "none";
  if (ratio > longest_by_ref || (!is_quick && !random.chance(costly_share))) return;
  std::vector<ResultId> known = drawn.wanted();
  std::erase_if(known, [&](ResultId id) {
    const data::SceneResult& result = data::scene_result(id);
    return is_moment(id) || result.needs == data::Needs::inside_all ||
           (result.is_inside() && ratio > longest_inside_by_ref);
  });
  drawn.set_wanted(known);
  const data::Scene scene = drawn.scene();
  if (!is_quick && likely_seconds_by_ref(scene, ref_digits_of_nips) > most_seconds_by_ref) return;
  try {
    const auto truth = solvers.ref(scene, ref_digits_of_nips);
    comparisons.against("ref", true, known, [&](const Solution::Result& result) {
      return mapped<std::optional<RefNumber>>(truth.profile(result.what->id), ref_number);
    });
  } catch (const data::BadInput&) {
    // Positions far outside the contact of a very thin sheet, and some memories, are outside the reference's domain.
  }
}

void compare_at_best(Comparisons& comparisons, DrawnScene drawn, const SceneSolvers& solvers) {
  drawn.set("accuracy", best_accuracy);
  const Solution best = solvers.fast(drawn.scene());
  comparisons.against("the same at 1e-13", true, drawn.wanted(), [&](const Solution::Result& result) {
    return others_of(best.profile(result.what->id));
  });
}

/// Compares the peak pressure with the pressure at its position.
void compare_peak(Comparisons& comparisons, DrawnScene drawn, const Solution& solved,
                  const SceneSolvers& solvers) {
  drawn.set("profile.positions", std::vector{solved[ResultId::peak_pressure_position].value});
  drawn.set_wanted({ResultId::pressure});
  const Solution there = solvers.fast(drawn.scene());
  comparisons.against("pressure there", false, {ResultId::peak_pressure},
                      [&](const Solution::Result&) { return others_of(there.profile(ResultId::pressure)); });
}

void compare_with_variants(Comparisons& comparisons, const DrawnScene& drawn, const Solution& solved,
                           Random& random, const SceneSolvers& solvers) {
  for (const Variant& variant : variants_of(drawn, solved, random)) {
    try {
      const Solution other = solvers.fast(variant.scene.scene());
      comparisons.against(variant.name, false, variant.scene.wanted(), [&](const Solution::Result& result) {
        return others_of(mapped(other.profile(result.what->id),
                                [&](const Estimate& one) { return variant.back(*result.what, one); }));
      });
    } catch (const data::BadInput&) {
      // For a scene at the limit of a domain the variant may be outside it.
    }
  }
}

/// The results that the scene prescribes. In a symmetric contact a given length prescribes its halves, too.
std::vector<ResultId> given_results(const DrawnScene& drawn) {
  if (drawn.has("load.per_length")) return {ResultId::load};
  if (drawn.has("load.normal_force")) return {ResultId::normal_force};
  if (drawn.has("contact.span_along")) return {ResultId::span_along};
  if (drawn.has("rolling.speed") || drawn.has("friction.coefficient")) return {ResultId::contact_length};
  return {ResultId::contact_length, ResultId::leading_length, ResultId::trailing_length};
}

void audit_drawn(SceneTally& findings, AuditedScene& audited, const DrawnScene& drawn, Random& random,
                 const SceneSolvers& solvers) {
  data::Scene scene;
  Solution solved;
  try {
    scene = drawn.scene();
    solved = solvers.fast(scene);
  } catch (const data::BadInput& error) {
    audited.refused = error.what();
    return;
  }
  audited.seconds = solved.seconds;
  Comparisons comparisons(findings, audited, solved, given_results(drawn));
  if (const auto* problem = std::get_if<data::HalfSpaceProblem>(&scene.system)) {
    compare_with_ref(comparisons, *problem, scene.wanted, solved, random);
  } else {
    compare_with_ref(comparisons, drawn, solved, random, solvers);
    compare_at_best(comparisons, drawn, solvers);
    // With Coulomb's friction the peak may be at a cusp, where the rounding of its position matters.
    if (!drawn.has("friction.coefficient")) compare_peak(comparisons, drawn, solved, solvers);
  }
  compare_with_variants(comparisons, drawn, solved, random, solvers);
  comparisons.finish();
}

}  // namespace

SceneTally audit_scene(const std::string& seed, std::uint64_t index, const SceneSolvers& solvers) {
  SceneTally findings{.scenes = 1};
  AuditedScene scene{.index = index};
  Random random(fmt::format("identities of scene {} of {}", index, seed));
  try {
    const DrawnScene drawn = draw_scene(seed, index);
    scene.toml = drawn.toml();
    audit_drawn(findings, scene, drawn, random, solvers);
  } catch (const std::exception& error) {
    scene.failed = error.what();
  }
  findings.keep(scene);
  return findings;
}

}  // namespace nipref::verify
