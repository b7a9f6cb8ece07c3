#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/fast_methods.hpp>
#include <nipref/verify/solve/internal/inside.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>
#include <nipref/verify/solve/internal/symmetry.hpp>

namespace nipref::verify {
namespace {

using fast::ConvergedElasticNip;
using fast::Estimate;

const std::map<ResultId, Estimate (ConvergedElasticNip::*)() const> elastic_converged_numbers{
    {ResultId::contact_length, &ConvergedElasticNip::contact_length},
    {ResultId::load, &ConvergedElasticNip::load},
    {ResultId::indentation, &ConvergedElasticNip::indentation},
    {ResultId::edge_displacement, &ConvergedElasticNip::edge_displacement},
    {ResultId::creep_ratio, &ConvergedElasticNip::creep_ratio},
    {ResultId::peak_pressure, &ConvergedElasticNip::peak_pressure},
    {ResultId::peak_pressure_position, &ConvergedElasticNip::peak_pressure_position},
    {ResultId::peak_shear, &ConvergedElasticNip::peak_shear},
    {ResultId::peak_shear_position, &ConvergedElasticNip::peak_shear_position},
};

const std::map<ResultId, Estimate (ConvergedElasticNip::*)(double) const> elastic_converged_profiles{
    {ResultId::pressure, &ConvergedElasticNip::pressure},
    {ResultId::shear, &ConvergedElasticNip::shear},
    {ResultId::normal_displacement, &ConvergedElasticNip::normal_displacement},
    {ResultId::tangential_displacement, &ConvergedElasticNip::tangential_displacement},
    {ResultId::surface_strain, &ConvergedElasticNip::surface_strain},
    {ResultId::slip, &ConvergedElasticNip::slip},
};

class Converged : public SolvedContact<Estimate> {
 public:
  Converged(ConvergedElasticNip contact, double roller_radius, double asked)
      : contact_(std::move(contact)), roller_radius_(roller_radius), asked_(asked) {}

  [[nodiscard]] Estimate number(ResultId id) const override {
    if (const auto same = by_symmetry(*this, id)) return *same;
    if (const auto found = inside_.number(contact_, id)) return *found;
    if (is_moment(id)) return moment_of_pressure(*this, id);
    return std::invoke(elastic_converged_numbers.at(id), contact_);
  }
  [[nodiscard]] Estimate at(ResultId id, double y) const override {
    return std::invoke(elastic_converged_profiles.at(id), contact_, y);
  }
  [[nodiscard]] std::vector<Estimate> inside(ResultId id, const data::FieldPlaces& places) const override {
    return inside_.field(contact_, id, places);
  }
  [[nodiscard]] std::vector<Estimate> list(ResultId) const override { return contact_.shear_zeros(); }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {0, contact_.contact_length().value / 2};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double y) const override {
    const double half = contact_.contact_length().value / 2;
    return nip_result_size(id, y, {roller_radius_, -half, half, asked_},
                           [&] { return pressure_in_the_middle(); });
  }
  bool refine() override {
    middle_.reset();
    inside_ = {};
    return contact_.refine();
  }
  [[nodiscard]] fast::Work work() const override { return contact_.work(); }

 private:
  /// Asked for with every number of a field.
  [[nodiscard]] double pressure_in_the_middle() const {
    if (!middle_) middle_ = contact_.pressure(0).value;
    return *middle_;
  }

  ConvergedElasticNip contact_;
  double roller_radius_, asked_;
  mutable std::optional<double> middle_;
  Inside<ConvergedElasticNip, FastInside> inside_;
};

struct SolveElasticConverged {
  const data::ElasticNipProblem& problem;
  double accuracy;

  ConvergedElasticNip operator()(const data::GivenLoad& load) const {
    return fast::converged_for_load(problem.nip, problem.friction, load.per_length, accuracy);
  }
  ConvergedElasticNip operator()(const data::GivenLength& length) const {
    return fast::converged_for_length(problem.nip, problem.friction, length.contact_length, accuracy);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<Estimate>> solve_converged(const data::ElasticNipProblem& problem,
                                                         double accuracy) {
  return std::make_unique<Converged>(std::visit(SolveElasticConverged{problem, accuracy}, problem.given),
                                     problem.nip.roller_radius, accuracy);
}

}  // namespace nipref::verify
