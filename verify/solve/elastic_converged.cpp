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

const std::map<std::string_view, Estimate (ConvergedElasticNip::*)() const> elastic_converged_numbers{
    {"contact_length", &ConvergedElasticNip::contact_length},
    {"load", &ConvergedElasticNip::load},
    {"indentation", &ConvergedElasticNip::indentation},
    {"edge_displacement", &ConvergedElasticNip::edge_displacement},
    {"creep_ratio", &ConvergedElasticNip::creep_ratio},
    {"peak_pressure", &ConvergedElasticNip::peak_pressure},
    {"peak_pressure_position", &ConvergedElasticNip::peak_pressure_position},
    {"peak_shear", &ConvergedElasticNip::peak_shear},
    {"peak_shear_position", &ConvergedElasticNip::peak_shear_position},
};

const std::map<std::string_view, Estimate (ConvergedElasticNip::*)(double) const> elastic_converged_profiles{
    {"pressure", &ConvergedElasticNip::pressure},
    {"shear", &ConvergedElasticNip::shear},
    {"normal_displacement", &ConvergedElasticNip::normal_displacement},
    {"tangential_displacement", &ConvergedElasticNip::tangential_displacement},
    {"surface_strain", &ConvergedElasticNip::surface_strain},
    {"slip", &ConvergedElasticNip::slip},
};

class Converged : public SolvedContact<Estimate> {
 public:
  Converged(ConvergedElasticNip contact, double roller_radius, double asked)
      : contact_(std::move(contact)), roller_radius_(roller_radius), asked_(asked) {}

  [[nodiscard]] Estimate number(std::string_view name) const override {
    if (const auto same = by_symmetry(*this, name)) return *same;
    if (const auto found = inside_.number(contact_, name)) return *found;
    if (is_moment(name)) return moment_of_pressure(*this, name);
    return std::invoke(elastic_converged_numbers.at(name), contact_);
  }
  [[nodiscard]] Estimate at(std::string_view name, double y) const override {
    return std::invoke(elastic_converged_profiles.at(name), contact_, y);
  }
  [[nodiscard]] std::vector<Estimate> inside(std::string_view name,
                                             const data::FieldPlaces& places) const override {
    return inside_.field(contact_, name, places);
  }
  [[nodiscard]] std::vector<Estimate> list(std::string_view) const override { return contact_.shear_zeros(); }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {0, contact_.contact_length().value / 2};
  }
  [[nodiscard]] std::optional<double> least_size(std::string_view name, double y) const override {
    const double half = contact_.contact_length().value / 2;
    return nip_result_size(name, y, {roller_radius_, -half, half, asked_},
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
