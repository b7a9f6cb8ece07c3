#include <cmath>
#include <cstdint>
#include <variant>

#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/gripped.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/converged_contact.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>

namespace nipref::verify {
namespace {

struct SolveRefFrictionless {
  const data::ElasticNip& nip;
  int digits;

  ref::ConvergedElasticNip operator()(const data::GivenLoad& load) const {
    return ref::converged_for_load(nip, load.per_length, digits);
  }
  ref::ConvergedElasticNip operator()(const data::GivenLength& length) const {
    return ref::converged_for_length(nip, length.contact_length, digits);
  }
};

struct SolveRefGripped {
  const data::ElasticNip& nip;
  int digits;

  ref::GrippedElasticNip operator()(const data::GivenLoad& load) const {
    return ref::gripped_for_load(nip, load.per_length, digits);
  }
  ref::GrippedElasticNip operator()(const data::GivenLength& length) const {
    return ref::gripped_for_length(nip, length.contact_length, digits);
  }
};

struct SolveRefRolling {
  const data::ViscoelasticNip& nip;
  int digits;

  ref::ConvergedViscoelasticNip operator()(const data::GivenLoad& load) const {
    return ref::converged_for_load(nip, load.per_length, digits);
  }
  ref::ConvergedViscoelasticNip operator()(const data::GivenLength& length) const {
    return ref::converged_for_length(nip, length.contact_length, digits);
  }
};

/// Values of I1, of I3, and of what I6 has beside I1.
fast::Work work_of(int unknowns, long normal, long coupling, long stretch = 0) {
  fast::Work work;
  work.kernel_evaluations[0] = static_cast<std::uint64_t>(normal);
  work.kernel_evaluations[2] = static_cast<std::uint64_t>(coupling);
  work.kernel_evaluations[5] = static_cast<std::uint64_t>(stretch);
  work.unknowns = unknowns;
  return work;
}

double accuracy_of(int digits) { return std::pow(10.0, -digits); }

}  // namespace

std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_converged(const data::ElasticNipProblem& problem,
                                                                  int digits) {
  if (problem.friction == data::Friction::none) {
    return converged_contact<RefPath>(
        std::visit(SolveRefFrictionless{problem.nip, digits}, problem.given), problem.nip.roller_radius,
        accuracy_of(digits), [](const ref::ConvergedElasticNip& contact) {
          return work_of(contact.terms(), contact.kernel_values(), contact.coupling_values());
        });
  }
  return converged_contact<RefPath>(std::visit(SolveRefGripped{problem.nip, digits}, problem.given),
                                    problem.nip.roller_radius, accuracy_of(digits),
                                    [](const ref::GrippedElasticNip& contact) {
                                      return work_of(contact.terms() + 2, contact.normal_values(),
                                                     contact.coupling_values(), contact.stretch_values());
                                    });
}

std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_rolling(const data::ViscoelasticNipProblem& problem,
                                                                int digits) {
  return converged_contact<RefPath>(std::visit(SolveRefRolling{problem.nip, digits}, problem.given),
                                    problem.nip.roller_radius, accuracy_of(digits),
                                    [](const ref::ConvergedViscoelasticNip& contact) {
                                      return work_of(contact.unknowns(), contact.normal_kernel_values(),
                                                     contact.tangential_kernel_values());
                                    });
}

}  // namespace nipref::verify
