#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>
#include <nipref/verify/solve/internal/line_load_contact.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using fast::ViscoelasticLineLoadMethod;
using fast::ViscoelasticLineLoads;
using fast::Work;

const std::map<ResultId, double ViscoelasticLineLoads::*> viscoelastic_line_load_numbers{
    {ResultId::leading_length, &ViscoelasticLineLoads::leading_length},
    {ResultId::trailing_length, &ViscoelasticLineLoads::trailing_length},
    {ResultId::load, &ViscoelasticLineLoads::load},
    {ResultId::indentation, &ViscoelasticLineLoads::indentation},
    {ResultId::edge_displacement, &ViscoelasticLineLoads::leading_displacement},
    {ResultId::trailing_displacement, &ViscoelasticLineLoads::trailing_displacement},
    {ResultId::rolling_resistance, &ViscoelasticLineLoads::rolling_resistance},
    {ResultId::peak_pressure, &ViscoelasticLineLoads::peak_pressure},
};

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

class LineLoadViscoelastic : public LineLoadContact {
 public:
  LineLoadViscoelastic(const data::ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& loads)
      : LineLoadContact(solve_converged(problem, truth_accuracy)),
        nip_(problem.nip),
        solution_(solve_loads(problem, method_of(loads), !loads.trailing_elements)),
        method_(method_of(loads, solution_)),
        surface_(nip_, solution_, method_) {}

  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {-solution_.trailing_length, solution_.leading_length};
  }
  [[nodiscard]] Work work() const override {
    Work work;
    work.systems = static_cast<std::uint64_t>(solution_.systems);
    work.unknowns = static_cast<int>(solution_.loads.size()) + 1;
    return work;
  }

 private:
  static ViscoelasticLineLoadMethod method_of(const data::ViscoelasticLineLoads& loads) {
    return {loads.leading_elements, loads.trailing_elements.value_or(0), loads.approach_lengths,
            loads.residue_terms};
  }
  /// A search chooses the number of trailing elements.
  static ViscoelasticLineLoadMethod method_of(const data::ViscoelasticLineLoads& loads,
                                              const ViscoelasticLineLoads& solution) {
    ViscoelasticLineLoadMethod method = method_of(loads);
    method.trailing_elements = static_cast<int>(solution.loads.size()) - method.leading_elements;
    return method;
  }
  [[nodiscard]] double moment(ResultId id) const override {
    double sum = 0;
    for (std::size_t j = 0; j < solution_.loads.size(); ++j) {
      const double y = solution_.leading_length - (static_cast<double>(j) + 0.5) * solution_.element_width();
      if ((y > 0) == (id == ResultId::leading_moment)) sum += solution_.loads[j] * y;
    }
    return sum;
  }
  [[nodiscard]] double place_of_largest_load() const {
    const auto largest = std::ranges::max_element(solution_.loads) - solution_.loads.begin();
    return solution_.leading_length - (static_cast<double>(largest) + 0.5) * solution_.element_width();
  }
  [[nodiscard]] double value(ResultId id) const override {
    if (id == ResultId::peak_shear) return 0;  // without friction
    if (id == ResultId::peak_pressure_position) return place_of_largest_load();
    if (id == ResultId::contact_length) return solution_.contact_length();
    if (id == ResultId::creep_ratio) return fast::creep_ratio(nip_, solution_, method_);
    return solution_.*viscoelastic_line_load_numbers.at(id);
  }
  [[nodiscard]] double profile(ResultId id, double y) const override {
    if (id == ResultId::shear) return 0;
    if (id == ResultId::pressure) return fast::element_pressure(solution_, y);
    if (id == ResultId::normal_displacement) return surface_.normal_displacement(y);
    return surface_.tangential_displacement(y);
  }

  data::ViscoelasticNip nip_;
  ViscoelasticLineLoads solution_;
  ViscoelasticLineLoadMethod method_;
  fast::ViscoelasticLineLoadSurface surface_;
};

}  // namespace

SolvedInDouble solve_line_loads(const data::ViscoelasticNipProblem& problem,
                                const data::ViscoelasticLineLoads& loads) {
  return std::make_unique<LineLoadViscoelastic>(problem, loads);
}

}  // namespace nipref::verify
