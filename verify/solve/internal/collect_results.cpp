#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <variant>

#include <nipref/verify/solve/internal/collect_results.hpp>

namespace nipref::verify {
namespace {

struct PlacePoints {
  const ProfileExtent& extent;

  std::vector<double> operator()(const data::Positions& positions) const { return positions.y; }
  std::vector<double> operator()(const data::EvenlySpaced& spacing) const {
    std::vector<double> y;
    const auto [first, last] = extent;
    for (int i = 0; i < spacing.points; ++i)
      y.push_back(std::lerp(first, last, static_cast<double>(i) / (spacing.points - 1)));
    return y;
  }
};

}  // namespace

std::vector<double> profile_positions(const data::Scene& scene, const std::optional<data::Profile>& profile,
                                      const ProfileExtent& extent) {
  const bool wanted = std::ranges::any_of(
      scene.wanted, [](ResultId id) { return data::scene_result(id).shape == data::Shape::profile; });
  return wanted ? std::visit(PlacePoints{extent}, *profile) : std::vector<double>{};
}

const data::FieldPlaces& field_places(const data::Scene& scene) {
  struct OfProblem {
    const data::FieldPlaces* operator()(const data::ElasticNipProblem& nip) const { return &*nip.field; }
    const data::FieldPlaces* operator()(const data::ViscoelasticNipProblem& nip) const { return &*nip.field; }
    const data::FieldPlaces* operator()(const data::HalfSpaceProblem&) const { return nullptr; }
  };
  return *std::visit(OfProblem(), scene.system);
}

bool is_by_line_loads(const data::Scene& scene) {
  const auto* elastic = std::get_if<data::ElasticNipProblem>(&scene.system);
  const auto* rolling = std::get_if<data::ViscoelasticNipProblem>(&scene.system);
  return (elastic != nullptr && std::holds_alternative<data::LineLoads>(elastic->method)) ||
         (rolling != nullptr && std::holds_alternative<data::ViscoelasticLineLoads>(rolling->method));
}

void refuse_result(const data::Scene& scene, std::size_t wanted) {
  scene.origin.refuse("wanted[" + std::to_string(wanted) + "]", data::scene_result(scene.wanted[wanted]).name,
                      "must be left out: in this scene it leaves the range of doubles");
}

std::vector<long double> allowed_errors(long double accuracy, const SolvedContact<fast::Estimate>& contact,
                                        const SceneSolution<fast::Estimate>::Result& result,
                                        const std::vector<double>& positions,
                                        const std::vector<double>& along_field) {
  std::vector<long double> allowed;
  for (std::size_t i = 0; i < result.numbers.size(); ++i) {
    double place = result.what->shape == data::Shape::profile ? positions[i] : 0;
    if (result.what->shape == data::Shape::field) place = along_field[i % along_field.size()];
    const auto size = contact.least_size(result.what->id, place);
    if (!size) return {};
    allowed.push_back(accuracy * std::max(*size, std::fabs(result.numbers[i].value)));
  }
  return allowed;
}

std::vector<long double> allowed_errors(long double accuracy, const SolvedContact<ref::Estimate>& contact,
                                        const SceneSolution<ref::Estimate>::Result& result,
                                        const std::vector<double>& positions,
                                        const std::vector<double>& along_field) {
  long double largest = 0;
  for (const ref::Estimate& number : result.numbers)
    largest = std::max(largest, std::fabs(mpfr_get_ld(number.value.get(), MPFR_RNDN)));
  std::vector<long double> allowed;
  for (std::size_t i = 0; i < result.numbers.size(); ++i) {
    double place = result.what->shape == data::Shape::profile ? positions[i] : 0;
    if (result.what->shape == data::Shape::field) place = along_field[i % along_field.size()];
    const long double least = contact.least_size(result.what->id, place).value_or(0);
    allowed.push_back(accuracy * std::max(largest, least));
  }
  return allowed;
}

}  // namespace nipref::verify
