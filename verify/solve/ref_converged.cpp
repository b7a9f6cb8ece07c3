#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/inside.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

using ref::ConvergedElasticNip;
using ref::Enclosure;

/// Of a contact without friction.
Enclosure nothing() { return ref::exact_zero(16); }

Enclosure half_of(Enclosure x) {
  mpfr_div_2ui(x.value.get(), x.value.get(), 1, MPFR_RNDN);
  mpfr_div_2ui(x.error_bound.get(), x.error_bound.get(), 1, MPFR_RNDU);
  return x;
}

const std::map<ResultId, std::function<Enclosure(const ConvergedElasticNip&)>> numbers{
    {ResultId::contact_length, &ConvergedElasticNip::contact_length},
    {ResultId::leading_length, [](const auto& contact) { return half_of(contact.contact_length()); }},
    {ResultId::trailing_length, [](const auto& contact) { return half_of(contact.contact_length()); }},
    {ResultId::load, &ConvergedElasticNip::load},
    {ResultId::indentation, &ConvergedElasticNip::indentation},
    {ResultId::edge_displacement, &ConvergedElasticNip::edge_displacement},
    {ResultId::trailing_displacement, &ConvergedElasticNip::edge_displacement},
    {ResultId::rolling_resistance, [](const auto&) { return nothing(); }},
    {ResultId::creep_ratio, &ConvergedElasticNip::creep_ratio},
    {ResultId::peak_pressure, &ConvergedElasticNip::peak_pressure},
    {ResultId::peak_pressure_position, &ConvergedElasticNip::peak_pressure_position},
    {ResultId::peak_shear, [](const auto&) { return nothing(); }},
};

const std::map<ResultId, std::function<Enclosure(const ConvergedElasticNip&, double y)>> profiles{
    {ResultId::pressure, &ConvergedElasticNip::pressure},
    {ResultId::shear, [](const auto&, double) { return nothing(); }},
    {ResultId::normal_displacement, &ConvergedElasticNip::normal_displacement},
    {ResultId::tangential_displacement, &ConvergedElasticNip::tangential_displacement},
    {ResultId::surface_strain, &ConvergedElasticNip::surface_strain},
};

class RefConverged : public SolvedContact<LongEstimate> {
 public:
  RefConverged(ConvergedElasticNip contact, int digits) : contact_(std::move(contact)), digits_(digits) {}

  [[nodiscard]] LongEstimate number(ResultId id) const override {
    if (const auto found = inside_.number(contact_, id)) return *found;
    return long_estimate(numbers.at(id)(contact_));
  }
  [[nodiscard]] LongEstimate at(ResultId id, double y) const override {
    return long_estimate(profiles.at(id)(contact_, y));
  }
  [[nodiscard]] std::vector<LongEstimate> inside(ResultId id,
                                                 const data::FieldPlaces& places) const override {
    return inside_.field(contact_, id, places);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {0, contact_.contact_length().to_double() / 2};
  }
  /// Of stresses inside; other errors are measured by the results themselves.
  [[nodiscard]] std::optional<double> least_size(ResultId id, double y) const override {
    const double half = contact_.contact_length().to_double() / 2;
    return inside_result_size(id, y, {1, -half, half, std::pow(10.0, -digits_)},
                              [&] { return contact_.pressure(0).to_double(); });
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.kernel_evaluations[0] = static_cast<std::uint64_t>(contact_.kernel_values());
    work.kernel_evaluations[2] = static_cast<std::uint64_t>(contact_.coupling_values());
    work.unknowns = contact_.terms();
    return work;
  }

 private:
  ConvergedElasticNip contact_;
  int digits_;
  Inside<ConvergedElasticNip, RefInside> inside_;
};

struct Solve {
  const data::ElasticNip& nip;
  int digits;

  ConvergedElasticNip operator()(const data::GivenLoad& load) const {
    return ref::converged_for_load(nip, load.per_length, digits);
  }
  ConvergedElasticNip operator()(const data::GivenLength& length) const {
    return ref::converged_for_length(nip, length.contact_length, digits);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<LongEstimate>> solve_ref_converged(const data::ElasticNipProblem& problem,
                                                                 int digits) {
  if (problem.friction == data::Friction::full) return solve_ref_gripped(problem, digits);
  return std::make_unique<RefConverged>(std::visit(Solve{problem.nip, digits}, problem.given), digits);
}

}  // namespace nipref::verify
