#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/nip_results.hpp>
#include <nipref/verify/solve/internal/paths.hpp>

namespace nipref::verify {
namespace {

fast::Work work_of(const fast::ConvergedNip& contact) { return contact.work(); }

/// Numbers of values of I1, of I3, and of the part of I6 that is not in I1.
fast::Work work_of(const ref::ConvergedNip& contact) {
  fast::Work work;
  work.kernel_evaluations[0] = static_cast<std::uint64_t>(contact.normal_values());
  work.kernel_evaluations[2] = static_cast<std::uint64_t>(contact.coupling_values());
  work.kernel_evaluations[5] = static_cast<std::uint64_t>(contact.stretch_values());
  work.unknowns = contact.unknowns();
  return work;
}

/// A contact and what its results inside the sheet have in common, which is computed once.
template <class Path, class Contact>
struct Nip {
  Contact contact;
  InnerFields<Path> fields = {};
  std::optional<typename Path::Greatest> greatest = {};

  const auto& greatest_shear() {
    if (!greatest) greatest = contact.greatest_shear();
    return *greatest;
  }
  void forget() {
    fields.forget();
    greatest.reset();
  }
};

/// Displacements of an elastic sheet's alone.
template <class Path, class Contact>
void set_inside(SolvedContact<typename Path::Number>& solved, const std::shared_ptr<Nip<Path, Contact>>& nip,
                bool is_elastic) {
  using Number = typename Path::Number;
  using Points = typename InnerFields<Path>::Points;
  Contact* const contact = &nip->contact;
  nip->fields.stresses_of = [contact](Points points) { return contact->inner_stresses(points); };
  if (is_elastic)
    nip->fields.displacements_of = [contact](Points points) { return contact->inner_displacements(points); };
  set_inner_fields<Path>([&](ResultId id, auto function) { solved.set(id, function); },
                         std::shared_ptr<InnerFields<Path>>(nip, &nip->fields));
  solved.set(ResultId::greatest_shear, [nip]() -> Number { return nip->greatest_shear().value; });
  solved.set(ResultId::greatest_shear_position, [nip]() -> Number { return nip->greatest_shear().y; });
  solved.set(ResultId::greatest_shear_depth, [nip]() -> Number { return nip->greatest_shear().depth; });
}

/// A converged nip of either path, elastic or rolling.
template <class Path, class Problem, class Contact>
std::unique_ptr<SolvedContact<typename Path::Number>> converged(const Problem& problem, Contact solution) {
  using Number = typename Path::Number;
  auto solved = std::make_unique<SolvedContact<Number>>();
  const auto nip = std::make_shared<Nip<Path, Contact>>(std::move(solution));
  const std::shared_ptr<Contact> contact(nip, &nip->contact);
  set_nip_results<Contact>([&](ResultId id, auto function) { solved->set(id, contact, function); });
  set_inside<Path>(*solved, nip, std::is_same_v<Problem, data::ElasticNipProblem>);
  complete_nip(*solved, problem);
  solved->work = [contact] { return work_of(*contact); };
  if constexpr (Path::is_fast) {
    set_moments(*solved);
    solved->solve_again = [nip] {
      nip->forget();
      return nip->contact.refine();
    };
  } else {
    set_slip(*solved, has_full_friction(problem));
    if (solved->is_symmetric) solved->measure = Measure::itself;
  }
  return solved;
}

}  // namespace

SolvedInDouble solve_converged(const data::ElasticNipProblem& problem, double accuracy) {
  return converged<FastPath>(
      problem, solve_given(
                   problem.given,
                   [&](double load) {
                     return fast::converged_for_load(problem.nip, problem.friction, load, accuracy);
                   },
                   [&](double length) {
                     return fast::converged_for_length(problem.nip, problem.friction, length, accuracy);
                   }));
}

SolvedInDouble solve_converged(const data::ViscoelasticNipProblem& problem, double accuracy) {
  return converged<FastPath>(
      problem,
      solve_given(
          problem.given, [&](double load) { return fast::converged_for_load(problem.nip, load, accuracy); },
          [&](double length) { return fast::converged_for_length(problem.nip, length, accuracy); }));
}

SolvedByRef solve_ref_converged(const data::ElasticNipProblem& problem, int digits) {
  return converged<RefPath>(
      problem,
      solve_given(
          problem.given,
          [&](double load) { return ref::converged_for_load(problem.nip, problem.friction, load, digits); },
          [&](double length) {
            return ref::converged_for_length(problem.nip, problem.friction, length, digits);
          }));
}

SolvedByRef solve_ref_converged(const data::ViscoelasticNipProblem& problem, int digits) {
  return converged<RefPath>(
      problem,
      solve_given(
          problem.given, [&](double load) { return ref::converged_for_load(problem.nip, load, digits); },
          [&](double length) { return ref::converged_for_length(problem.nip, length, digits); }));
}

}  // namespace nipref::verify
