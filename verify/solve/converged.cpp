#include <cmath>
#include <cstdint>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/gripped.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/converged_contact.hpp>
#include <nipref/verify/solve/internal/methods.hpp>

namespace nipref::verify {
namespace {

fast::Work work_of(const fast::ConvergedElasticNip& contact) { return contact.work(); }
fast::Work work_of(const fast::ConvergedViscoelasticNip& contact) { return contact.work(); }

/// Numbers of values of I1, of I3, and of the part of I6 that is not in I1.
fast::Work counted(int unknowns, long normal, long coupling, long stretch = 0) {
  fast::Work work;
  work.kernel_evaluations[0] = static_cast<std::uint64_t>(normal);
  work.kernel_evaluations[2] = static_cast<std::uint64_t>(coupling);
  work.kernel_evaluations[5] = static_cast<std::uint64_t>(stretch);
  work.unknowns = unknowns;
  return work;
}
fast::Work work_of(const ref::ConvergedElasticNip& contact) {
  return counted(contact.terms(), contact.kernel_values(), contact.coupling_values());
}
fast::Work work_of(const ref::GrippedElasticNip& contact) {
  return counted(contact.terms() + 2, contact.normal_values(), contact.coupling_values(),
                 contact.stretch_values());
}
fast::Work work_of(const ref::ConvergedViscoelasticNip& contact) {
  return counted(contact.unknowns(), contact.normal_kernel_values(), contact.tangential_kernel_values());
}

template <class Path, class Problem, class Contact>
std::unique_ptr<SolvedContact<typename Path::Number>> converged(const Problem& problem, Contact contact,
                                                                double accuracy) {
  return std::make_unique<ConvergedContact<Path, Contact>>(
      std::move(contact), problem.nip.roller_radius, accuracy,
      [](const Contact& solved) { return work_of(solved); });
}

}  // namespace

SolvedInDouble solve_converged(const data::ElasticNipProblem& problem, double accuracy) {
  return converged<FastPath>(
      problem,
      solve_given(
          problem.given,
          [&](double load) {
            return fast::converged_for_load(problem.nip, problem.friction, load, accuracy);
          },
          [&](double length) {
            return fast::converged_for_length(problem.nip, problem.friction, length, accuracy);
          }),
      accuracy);
}

SolvedInDouble solve_converged(const data::ViscoelasticNipProblem& problem, double accuracy) {
  return converged<FastPath>(
      problem,
      solve_given(
          problem.given, [&](double load) { return fast::converged_for_load(problem.nip, load, accuracy); },
          [&](double length) { return fast::converged_for_length(problem.nip, length, accuracy); }),
      accuracy);
}

SolvedByRef solve_ref_converged(const data::ElasticNipProblem& problem, int digits) {
  const data::ElasticNip& nip = problem.nip;
  const double accuracy = std::pow(10.0, -digits);
  if (problem.friction == data::Friction::none)
    return converged<RefPath>(
        problem,
        solve_given(
            problem.given, [&](double load) { return ref::converged_for_load(nip, load, digits); },
            [&](double length) { return ref::converged_for_length(nip, length, digits); }),
        accuracy);
  return converged<RefPath>(
      problem,
      solve_given(
          problem.given, [&](double load) { return ref::gripped_for_load(nip, load, digits); },
          [&](double length) { return ref::gripped_for_length(nip, length, digits); }),
      accuracy);
}

SolvedByRef solve_ref_converged(const data::ViscoelasticNipProblem& problem, int digits) {
  return converged<RefPath>(
      problem,
      solve_given(
          problem.given, [&](double load) { return ref::converged_for_load(problem.nip, load, digits); },
          [&](double length) { return ref::converged_for_length(problem.nip, length, digits); }),
      std::pow(10.0, -digits));
}

}  // namespace nipref::verify
