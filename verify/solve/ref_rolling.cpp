#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/inside.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

using RollingNip = ref::ConvergedViscoelasticNip;

/// Of a contact without friction.
LongEstimate no_shear() { return long_estimate(ref::exact_zero(16)); }

const std::map<ResultId, ref::Estimated (RollingNip::*)() const> rolling_numbers{
    {ResultId::contact_length, &RollingNip::contact_length},
    {ResultId::leading_length, &RollingNip::leading_length},
    {ResultId::trailing_length, &RollingNip::trailing_length},
    {ResultId::load, &RollingNip::load},
    {ResultId::indentation, &RollingNip::indentation},
    {ResultId::edge_displacement, &RollingNip::leading_displacement},
    {ResultId::trailing_displacement, &RollingNip::trailing_displacement},
    {ResultId::creep_ratio, &RollingNip::creep_ratio},
    {ResultId::rolling_resistance, &RollingNip::rolling_resistance},
    {ResultId::peak_pressure, &RollingNip::peak_pressure},
    {ResultId::peak_pressure_position, &RollingNip::peak_pressure_position},
};

const std::map<ResultId, ref::Estimated (RollingNip::*)(double) const> rolling_profiles{
    {ResultId::pressure, &RollingNip::pressure},
    {ResultId::normal_displacement, &RollingNip::normal_displacement},
    {ResultId::tangential_displacement, &RollingNip::tangential_displacement},
    {ResultId::surface_strain, &RollingNip::surface_strain},
};

class RefRolling : public SolvedContact<LongEstimate> {
 public:
  RefRolling(RollingNip contact, double roller_radius, int digits)
      : contact_(std::move(contact)), roller_radius_(roller_radius), digits_(digits) {}

  [[nodiscard]] LongEstimate number(ResultId id) const override {
    if (const auto found = inside_.number(contact_, id)) return *found;
    if (id == ResultId::peak_shear) return no_shear();
    return long_estimate(std::invoke(rolling_numbers.at(id), contact_));
  }
  [[nodiscard]] LongEstimate at(ResultId id, double y) const override {
    if (id == ResultId::shear) return no_shear();
    return long_estimate(std::invoke(rolling_profiles.at(id), contact_, y));
  }
  [[nodiscard]] std::vector<LongEstimate> inside(ResultId id,
                                                 const data::FieldPlaces& places) const override {
    return inside_.field(contact_, id, places);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {-contact_.trailing_length().to_double(), contact_.leading_length().to_double()};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double y) const override {
    const auto [first, last] = profile_extent();
    return nip_result_size(id, y, {roller_radius_, first, last, std::pow(10.0, -digits_)},
                           [&] { return contact_.pressure(0).to_double(); });
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.kernel_evaluations[0] = static_cast<std::uint64_t>(contact_.normal_kernel_values());
    work.kernel_evaluations[2] = static_cast<std::uint64_t>(contact_.tangential_kernel_values());
    work.unknowns = contact_.unknowns();
    return work;
  }

 private:
  RollingNip contact_;
  Inside<RollingNip, RefInside> inside_;
  double roller_radius_;
  int digits_;
};

struct SolveRolling {
  const data::ViscoelasticNip& nip;
  int digits;

  RollingNip operator()(const data::GivenLoad& load) const {
    return ref::converged_for_load(nip, load.per_length, digits);
  }
  RollingNip operator()(const data::GivenLength& length) const {
    return ref::converged_for_length(nip, length.contact_length, digits);
  }
};

}  // namespace

void check_ref_rolling(const data::Scene& scene) {
  std::vector<ResultId> known{ResultId::peak_shear, ResultId::shear, ResultId::slip};
  for (const auto& number : rolling_numbers) known.push_back(number.first);
  for (const auto& profile : rolling_profiles) known.push_back(profile.first);
  for (const data::SceneResult& result : data::scene_results()) {
    if (result.is_inside) known.push_back(result.id);
  }
  check_wanted_of_ref(scene, known);
}

std::unique_ptr<SolvedContact<LongEstimate>> solve_ref_rolling(const data::ViscoelasticNipProblem& problem,
                                                               int digits) {
  return std::make_unique<RefRolling>(std::visit(SolveRolling{problem.nip, digits}, problem.given),
                                      problem.nip.roller_radius, digits);
}

}  // namespace nipref::verify
