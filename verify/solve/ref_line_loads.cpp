#include <map>
#include <utility>

#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/elastic_nip/line_loads_displacements.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/methods.hpp>

namespace nipref::verify {
namespace {

const std::map<ResultId, ref::Enclosure ref::LineLoadSolution::*> ref_line_load_numbers{
    {ResultId::contact_length, &ref::LineLoadSolution::contact_length},
    {ResultId::load, &ref::LineLoadSolution::load},
    {ResultId::indentation, &ref::LineLoadSolution::indentation},
    {ResultId::edge_displacement, &ref::LineLoadSolution::edge_displacement},
    {ResultId::trailing_displacement, &ref::LineLoadSolution::edge_displacement},
    {ResultId::peak_pressure, &ref::LineLoadSolution::peak_pressure},
    {ResultId::peak_shear, &ref::LineLoadSolution::peak_shear},
};

class RefLineLoads : public SolvedContact<ref::Estimate> {
 public:
  RefLineLoads(const data::ElasticNip& nip, const ref::LineLoadMethod& method, ref::LineLoadSolution solution,
               int digits)
      : nip_(nip), method_(method), solution_(std::move(solution)), digits_(digits) {}

  [[nodiscard]] ref::Estimate number(ResultId id) const override {
    if (id == ResultId::rolling_resistance) return ref::exact_zero(digits_);
    if (id == ResultId::creep_ratio) return ref::creep_ratio(nip_, solution_, method_, digits_);
    if (id == ResultId::peak_pressure_position) return ref::place_of_largest_pressure(solution_, digits_);
    if (id == ResultId::peak_shear_position) return ref::place_of_largest_shear(solution_, digits_);
    if (id == ResultId::leading_length || id == ResultId::trailing_length)
      return ref::enclosure_of(ref::interval_of(solution_.contact_length) / 2, digits_);
    return solution_.*ref_line_load_numbers.at(id);
  }
  [[nodiscard]] ref::Estimate at(ResultId id, double y) const override {
    if (id == ResultId::pressure) return ref::element_pressure(solution_, y, digits_);
    if (id == ResultId::shear) return ref::element_shear(solution_, y, digits_);
    const auto displacement =
        id == ResultId::normal_displacement ? ref::normal_displacement : ref::tangential_displacement;
    return displacement(nip_, solution_, method_, y, digits_);
  }
  [[nodiscard]] std::vector<ref::Estimate> list(ResultId id) const override {
    if (id == ResultId::creep_range) {
      const auto [lower, upper, chosen] = ref::creep_range(nip_, solution_, method_, digits_);
      return {lower, upper, chosen};
    }
    const auto borders = ref::shear_borders(solution_, digits_);
    return {borders.begin(), borders.end()};
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {0, solution_.contact_length.to_double() / 2};
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.unknowns = static_cast<int>(1 + solution_.line_loads.size() + solution_.shear_loads.size());
    return work;
  }

 private:
  data::ElasticNip nip_;
  ref::LineLoadMethod method_;
  ref::LineLoadSolution solution_;
  int digits_;
};

using RefViscoelasticLineLoads = ref::ViscoelasticLineLoads;
using RefEstimate = ref::Estimate (RefViscoelasticLineLoads::*)() const;

const std::map<ResultId, RefEstimate> rolling_line_load_numbers{
    {ResultId::contact_length, &RefViscoelasticLineLoads::contact_length},
    {ResultId::leading_length, &RefViscoelasticLineLoads::leading_length},
    {ResultId::trailing_length, &RefViscoelasticLineLoads::trailing_length},
    {ResultId::load, &RefViscoelasticLineLoads::load},
    {ResultId::indentation, &RefViscoelasticLineLoads::indentation},
    {ResultId::edge_displacement, &RefViscoelasticLineLoads::leading_displacement},
    {ResultId::trailing_displacement, &RefViscoelasticLineLoads::trailing_displacement},
    {ResultId::rolling_resistance, &RefViscoelasticLineLoads::rolling_resistance},
    {ResultId::leading_moment, &RefViscoelasticLineLoads::leading_moment},
    {ResultId::trailing_moment, &RefViscoelasticLineLoads::trailing_moment},
    {ResultId::creep_ratio, &RefViscoelasticLineLoads::creep_ratio},
    {ResultId::peak_pressure, &RefViscoelasticLineLoads::peak_pressure},
    {ResultId::peak_pressure_position, &RefViscoelasticLineLoads::peak_pressure_position},
};

class RefRollingLineLoads : public SolvedContact<ref::Estimate> {
 public:
  RefRollingLineLoads(RefViscoelasticLineLoads solution, int digits)
      : solution_(std::move(solution)), digits_(digits) {}

  [[nodiscard]] ref::Estimate number(ResultId id) const override {
    if (id == ResultId::peak_shear) return ref::exact_zero(digits_);
    return (solution_.*rolling_line_load_numbers.at(id))();
  }
  [[nodiscard]] ref::Estimate at(ResultId id, double y) const override {
    if (id == ResultId::shear) return ref::exact_zero(digits_);
    if (id == ResultId::pressure) return solution_.pressure(y);
    if (id == ResultId::normal_displacement) return solution_.normal_displacement(y);
    return solution_.tangential_displacement(y);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {-solution_.trailing_length().to_double(), solution_.leading_length().to_double()};
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.systems = static_cast<std::uint64_t>(solution_.systems());
    work.unknowns = solution_.elements() + 1;
    return work;
  }

 private:
  RefViscoelasticLineLoads solution_;
  int digits_;
};

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
  return std::make_unique<RefLineLoads>(
      problem.nip, method,
      solve_given(
          problem.given,
          [&](double load) { return ref::line_loads_for_load(problem.nip, method, load, digits, grip); },
          [&](double length) {
            return ref::line_loads_for_length(problem.nip, method, length, digits, grip);
          }),
      digits);
}

SolvedByRef solve_ref_line_loads(const data::ViscoelasticNipProblem& problem,
                                 const data::ViscoelasticLineLoads& loads, int digits) {
  const ref::ViscoelasticLineLoadMethod method{loads.leading_elements, loads.trailing_elements,
                                               loads.approach_lengths, loads.residue_terms};
  return std::make_unique<RefRollingLineLoads>(
      solve_given(
          problem.given,
          [&](double load) { return RefViscoelasticLineLoads::for_load(problem.nip, method, load, digits); },
          [&](double length) {
            return RefViscoelasticLineLoads::for_length(problem.nip, method, length, digits);
          }),
      digits);
}

}  // namespace nipref::verify
