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

const std::map<std::string_view, Estimate (ConvergedViscoelasticNip::*)() const>
    viscoelastic_converged_numbers{
        {"contact_length", &ConvergedViscoelasticNip::contact_length},
        {"leading_length", &ConvergedViscoelasticNip::leading_length},
        {"trailing_length", &ConvergedViscoelasticNip::trailing_length},
        {"load", &ConvergedViscoelasticNip::load},
        {"indentation", &ConvergedViscoelasticNip::indentation},
        {"edge_displacement", &ConvergedViscoelasticNip::leading_displacement},
        {"trailing_displacement", &ConvergedViscoelasticNip::trailing_displacement},
        {"creep_ratio", &ConvergedViscoelasticNip::creep_ratio},
        {"rolling_resistance", &ConvergedViscoelasticNip::rolling_resistance},
        {"peak_pressure", &ConvergedViscoelasticNip::peak_pressure},
        {"peak_pressure_position", &ConvergedViscoelasticNip::peak_pressure_position},
    };

const std::map<std::string_view, Estimate (ConvergedViscoelasticNip::*)(double) const>
    viscoelastic_converged_profiles{
        {"pressure", &ConvergedViscoelasticNip::pressure},
        {"normal_displacement", &ConvergedViscoelasticNip::normal_displacement},
        {"tangential_displacement", &ConvergedViscoelasticNip::tangential_displacement},
        {"surface_strain", &ConvergedViscoelasticNip::surface_strain},
        {"slip", &ConvergedViscoelasticNip::slip},
    };

class Rolling : public SolvedContact<Estimate> {
 public:
  Rolling(ConvergedViscoelasticNip contact, double roller_radius, double asked)
      : contact_(std::move(contact)), roller_radius_(roller_radius), asked_(asked) {}

  [[nodiscard]] Estimate number(std::string_view name) const override {
    if (name == "peak_shear") return {0, 0};  // without friction
    if (const auto found = inside_.number(contact_, name)) return *found;
    if (is_moment(name)) return moment_of_pressure(*this, name);
    return std::invoke(viscoelastic_converged_numbers.at(name), contact_);
  }
  [[nodiscard]] Estimate at(std::string_view name, double y) const override {
    if (name == "shear") return {0, 0};
    return std::invoke(viscoelastic_converged_profiles.at(name), contact_, y);
  }
  [[nodiscard]] std::vector<Estimate> inside(std::string_view name,
                                             const data::FieldPlaces& places) const override {
    return inside_.field(contact_, name, places);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {-contact_.trailing_length().value, contact_.leading_length().value};
  }
  [[nodiscard]] std::optional<double> least_size(std::string_view name, double y) const override {
    const auto [first, last] = profile_extent();
    return nip_result_size(name, y, {roller_radius_, first, last, asked_},
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
