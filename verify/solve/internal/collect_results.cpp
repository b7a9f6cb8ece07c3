#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>

namespace nipref::verify {
namespace {

bool wants(const data::Scene& scene, data::Shape shape) {
  return std::ranges::any_of(scene.wanted,
                             [&](ResultId id) { return data::scene_result(id).shape == shape; });
}

struct PlacePoints {
  const ContactEnds& ends;

  std::vector<double> operator()(const data::Positions& positions) const { return positions.y; }
  std::vector<double> operator()(const data::EvenlySpaced& spacing) const {
    std::vector<double> y;
    for (int i = 0; i < spacing.points; ++i)
      y.push_back(std::lerp(ends.first, ends.last, static_cast<double>(i) / (spacing.points - 1)));
    return y;
  }
};

}  // namespace

std::vector<double> profile_positions(const data::Scene& scene, const ContactEnds& ends) {
  if (!wants(scene, data::Shape::profile)) return {};
  return std::visit([&](const auto& problem) { return std::visit(PlacePoints{ends}, *problem.profile); },
                    scene.system);
}

data::FieldPlaces field_places(const data::Scene& scene) {
  if (!wants(scene, data::Shape::field)) return {};
  return std::visit(
      [](const auto& problem) {
        if constexpr (requires { problem.field; }) return *problem.field;
        return data::FieldPlaces{};
      },
      scene.system);
}

bool is_by_line_loads(const data::Scene& scene) {
  return std::visit(
      [](const auto& problem) {
        if constexpr (requires { problem.method; })
          return !std::holds_alternative<data::ConvergedMethod>(problem.method);
        return false;
      },
      scene.system);
}

template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact) {
  const auto of_problem = [&](const auto& problem) -> std::vector<BeyondTheory> {
    if constexpr (requires { problem.nip; }) {
      const double indentation = value_of(contact.number(ResultId::indentation)),
                   half = problem.nip.half_thickness();
      if (!(indentation < half)) refuse_meeting_faces(scene, problem.given, indentation, half);
      const auto [first, last] = contact.ends();
      const double farther = std::max(std::fabs(first), std::fabs(last));
      std::vector<BeyondTheory> found{
          {"compressive_strain", indentation / half, linear_theory_limit},
          {"roller_slope", farther / problem.nip.roller_radius, linear_theory_limit}};
      std::erase_if(found, [](const BeyondTheory& one) { return one.value <= one.limit; });
      return found;
    }
    return {};
  };
  return std::visit(of_problem, scene.system);
}

template std::vector<BeyondTheory> beyond_theory(const data::Scene&, const SolvedContact<fast::Estimate>&);
template std::vector<BeyondTheory> beyond_theory(const data::Scene&, const SolvedContact<ref::Estimate>&);

namespace {

/// The load or the length of the scene: its key, its value, and the name of the solvers' argument.
struct Given {
  const char* key;
  double value;
  std::string_view argument;
};

struct NameGiven {
  Given operator()(const data::GivenLoad& load) const { return {"load.per_length", load.per_length, "load"}; }
  Given operator()(const data::GivenLength& length) const {
    return {"contact.length", length.contact_length, "contact_length"};
  }
};

}  // namespace

void refuse_given(const data::Scene& scene, const data::Given& given, const data::BadInput& error) {
  const auto [key, value, argument] = std::visit(NameGiven{}, given);
  if (const auto* refused = dynamic_cast<const data::NoMaterial*>(&error))
    scene.origin.refuse_as(refused->key(), error);
  if (error.argument() == "digits") throw data::BadInput(error);
  if (error.argument() == "nip.material" || error.argument().ends_with(" rate"))
    scene.origin.refuse_as("material", error);
  if (error.argument() == "method.kind") scene.origin.refuse_as("method.kind", error);
  if (error.argument() == "elements_per_side") scene.origin.refuse_as("method.leading_elements", error);
  if (error.argument() == "residue_terms") scene.origin.refuse_as("method.residue_terms", error);
  if (error.argument() == "force_per_length") scene.origin.refuse_as("traction.force_per_length", error);
  if (error.argument() == "friction_coefficient") scene.origin.refuse_as("friction.coefficient", error);
  if (error.argument() == argument) scene.origin.refuse_as(key, error);
  scene.origin.refuse(key, value, fmt::format("cannot be solved ({})", error.what()));
}

void refuse_meeting_faces(const data::Scene& scene, const data::Given& given, double indentation,
                          double half_thickness) {
  const auto [key, value, argument] = std::visit(NameGiven{}, given);
  scene.origin.refuse(
      key, value,
      fmt::format("must be smaller: the faces of the rollers would meet, each {:.3g} into the sheet, of "
                  "which half is {:g}",
                  indentation, half_thickness));
}

}  // namespace nipref::verify
