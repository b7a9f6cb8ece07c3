#include <cstdint>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>

namespace nipref::verify {
namespace {

using ref::ConvergedElasticNip;
using ref::Estimated;

const std::map<std::string_view, Estimated (ConvergedElasticNip::*)() const> numbers{
    {"contact_length", &ConvergedElasticNip::contact_length},
    {"load", &ConvergedElasticNip::load},
    {"indentation", &ConvergedElasticNip::indentation},
    {"edge_displacement", &ConvergedElasticNip::edge_displacement},
};

class RefConverged : public SolvedContact<LongEstimate> {
 public:
  explicit RefConverged(ConvergedElasticNip contact) : contact_(std::move(contact)) {}

  [[nodiscard]] LongEstimate number(std::string_view name) const override {
    // Without friction the pressure is largest in the middle.
    if (name == "peak_pressure") return at("pressure", 0);
    return long_estimate(std::invoke(numbers.at(name), contact_));
  }
  [[nodiscard]] LongEstimate at(std::string_view, double y) const override {
    return long_estimate(contact_.pressure(y));
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    return {0, contact_.contact_length().to_double() / 2};
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.kernel_evaluations[0] = static_cast<std::uint64_t>(contact_.kernel_values());
    work.unknowns = contact_.terms() + 1;
    return work;
  }

 private:
  ConvergedElasticNip contact_;
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

void check_ref_converged(const data::Scene& scene, const data::ElasticNipProblem& problem) {
  if (problem.friction != data::Friction::none) {
    scene.origin.refuse("friction.model", "full", "must be none for the reference's converged contact");
  }
  check_wanted_of_ref(
      scene, {"contact_length", "load", "indentation", "edge_displacement", "peak_pressure", "pressure"});
}

std::unique_ptr<SolvedContact<LongEstimate>> solve_ref_converged(const data::ElasticNipProblem& problem,
                                                                 int digits) {
  return std::make_unique<RefConverged>(std::visit(Solve{problem.nip, digits}, problem.given));
}

}  // namespace nipref::verify
