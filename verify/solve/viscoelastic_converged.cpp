#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/fast_methods.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;
using fast::RollingContact;

const std::map<std::string_view, Estimate (RollingContact::*)() const> numbers{
    {"contact_length", &RollingContact::contact_length},
    {"leading_length", &RollingContact::leading_length},
    {"trailing_length", &RollingContact::trailing_length},
    {"load", &RollingContact::load},
    {"indentation", &RollingContact::indentation},
    {"edge_displacement", &RollingContact::leading_displacement},
    {"trailing_displacement", &RollingContact::trailing_displacement},
    {"creep_ratio", &RollingContact::creep_ratio},
    {"rolling_resistance", &RollingContact::rolling_resistance},
    {"peak_pressure", &RollingContact::peak_pressure},
};

const std::map<std::string_view, Estimate (RollingContact::*)(double) const> profiles{
    {"pressure", &RollingContact::pressure},
    {"normal_displacement", &RollingContact::normal_displacement},
    {"tangential_displacement", &RollingContact::tangential_displacement},
};

class Rolling : public SolvedContact<Estimate> {
 public:
  explicit Rolling(RollingContact contact) : contact_(std::move(contact)) {}

  [[nodiscard]] Estimate number(std::string_view name) const override {
    if (name == "peak_shear") return {0, 0};  // without friction
    return std::invoke(numbers.at(name), contact_);
  }
  [[nodiscard]] Estimate at(std::string_view name, double y) const override {
    if (name == "shear") return {0, 0};
    return std::invoke(profiles.at(name), contact_, y);
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {-contact_.trailing_length().value, contact_.leading_length().value};
  }
  [[nodiscard]] fast::ContactWork work() const override { return contact_.work(); }

 private:
  RollingContact contact_;
};

struct Solve {
  const data::ViscoelasticNip& nip;
  double accuracy;

  RollingContact operator()(const data::GivenLoad& load) const {
    return fast::rolling_for_load(nip, load.per_length, accuracy);
  }
  RollingContact operator()(const data::GivenLength& length) const {
    return fast::rolling_for_length(nip, length.contact_length, accuracy);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<Estimate>> solve_rolling(const data::ViscoelasticNipProblem& problem,
                                                       double accuracy) {
  return std::make_unique<Rolling>(std::visit(Solve{problem.nip, accuracy}, problem.given));
}

}  // namespace nipref::verify
