#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>

namespace nipref::verify {
namespace {

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

struct SolveRefRollingLineLoads {
  const data::ViscoelasticNip& nip;
  ref::ViscoelasticLineLoadMethod method;
  int digits;

  RefViscoelasticLineLoads operator()(const data::GivenLoad& load) const {
    return RefViscoelasticLineLoads::for_load(nip, method, load.per_length, digits);
  }
  RefViscoelasticLineLoads operator()(const data::GivenLength& length) const {
    return RefViscoelasticLineLoads::for_length(nip, method, length.contact_length, digits);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_rolling_line_loads(
    const data::ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& loads, int digits) {
  const ref::ViscoelasticLineLoadMethod method{loads.leading_elements, loads.trailing_elements,
                                               loads.approach_lengths, loads.residue_terms};
  return std::make_unique<RefRollingLineLoads>(
      std::visit(SolveRefRollingLineLoads{problem.nip, method, digits}, problem.given), digits);
}

}  // namespace nipref::verify
