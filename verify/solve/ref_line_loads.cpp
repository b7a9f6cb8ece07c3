#include <memory>
#include <utility>

#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/elastic_nip/line_loads_displacements.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/nip_results.hpp>
#include <nipref/verify/solve/internal/paths.hpp>

namespace nipref::verify {
namespace {

using ref::Enclosure;
using RefRollingLineLoads = ref::ViscoelasticLineLoads;

/// Solved line loads of an elastic nip: what they were solved for, and their results.
struct RefElasticLineLoads : ref::LineLoadSolution {
  data::ElasticNip nip;
  ref::LineLoadMethod method;
  int digits;

  [[nodiscard]] Enclosure peak_pressure_position() const {
    return ref::place_of_largest_pressure(*this, digits);
  }
  [[nodiscard]] Enclosure peak_shear_position() const { return ref::place_of_largest_shear(*this, digits); }
  [[nodiscard]] Enclosure creep_ratio() const { return ref::creep_ratio(nip, *this, method, digits); }
  [[nodiscard]] std::vector<Enclosure> creep_range() const {
    const auto [lower, upper, chosen] = ref::creep_range(nip, *this, method, digits);
    return {lower, upper, chosen};
  }
  [[nodiscard]] std::vector<Enclosure> shear_zeros() const { return ref::shear_borders(*this, digits); }
  [[nodiscard]] std::vector<ref::FaceLoad> face_loads() const { return ref::face_loads(*this, digits); }
  [[nodiscard]] Enclosure pressure(double y) const { return ref::element_pressure(*this, y, digits); }
  [[nodiscard]] Enclosure shear(double y) const { return ref::element_shear(*this, y, digits); }
  [[nodiscard]] Enclosure normal_displacement(double y) const {
    return ref::normal_displacement(nip, *this, method, y, digits);
  }
  [[nodiscard]] Enclosure tangential_displacement(double y) const {
    return ref::tangential_displacement(nip, *this, method, y, digits);
  }
};

fast::Work work_of(const RefElasticLineLoads& loads) {
  fast::Work work;
  work.unknowns = static_cast<int>(1 + loads.line_loads.size() + loads.shear_loads.size());
  return work;
}
fast::Work work_of(const RefRollingLineLoads& loads) {
  fast::Work work;
  work.systems = static_cast<std::uint64_t>(loads.systems());
  work.unknowns = loads.elements() + 1;
  return work;
}

template <class LineLoads>
SolvedByRef contact_of(LineLoads solution, const auto& problem, int digits) {
  auto contact = std::make_unique<SolvedContact<ref::Estimate>>();
  const auto loads = std::make_shared<LineLoads>(std::move(solution));
  set_nip_results<LineLoads>([&](ResultId id, auto function) { contact->set(id, loads, function); },
                             [digits](const LineLoads&) { return ref::exact_zero(digits); });
  set_inner_fields<RefPath>([&](ResultId id, auto function) { contact->set(id, function); },
                            line_load_fields<RefPath>(loads, problem, digits));
  complete_nip(*contact, problem);
  contact->measure = Measure::itself;
  contact->work = [loads] { return work_of(*loads); };
  return contact;
}

ref::Grip grip_of(const data::ElasticNipProblem& problem) {
  if (problem.friction == data::Friction::none) return {};
  if (problem.creep_ratio) return {ref::Grip::Creep::given, *problem.creep_ratio};
  return {ref::Grip::Creep::thesis};
}

}  // namespace

SolvedByRef solve_ref_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& loads,
                                 int digits) {
  const ref::LineLoadMethod method(loads.leading_elements, loads.residue_terms);
  const ref::Grip grip = grip_of(problem);
  const auto solution = solve_given(
      problem.given,
      [&](double load) { return ref::line_loads_for_load(problem.nip, method, load, digits, grip); },
      [&](double length) { return ref::line_loads_for_length(problem.nip, method, length, digits, grip); });
  return contact_of(RefElasticLineLoads{{solution}, problem.nip, method, digits}, problem, digits);
}

SolvedByRef solve_ref_line_loads(const data::ViscoelasticNipProblem& problem,
                                 const data::ViscoelasticLineLoads& loads, int digits) {
  const ref::ViscoelasticLineLoadMethod method{loads.leading_elements, loads.trailing_elements,
                                               loads.approach_lengths, loads.residue_terms};
  const auto solution = solve_given(
      problem.given,
      [&](double load) { return RefRollingLineLoads::for_load(problem.nip, method, load, digits); },
      [&](double length) { return RefRollingLineLoads::for_length(problem.nip, method, length, digits); });
  return contact_of(solution, problem, digits);
}

}  // namespace nipref::verify
