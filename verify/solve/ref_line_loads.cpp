#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>

namespace nipref::verify {
namespace {

using ref::Enclosure;
using ref::LineLoadSolution;

const std::map<std::string_view, Enclosure LineLoadSolution::*> numbers{
    {"load", &LineLoadSolution::load},
    {"indentation", &LineLoadSolution::indentation},
    {"edge_displacement", &LineLoadSolution::edge_displacement},
};

class RefLineLoads : public SolvedContact<LongEstimate> {
 public:
  RefLineLoads(double contact_length, LineLoadSolution solution)
      : contact_length_(contact_length), solution_(std::move(solution)) {}

  [[nodiscard]] LongEstimate number(std::string_view name) const override {
    return long_estimate(solution_.*numbers.at(name));
  }
  /// There are no profiles: check_ref_line_loads refuses them.
  [[nodiscard]] LongEstimate at(std::string_view name, double) const override { return number(name); }
  [[nodiscard]] ProfileExtent profile_extent() const override { return {0, contact_length_ / 2}; }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.unknowns = static_cast<int>(1 + solution_.line_loads.size() + solution_.shear_loads.size());
    return work;
  }

 private:
  double contact_length_;
  LineLoadSolution solution_;
};

}  // namespace

void check_ref_line_loads(const data::Scene& scene, const data::ElasticNipProblem& problem,
                          const data::LineLoads& loads) {
  if (const auto* load = std::get_if<data::GivenLoad>(&problem.given)) {
    scene.origin.refuse("load.per_length", load->per_length,
                        "must be a [contact] length for the reference's line loads");
  }
  if (problem.friction == data::Friction::full && !problem.creep_ratio) {
    scene.origin.refuse("friction.creep_ratio", "(missing)", "must be given for the reference's line loads");
  }
  if (loads.residue_terms > 0) {
    scene.origin.refuse("method.residue_terms", loads.residue_terms, "must be 0 for the reference");
  }
  check_wanted_of_ref(scene, {"load", "indentation", "edge_displacement"});
}

std::unique_ptr<SolvedContact<LongEstimate>> solve_ref_line_loads(const data::ElasticNipProblem& problem,
                                                                  const data::LineLoads& loads, int digits) {
  const double length = std::get<data::GivenLength>(problem.given).contact_length;
  const int elements = loads.leading_elements;
  return std::make_unique<RefLineLoads>(
      length, problem.creep_ratio ? ref::gripped_line_loads_for_length(problem.nip, elements, length,
                                                                       *problem.creep_ratio, digits)
                                  : ref::line_loads_for_length(problem.nip, elements, length, digits));
}

}  // namespace nipref::verify
