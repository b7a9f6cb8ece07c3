#include <algorithm>
#include <memory>

#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>
#include <nipref/verify/solve/internal/compared_with_truth.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using fast::ViscoelasticLineLoadMethod;
using fast::ViscoelasticLineLoads;
using fast::Work;

/// Searches for the number of trailing elements for a load unless the method has it.
ViscoelasticLineLoads solve_loads(const data::ViscoelasticNipProblem& problem,
                                  const ViscoelasticLineLoadMethod& method, bool search) {
  const double leading_part =
      static_cast<double>(method.leading_elements) / (method.leading_elements + method.trailing_elements);
  return solve_given(
      problem.given,
      [&](double load) {
        return search ? fast::viscoelastic_line_loads_by_search(problem.nip, method, load)
                      : fast::viscoelastic_line_loads_for_load(problem.nip, method, load);
      },
      [&](double length) {
        return fast::viscoelastic_line_loads_for_length(problem.nip, method, length * leading_part);
      });
}

/// Solved line loads: what they were solved for, and their results. A search chooses the number of trailing elements.
struct RollingLineLoads {
  data::ViscoelasticNip nip;
  ViscoelasticLineLoads solution;
  ViscoelasticLineLoadMethod method;
  fast::ViscoelasticLineLoadSurface surface;

  RollingLineLoads(const data::ViscoelasticNipProblem& problem, const ViscoelasticLineLoadMethod& wanted,
                   bool search)
      : nip(problem.nip),
        solution(solve_loads(problem, wanted, search)),
        method{wanted.leading_elements, static_cast<int>(solution.loads.size()) - wanted.leading_elements,
               wanted.approach, wanted.residue_terms},
        surface(nip, solution, method) {}

  [[nodiscard]] double contact_length() const { return solution.contact_length(); }
  [[nodiscard]] double leading_length() const { return solution.leading_length; }
  [[nodiscard]] double trailing_length() const { return solution.trailing_length; }
  [[nodiscard]] double load() const { return solution.load; }
  [[nodiscard]] double indentation() const { return solution.indentation; }
  [[nodiscard]] double leading_displacement() const { return solution.leading_displacement; }
  [[nodiscard]] double trailing_displacement() const { return solution.trailing_displacement; }
  [[nodiscard]] double rolling_resistance() const { return solution.rolling_resistance; }
  [[nodiscard]] double peak_pressure() const { return solution.peak_pressure; }
  [[nodiscard]] double peak_pressure_position() const {
    return place_of(
        static_cast<std::size_t>(std::ranges::max_element(solution.loads) - solution.loads.begin()));
  }
  [[nodiscard]] double creep_ratio() const { return fast::creep_ratio(nip, solution, method); }
  [[nodiscard]] double leading_moment() const { return moment(true); }
  [[nodiscard]] double trailing_moment() const { return moment(false); }
  [[nodiscard]] double pressure(double y) const { return fast::element_pressure(solution, y); }
  [[nodiscard]] double normal_displacement(double y) const { return surface.normal_displacement(y); }
  [[nodiscard]] double tangential_displacement(double y) const { return surface.tangential_displacement(y); }

 private:
  [[nodiscard]] double place_of(std::size_t load) const {
    return solution.leading_length - (static_cast<double>(load) + 0.5) * solution.element_width();
  }
  /// Of the loads of one side (thesis 7.13).
  [[nodiscard]] double moment(bool is_leading) const {
    double sum = 0;
    for (std::size_t j = 0; j < solution.loads.size(); ++j) {
      const double y = place_of(j);
      if ((y > 0) == is_leading) sum += solution.loads[j] * y;
    }
    return sum;
  }
};

}  // namespace

SolvedInDouble solve_line_loads(const data::ViscoelasticNipProblem& problem,
                                const data::ViscoelasticLineLoads& wanted, double /*accuracy*/) {
  const std::shared_ptr<const SolvedContact<Estimate>> truth = solve_converged(problem, truth_accuracy);
  const ViscoelasticLineLoadMethod method{wanted.leading_elements, wanted.trailing_elements.value_or(0),
                                          wanted.approach_lengths, wanted.residue_terms};
  const auto loads = std::make_shared<RollingLineLoads>(problem, method, !wanted.trailing_elements);
  SolvedInDouble contact = compared_with_truth(loads, truth, problem);
  contact->work = [loads] {
    Work work;
    work.systems = static_cast<std::uint64_t>(loads->solution.systems);
    work.unknowns = static_cast<int>(loads->solution.loads.size()) + 1;
    return work;
  };
  return contact;
}

}  // namespace nipref::verify
