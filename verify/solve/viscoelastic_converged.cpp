#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/fast_methods.hpp>
#include <nipref/verify/solve/internal/inside.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

using fast::ConvergedViscoelasticNip;
using fast::Estimate;

const std::map<ResultId, Estimate (ConvergedViscoelasticNip::*)() const> viscoelastic_converged_numbers{
    {ResultId::contact_length, &ConvergedViscoelasticNip::contact_length},
    {ResultId::leading_length, &ConvergedViscoelasticNip::leading_length},
    {ResultId::trailing_length, &ConvergedViscoelasticNip::trailing_length},
    {ResultId::load, &ConvergedViscoelasticNip::load},
    {ResultId::indentation, &ConvergedViscoelasticNip::indentation},
    {ResultId::edge_displacement, &ConvergedViscoelasticNip::leading_displacement},
    {ResultId::trailing_displacement, &ConvergedViscoelasticNip::trailing_displacement},
    {ResultId::creep_ratio, &ConvergedViscoelasticNip::creep_ratio},
    {ResultId::rolling_resistance, &ConvergedViscoelasticNip::rolling_resistance},
    {ResultId::peak_pressure, &ConvergedViscoelasticNip::peak_pressure},
    {ResultId::peak_pressure_position, &ConvergedViscoelasticNip::peak_pressure_position},
};

const std::map<ResultId, Estimate (ConvergedViscoelasticNip::*)(double) const>
    viscoelastic_converged_profiles{
        {ResultId::pressure, &ConvergedViscoelasticNip::pressure},
        {ResultId::normal_displacement, &ConvergedViscoelasticNip::normal_displacement},
        {ResultId::tangential_displacement, &ConvergedViscoelasticNip::tangential_displacement},
        {ResultId::surface_strain, &ConvergedViscoelasticNip::surface_strain},
        {ResultId::slip, &ConvergedViscoelasticNip::slip},
    };

class Rolling : public SolvedContact<Estimate> {
 public:
  Rolling(ConvergedViscoelasticNip contact, double roller_radius, double asked)
      : contact_(std::move(contact)), roller_radius_(roller_radius), asked_(asked) {}

  [[nodiscard]] Estimate number(ResultId id) const override {
    if (id == ResultId::peak_shear) return {0, 0};  // without friction
    if (const auto found = inside_.number(contact_, id)) return *found;
    if (is_moment(id)) return moment_of_pressure(*this, id);
    return std::invoke(viscoelastic_converged_numbers.at(id), contact_);
  }
  [[nodiscard]] Estimate at(ResultId id, double y) const override {
    if (id == ResultId::shear) return {0, 0};
    return std::invoke(viscoelastic_converged_profiles.at(id), contact_, y);
  }
  [[nodiscard]] std::vector<Estimate> inside(ResultId id, const data::FieldPlaces& places) const override {
    return inside_.field(contact_, id, places);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {-contact_.trailing_length().value, contact_.leading_length().value};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double y) const override {
    const auto [first, last] = profile_extent();
    return nip_result_size(id, y, {roller_radius_, first, last, asked_},
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

  ConvergedViscoelasticNip contact_;
  double roller_radius_, asked_;
  mutable std::optional<double> middle_;
  Inside<ConvergedViscoelasticNip, FastInside> inside_;
};

struct SolveViscoelasticConverged {
  const data::ViscoelasticNip& nip;
  double accuracy;

  ConvergedViscoelasticNip operator()(const data::GivenLoad& load) const {
    return fast::converged_for_load(nip, load.per_length, accuracy);
  }
  ConvergedViscoelasticNip operator()(const data::GivenLength& length) const {
    return fast::converged_for_length(nip, length.contact_length, accuracy);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<Estimate>> solve_viscoelastic(const data::ViscoelasticNipProblem& problem,
                                                            double accuracy) {
  return std::make_unique<Rolling>(
      std::visit(SolveViscoelasticConverged{problem.nip, accuracy}, problem.given), problem.nip.roller_radius,
      accuracy);
}

}  // namespace nipref::verify
