#include <variant>

#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/converged_contact.hpp>
#include <nipref/verify/solve/internal/fast_methods.hpp>

namespace nipref::verify {
namespace {

struct SolveViscoelasticConverged {
  const data::ViscoelasticNip& nip;
  double accuracy;

  fast::ConvergedViscoelasticNip operator()(const data::GivenLoad& load) const {
    return fast::converged_for_load(nip, load.per_length, accuracy);
  }
  fast::ConvergedViscoelasticNip operator()(const data::GivenLength& length) const {
    return fast::converged_for_length(nip, length.contact_length, accuracy);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<fast::Estimate>> solve_viscoelastic(const data::ViscoelasticNipProblem& problem,
                                                                  double accuracy) {
  return converged_contact<FastPath>(
      std::visit(SolveViscoelasticConverged{problem.nip, accuracy}, problem.given), problem.nip.roller_radius,
      accuracy, [](const fast::ConvergedViscoelasticNip& contact) { return contact.work(); });
}

}  // namespace nipref::verify
