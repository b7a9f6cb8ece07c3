#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/elastic_nip/gripped.hpp>
#include <nipref/verify/solve/internal/inside.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

using ref::Estimated;
using ref::GrippedElasticNip;

Estimated half_length(const GrippedElasticNip& contact) {
  Estimated x = contact.contact_length();
  mpfr_div_2ui(x.value.get(), x.value.get(), 1, MPFR_RNDN);
  mpfr_div_2ui(x.error.get(), x.error.get(), 1, MPFR_RNDU);
  return x;
}

const std::map<ResultId, std::function<Estimated(const GrippedElasticNip&)>> gripped_numbers{
    {ResultId::contact_length, &GrippedElasticNip::contact_length},
    {ResultId::leading_length, half_length},
    {ResultId::trailing_length, half_length},
    {ResultId::load, &GrippedElasticNip::load},
    {ResultId::indentation, &GrippedElasticNip::indentation},
    {ResultId::edge_displacement, &GrippedElasticNip::edge_displacement},
    {ResultId::trailing_displacement, &GrippedElasticNip::edge_displacement},
    {ResultId::creep_ratio, &GrippedElasticNip::creep_ratio},
    {ResultId::peak_pressure, &GrippedElasticNip::peak_pressure},
    {ResultId::peak_shear, &GrippedElasticNip::peak_shear},
    {ResultId::peak_shear_position, &GrippedElasticNip::peak_shear_position},
};

const std::map<ResultId, Estimated (GrippedElasticNip::*)(double) const> gripped_profiles{
    {ResultId::pressure, &GrippedElasticNip::pressure},
    {ResultId::shear, &GrippedElasticNip::shear},
    {ResultId::normal_displacement, &GrippedElasticNip::normal_displacement},
    {ResultId::tangential_displacement, &GrippedElasticNip::tangential_displacement},
    {ResultId::surface_strain, &GrippedElasticNip::surface_strain},
};

class RefGripped : public SolvedContact<LongEstimate> {
 public:
  RefGripped(GrippedElasticNip contact, int digits) : contact_(std::move(contact)), digits_(digits) {}

  [[nodiscard]] LongEstimate number(ResultId id) const override {
    if (const auto found = inside_.number(contact_, id)) return *found;
    if (id == ResultId::rolling_resistance || id == ResultId::peak_pressure_position)
      return long_estimate(ref::exact_zero(16));
    return long_estimate(gripped_numbers.at(id)(contact_));
  }
  [[nodiscard]] LongEstimate at(ResultId id, double y) const override {
    return long_estimate(std::invoke(gripped_profiles.at(id), contact_, y));
  }
  [[nodiscard]] std::vector<LongEstimate> inside(ResultId id,
                                                 const data::FieldPlaces& places) const override {
    return inside_.field(contact_, id, places);
  }
  [[nodiscard]] std::vector<LongEstimate> list(ResultId) const override {
    std::vector<LongEstimate> zeros;
    for (const Estimated& zero : contact_.shear_zeros()) zeros.push_back(long_estimate(zero));
    return zeros;
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
    work.kernel_evaluations[0] = static_cast<std::uint64_t>(contact_.normal_values());
    work.kernel_evaluations[2] = static_cast<std::uint64_t>(contact_.coupling_values());
    work.kernel_evaluations[5] = static_cast<std::uint64_t>(contact_.stretch_values());
    work.unknowns = contact_.terms() + 2;
    return work;
  }

 private:
  GrippedElasticNip contact_;
  int digits_;
  Inside<GrippedElasticNip, RefInside> inside_;
};

struct SolveGripped {
  const data::ElasticNip& nip;
  int digits;

  GrippedElasticNip operator()(const data::GivenLoad& load) const {
    return ref::gripped_for_load(nip, load.per_length, digits);
  }
  GrippedElasticNip operator()(const data::GivenLength& length) const {
    return ref::gripped_for_length(nip, length.contact_length, digits);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<LongEstimate>> solve_ref_gripped(const data::ElasticNipProblem& problem,
                                                               int digits) {
  return std::make_unique<RefGripped>(std::visit(SolveGripped{problem.nip, digits}, problem.given), digits);
}

}  // namespace nipref::verify
