#include <cmath>
#include <variant>

#include <nipref/verify/solve/energy_balance.hpp>
#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/loss_integral.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

fast::Estimate in_double(const fast::Estimate& number) { return number; }
/// The error includes rounding to double.
fast::Estimate in_double(const ref::Estimate& number) {
  const double value = number.to_double();
  return {value, static_cast<double>(error_of(number)) + 0x1p-53 * std::fabs(value)};
}

template <class Number>
EnergyBalance balance_of(const data::Scene& scene, const data::ViscoelasticNip& nip,
                         const SolvedContact<Number>& contact) {
  EnergyBalance balance;
  balance.warnings = beyond_theory(scene, contact);
  balance.work =
      in_double(contact.number(ResultId::load)) * in_double(contact.number(ResultId::rolling_resistance));
  balance.loss = loss_integral(nip, contact.ends(),
                               [&](double y) { return in_double(contact.at(ResultId::pressure, y)); });
  return balance;
}

const data::ViscoelasticNipProblem& rolling_problem(const data::Scene& scene) {
  const auto* problem = std::get_if<data::ViscoelasticNipProblem>(&scene.system);
  if (problem == nullptr)
    scene.origin.refuse("rolling", "(missing)",
                        "must be there: only a sheet that rolls loses energy to its memory");
  if (!std::holds_alternative<data::ConvergedMethod>(problem->method))
    scene.origin.refuse("method.kind", "line-loads", "must be converged for a balance of energy");
  return *problem;
}

}  // namespace

double EnergyBalance::difference() const { return work.value - loss.value; }
bool EnergyBalance::meets() const { return std::fabs(difference()) <= allowed(); }

EnergyBalance energy_balance(const data::Scene& scene, std::optional<int> digits) {
  scene.check();
  const data::ViscoelasticNipProblem& problem = rolling_problem(scene);
  EnergyBalance balance;
  const auto solved = [&](const auto& solve) {
    try {
      return solve();
    } catch (const data::BadInput& error) {
      refuse_given(scene, problem.given, error);
    }
  };
  const double seconds = seconds_of([&] {
    balance = digits ? balance_of(scene, problem.nip,
                                  *solved([&] { return solve_ref_converged(problem, *digits); }))
                     : balance_of(scene, problem.nip,
                                  *solved([&] { return solve_converged(problem, scene.accuracy); }));
  });
  balance.title = scene.title;
  balance.seconds = seconds;
  return balance;
}

}  // namespace nipref::verify
