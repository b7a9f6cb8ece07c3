#include <fmt/format.h>

#include <string_view>
#include <variant>

#include <nipref/verify/solve/internal/methods.hpp>

namespace nipref::verify {
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
  if (error.argument() == "residue_terms") scene.origin.refuse_as("method.residue_terms", error);
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
