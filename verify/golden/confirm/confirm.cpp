#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>
#include <nipref/verify/golden/confirm/nip.hpp>
#include <nipref/verify/golden/confirm/rational.hpp>

namespace nipref::verify {
namespace {

using confirm::RollingSheet;
using data::ResultId;
using Solver = std::function<SecondSolution()>;

constexpr int digits = 20;

/// A result, the dimensionless quantity that gives it, and the unit of this quantity in the scene.
struct Row {
  ResultId id;
  std::string_view quantity;  ///< its name in the catalogue
  mpq_class unit;
};

void add(SecondSolution& solution, ResultId id, const Confirmation& number, const mpq_class& unit) {
  solution.method = number.method;
  solution.numbers.emplace_back(id, in_unit(ref::Estimate(number.value, number.error, digits), unit));
}

/// Returns a solver that computes each row's quantity at these arguments by its second method.
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

/// theta1 and theta2 from the material's constants before they are rounded to double; nothing for springs and dashpots.
std::optional<confirm::BothFunctions> functions_of(const data::ViscoelasticMaterial& material) {
  using Both = confirm::BothFunctions;
  const data::MaterialConstants& constants = material.constants();
  if (const auto* one = std::get_if<data::SingleRelaxationTimeSolid>(&constants))
    return Both({one->bulk, one->shear, one->relaxation_time, one->theta2_rate_factor});
  if (const auto* all = std::get_if<data::DifferentialOperators>(&constants))
    return Both(
        confirm::Compliance(confirm::operator_moduli(all->p, all->q, all->p_dilatation, all->q_dilatation)));
  if (!std::holds_alternative<std::monostate>(constants)) return {};
  const auto exactly = [](const data::MaterialFunction& function) {
    confirm::Exponentials exact{function.instantaneous, {}};
    for (const auto& [amplitude, rate] : function.terms)
      exact.terms.push_back({{amplitude.real(), amplitude.imag()}, {rate.real(), rate.imag()}});
    return exact;
  };
  return Both(exactly(material.functions()->theta1), exactly(material.functions()->theta2));
}

Solver solver_of(const data::ViscoelasticNipProblem& problem) {
  using confirm::Float;
  const auto length = given_length(problem.given);
  const auto functions = functions_of(problem.nip.material);
  const mpq_class thickness = problem.nip.sheet_thickness, radius = problem.nip.roller_radius;
  if (!length || !functions || *length > confirm::longest_rolling_confirmed * thickness) return {};
  const auto& [theta1, theta2] = *functions;
  const confirm::Long compliance = theta1.instantaneous + theta2.instantaneous;
  const mpq_class slope = *length / radius, depth = slope * *length,
                  load_unit = slope * *length / confirm::exactly(compliance);
  const Float rate_unit = confirm::to_number(mpq_class(thickness / 2 / mpq_class(problem.nip.speed)));
  RollingSheet sheet{confirm::to_number(mpq_class(*length / thickness)),
                     Float(theta2.instantaneous / compliance)};
  for (const auto* const function : {&theta1, &theta2}) {
    for (const auto& [amplitude, rate] : function->terms) {
      if (rate.real() <= 0 || abs(rate.imag()) > rate.real() * confirm::Long("1e-500")) return {};
      sheet.remember(Float(rate.real()) * rate_unit, Float(amplitude.real() / rate.real() / compliance),
                     function == &theta2);
    }
  }
  if (sheet.memories.empty()) return {};
  return [=, length = *length] {
    const std::vector<Confirmation> numbers = confirm::rolling_numbers(sheet);
    SecondSolution solution;
    add(solution, ResultId::rolling_resistance, numbers[0], slope);
    add(solution, ResultId::eccentricity, numbers[0], length);
    add(solution, ResultId::leading_length, numbers[1], length);
    add(solution, ResultId::load, numbers[2], load_unit);
    add(solution, ResultId::indentation, numbers[3], depth);
    add(solution, ResultId::creep_ratio, numbers[4], slope);
    return solution;
  };
}

/// There is no second method: no other program gives more than three digits of this contact.
Solver solver_of(const data::PartialSlipProblem&) { return {}; }

Solver solver_of(const data::HalfSpaceProblem& problem) {
  const auto* const solid = std::get_if<data::IsotropicSolid>(&problem.half_space);
  const auto* const die = std::get_if<data::RigidDie>(&problem.body);
  const auto* const ball = std::get_if<data::RigidRollingSphere>(&problem.body);
  const auto* const span = std::get_if<data::GivenSpan>(&problem.given);
  const bool is_exact = problem.rule == data::ContourRule::exact;
  // The unit of speed of the quantities is the speed of shear waves, which must therefore be 1 in the scene.
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

Confirm confirmer_of(std::string_view quantity) {
  using namespace confirm;
  static const Methods all = [] {
    Methods joined;
    for (auto* const methods : {sheet_methods, memory_methods, isotropic_methods, anisotropic_methods,
                                nip_methods, material_methods})
      joined.merge(methods());
    return joined;
  }();
  const auto found = all.find(quantity);
  return found == all.end() ? Confirm() : found->second;
}

std::function<SecondSolution()> second_solver(const data::Scene& scene) {
  return std::visit([](const auto& problem) { return solver_of(problem); }, scene.system);
}

}  // namespace nipref::verify
