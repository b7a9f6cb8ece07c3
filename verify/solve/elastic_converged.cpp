#include <variant>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/converged_contact.hpp>
#include <nipref/verify/solve/internal/fast_methods.hpp>

namespace nipref::verify {
namespace {

struct SolveElasticConverged {
  const data::ElasticNipProblem& problem;
  double accuracy;

  fast::ConvergedElasticNip operator()(const data::GivenLoad& load) const {
    return fast::converged_for_load(problem.nip, problem.friction, load.per_length, accuracy);
  }
  fast::ConvergedElasticNip operator()(const data::GivenLength& length) const {
    return fast::converged_for_length(problem.nip, problem.friction, length.contact_length, accuracy);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<fast::Estimate>> solve_converged(const data::ElasticNipProblem& problem,
                                                               double accuracy) {
  return converged_contact<FastPath>(std::visit(SolveElasticConverged{problem, accuracy}, problem.given),
                                     problem.nip.roller_radius, accuracy,
                                     [](const fast::ConvergedElasticNip& contact) { return contact.work(); });
}

}  // namespace nipref::verify
