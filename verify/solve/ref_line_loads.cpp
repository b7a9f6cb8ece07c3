#include <memory>
#include <utility>

#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/nip_results.hpp>
#include <nipref/verify/solve/internal/paths.hpp>

namespace nipref::verify {
namespace {

SolvedByRef contact_of(const auto& problem, int digits, const auto& for_load, const auto& for_length) {
  auto contact = std::make_unique<SolvedContact<ref::Estimate>>();
  const auto loads =
      std::make_shared<const ref::LineLoadNip>(solve_given(problem.given, for_load, for_length));
  set_nip_results<ref::LineLoadNip>([&](ResultId id, auto function) { contact->set(id, loads, function); });
  contact->set(ResultId::creep_range, [=](const Places&) -> std::vector<ref::Estimate> {
    const auto [lower, upper, chosen] = loads->creep_range();
    return {lower, upper, chosen};
  });
  set_inner_fields<RefPath>([&](ResultId id, auto function) { contact->set(id, function); },
                            line_load_fields<RefPath>(loads, problem, digits));
  complete_nip(*contact, problem);
  contact->measure = Measure::itself;
  contact->work = [loads] {
    fast::Work work;
    work.systems = static_cast<std::uint64_t>(loads->systems());
    work.unknowns = loads->unknowns();
    return work;
  };
  return contact;
}

}  // namespace

SolvedByRef solve_ref_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& loads,
                                 int digits) {
  const data::ElasticNip& nip = problem.nip;
  const ref::LineLoadMethod method(loads.leading_elements, loads.residue_terms);
  const data::Grip grip = grip_of(problem);
  return contact_of(
      problem, digits, [&](double load) { return ref::line_loads_for_load(nip, method, load, digits, grip); },
      [&](double length) { return ref::line_loads_for_length(nip, method, length, digits, grip); });
}

SolvedByRef solve_ref_line_loads(const data::ViscoelasticNipProblem& problem,
                                 const data::ViscoelasticLineLoads& method, int digits) {
  const data::ViscoelasticNip& nip = problem.nip;
  return contact_of(
      problem, digits, [&](double load) { return ref::line_loads_for_load(nip, method, load, digits); },
      [&](double length) { return ref::line_loads_for_length(nip, method, length, digits); });
}

}  // namespace nipref::verify
