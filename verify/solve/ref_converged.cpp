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

const std::map<std::string_view, std::function<Enclosure(const ConvergedElasticNip&)>> numbers{
    {"contact_length", &ConvergedElasticNip::contact_length},
    {"leading_length", [](const auto& contact) { return half_of(contact.contact_length()); }},
    {"trailing_length", [](const auto& contact) { return half_of(contact.contact_length()); }},
    {"load", &ConvergedElasticNip::load},
    {"indentation", &ConvergedElasticNip::indentation},
    {"edge_displacement", &ConvergedElasticNip::edge_displacement},
    {"trailing_displacement", &ConvergedElasticNip::edge_displacement},
    {"rolling_resistance", [](const auto&) { return nothing(); }},
    {"creep_ratio", &ConvergedElasticNip::creep_ratio},
    {"peak_pressure", &ConvergedElasticNip::peak_pressure},
    {"peak_pressure_position", &ConvergedElasticNip::peak_pressure_position},
    {"peak_shear", [](const auto&) { return nothing(); }},
};

const std::map<std::string_view, std::function<Enclosure(const ConvergedElasticNip&, double y)>> profiles{
    {"pressure", &ConvergedElasticNip::pressure},
    {"shear", [](const auto&, double) { return nothing(); }},
    {"normal_displacement", &ConvergedElasticNip::normal_displacement},
    {"tangential_displacement", &ConvergedElasticNip::tangential_displacement},
    {"surface_strain", &ConvergedElasticNip::surface_strain},
};

class RefConverged : public SolvedContact<LongEstimate> {
 public:
  RefConverged(ConvergedElasticNip contact, int digits) : contact_(std::move(contact)), digits_(digits) {}

  [[nodiscard]] LongEstimate number(std::string_view name) const override {
    if (const auto found = inside_.number(contact_, name)) return *found;
    return long_estimate(numbers.at(name)(contact_));
  }
  [[nodiscard]] LongEstimate at(std::string_view name, double y) const override {
    return long_estimate(profiles.at(name)(contact_, y));
  }
  [[nodiscard]] std::vector<LongEstimate> inside(std::string_view name,
                                                 const data::FieldPlaces& places) const override {
    return inside_.field(contact_, name, places);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {0, contact_.contact_length().to_double() / 2};
  }
  /// Of stresses inside; other errors are measured by the results themselves.
  [[nodiscard]] std::optional<double> least_size(std::string_view name, double y) const override {
    const double half = contact_.contact_length().to_double() / 2;
    return inside_result_size(name, y, {1, -half, half, std::pow(10.0, -digits_)},
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
