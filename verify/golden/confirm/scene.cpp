#include <optional>
#include <string_view>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>
#include <nipref/verify/golden/confirm/contacts.hpp>
#include <nipref/verify/golden/confirm/scene.hpp>

namespace nipref::verify {
namespace {

using confirm::RollingSheet;
using data::ResultId;
using Solver = std::function<SecondSolution()>;

constexpr int digits = 20;

/// A result, the number that gives it, and that number's unit in the scene.
struct Row {
  ResultId id;
  std::string_view quantity;  ///< of the catalogue
  mpq_class unit;
};

void add(SecondSolution& solution, ResultId id, const Confirmation& number, const mpq_class& unit) {
  solution.method = number.method;
  solution.numbers.emplace_back(id, in_unit(ref::Estimate(number.value, number.error, digits), unit));
}

/// Solves by the second methods of quantities that have these arguments.
Solver by_quantities(std::vector<std::pair<std::string_view, double>> arguments, std::vector<Row> rows) {
  return [arguments = std::move(arguments), rows = std::move(rows)] {
    SecondSolution solution;
    for (const Row& row : rows) {
      const Quantity& quantity = find_quantity(row.quantity);
      const Point point = point_of(quantity, arguments);
      add(solution, row.id, confirmer_of(row.quantity)(NamedPoint(quantity.arguments, point)), row.unit);
    }
    return solution;
  };
}

std::optional<mpq_class> given_length(const data::Given& given) {
  const auto* const length = std::get_if<data::GivenLength>(&given);
  return length == nullptr ? std::nullopt : std::optional<mpq_class>(length->contact_length);
}

Solver solver_of(const data::ElasticNipProblem& problem) {
  const auto length = given_length(problem.given);
  const bool is_gripped = problem.friction == data::Friction::full;
  const mpq_class radius = problem.nip.roller_radius, poisson = problem.nip.material.poisson;
  if (!length) return {};
  const double over_thickness = mpq_class(*length / mpq_class(problem.nip.sheet_thickness)).get_d();
  if (over_thickness > (is_gripped ? confirm::longest_gripped_confirmed : confirm::longest_confirmed))
    return {};
  const mpq_class slope = *length / radius, depth = slope * *length,
                  stress = slope * mpq_class(problem.nip.material.young) / (2 * (1 - poisson * poisson));
  std::vector<Row> rows{{ResultId::load, "nip.load", stress * *length},
                        {ResultId::indentation, "nip.indentation", depth},
                        {ResultId::creep_ratio, "nip.creep", slope},
                        {ResultId::peak_pressure, "nip.peak_pressure", stress}};
  if (is_gripped) rows.push_back({ResultId::peak_shear, "nip.peak_shear", stress});
  return by_quantities({{"L_over_B", over_thickness},
                        {"poisson", problem.nip.material.poisson},
                        {"friction", is_gripped ? 1 : 0}},
                       std::move(rows));
}

/// at_once delta(t) + sum amplitude e^(-rate t), exactly.
struct ExactFunction {
  mpq_class at_once;
  std::vector<std::pair<mpq_class, mpq_class>> terms;  ///< rates and amplitudes
};

ExactFunction relaxing(const mpq_class& at_once, const mpq_class& amplitude_rate, const mpq_class& rate) {
  return {at_once, {{rate, at_once * amplitude_rate}}};
}

/// (a + b p)/(c + d p) as a function of time.
ExactFunction ratio(const mpq_class& a, const mpq_class& b, const mpq_class& c, const mpq_class& d) {
  const mpq_class at_once = b / d, rate = c / d;
  return {at_once, {{rate, a / d - at_once * rate}}};
}

/// What is rounded from springs, and operators, are taken apart here where that needs no root.
std::optional<std::pair<ExactFunction, ExactFunction>> exact_functions(
    const data::ViscoelasticMaterial& material) {
  if (const auto* one = std::get_if<data::SingleRelaxationTimeSolid>(&material.constants())) {
    const mpq_class shear = one->shear, bulk = one->bulk, rate = 1 / mpq_class(one->relaxation_time);
    return std::pair(relaxing(1 / (2 * shear), rate, rate),
                     relaxing(3 / (6 * bulk + 2 * shear), rate, rate * one->theta2_rate_factor));
  }
  if (const auto* all = std::get_if<data::DifferentialOperators>(&material.constants())) {
    if (all->p.size() != 2 || all->q.size() != 2 || all->p_dilatation.size() != 1 ||
        all->q_dilatation.size() != 1)
      return {};
    const mpq_class bulk = mpq_class(all->q_dilatation[0]) / mpq_class(all->p_dilatation[0]), p0 = all->p[0],
                    p1 = all->p[1], q0 = all->q[0], q1 = all->q[1];
    return std::pair(ratio(p0, p1, 2 * q0, 2 * q1),
                     ratio(3 * p0, 3 * p1, 6 * bulk * p0 + 2 * q0, 6 * bulk * p1 + 2 * q1));
  }
  if (!std::holds_alternative<std::monostate>(material.constants())) return {};
  const auto exactly = [](const data::MaterialFunction& function) {
    ExactFunction exact{function.instantaneous, {}};
    for (const data::RelaxationTerm& term : function.terms)
      exact.terms.emplace_back(term.rate.real(), term.amplitude.real());
    return exact;
  };
  for (const auto* const function : {&material.functions()->theta1, &material.functions()->theta2}) {
    for (const data::RelaxationTerm& term : function->terms) {
      if (term.rate.imag() != 0) return {};
    }
  }
  return std::pair(exactly(material.functions()->theta1), exactly(material.functions()->theta2));
}

Solver solver_of(const data::ViscoelasticNipProblem& problem) {
  const auto length = given_length(problem.given);
  const auto functions = exact_functions(problem.nip.material);
  const mpq_class thickness = problem.nip.sheet_thickness, radius = problem.nip.roller_radius;
  if (!length || !functions || *length > confirm::longest_rolling_confirmed * thickness) return {};
  const auto& [theta1, theta2] = *functions;
  const mpq_class compliance = theta1.at_once + theta2.at_once, slope = *length / radius,
                  depth = slope * *length, rate_unit = thickness / 2 / mpq_class(problem.nip.speed);
  RollingSheet sheet{*length / thickness, theta2.at_once / compliance, {}};
  for (const auto* const function : {&theta1, &theta2}) {
    for (const auto& [rate, amplitude] : function->terms) {
      if (rate <= 0) return {};
      const mpq_class part = amplitude / rate / compliance;
      sheet.remember({rate * rate_unit, part, function == &theta2 ? part : mpq_class(0)});
    }
  }
  if (sheet.memories.empty()) return {};
  return [=, length = *length] {
    const std::vector<Confirmation> numbers = confirm::rolling_numbers(sheet);
    SecondSolution solution;
    add(solution, ResultId::rolling_resistance, numbers[0], slope);
    add(solution, ResultId::eccentricity, numbers[0], length);
    add(solution, ResultId::leading_length, numbers[1], length);
    add(solution, ResultId::load, numbers[2], slope * length / compliance);
    add(solution, ResultId::indentation, numbers[3], depth);
    add(solution, ResultId::creep_ratio, numbers[4], slope);
    return solution;
  };
}

Solver solver_of(const data::HalfSpaceProblem& problem) {
  const auto* const solid = std::get_if<data::IsotropicSolid>(&problem.half_space);
  const auto* const die = std::get_if<data::RigidDie>(&problem.body);
  const auto* const ball = std::get_if<data::RigidRollingSphere>(&problem.body);
  const auto* const span = std::get_if<data::GivenSpan>(&problem.given);
  const bool is_exact = problem.rule == data::ContourRule::exact;
  // The quantities have the speed in that of shear waves.
  if (solid == nullptr || solid->shear != solid->density || (die == nullptr && ball == nullptr)) return {};
  std::vector<std::pair<std::string_view, double>> arguments{{"poisson", solid->poisson},
                                                             {"speed", problem.speed}};
  if (is_exact && die != nullptr) {
    arguments.emplace_back("curvature_ratio", die->radius_along / die->radius_across);
    return by_quantities(std::move(arguments), {{ResultId::axis_ratio, "ellipse.axis_ratio", 1}});
  }
  if (is_exact || span == nullptr || (die != nullptr && die->radius_along != die->radius_across)) return {};
  const mpq_class along = span->along, force = mpq_class(solid->shear) * along * along * along /
                                               mpq_class(die != nullptr ? die->radius_along : ball->radius);
  const char* const ratio_name = die != nullptr ? "die.span_ratio" : "rolling.span_ratio";
  std::vector<Row> rows{{ResultId::span_ratio, ratio_name, 1},
                        {ResultId::span_across, ratio_name, along},
                        {ResultId::normal_force, die != nullptr ? "die.force" : "rolling.force", force}};
  if (die != nullptr) {
    rows.push_back({ResultId::friction_force, "die.force", force * mpq_class(problem.friction)});
    arguments.emplace_back("friction", problem.friction);
  }
  return by_quantities(std::move(arguments), std::move(rows));
}

}  // namespace

std::function<SecondSolution()> second_solver(const data::Scene& scene) {
  return std::visit([](const auto& problem) { return solver_of(problem); }, scene.system);
}

}  // namespace nipref::verify
