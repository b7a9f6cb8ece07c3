#include "verify/collect_results.hpp"

#include <algorithm>
#include <variant>

namespace nipref::verify {
namespace {

struct PlacePoints {
  double contact_length;

  std::vector<double> operator()(const data::Positions& positions) const { return positions.y; }
  std::vector<double> operator()(const data::EvenlySpaced& spacing) const {
    std::vector<double> y;
    for (int i = 0; i < spacing.points; ++i)
      y.push_back(contact_length / 2 * (static_cast<double>(i) / (spacing.points - 1)));
    return y;
  }
};

}  // namespace

std::vector<double> profile_positions(const data::Scene& scene, const data::ElasticNipProblem& problem,
                                      double contact_length) {
  const bool wanted = std::ranges::any_of(
      scene.wanted, [](const std::string& name) { return data::find_scene_result(name)->is_profile; });
  return wanted ? std::visit(PlacePoints{contact_length}, *problem.profile) : std::vector<double>{};
}

}  // namespace nipref::verify
