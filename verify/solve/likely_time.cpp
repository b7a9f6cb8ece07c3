#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {
namespace {

constexpr double of_load = 2;          ///< time for a given load over the time for a given length
constexpr double rough_enough = 1e-3;  ///< relative accuracy of the length

/// The time for profiles that are integrals over the contact, and for stresses inside the sheet, which are computed
/// together at each place. The search for the greatest shear evaluates about `searched` places.
template <class Problem>
double seconds_for_places(const data::Scene& scene, const Problem& problem, double length) {
  const double ratio = length / problem.nip.sheet_thickness;
  constexpr double searched = 65;
  double integrals = 0, inside = 0;
  bool searches = false;
  for (const data::ResultId id : scene.wanted) {
    const data::SceneResult& result = data::scene_result(id);
    const bool is_traction = id == data::ResultId::pressure || id == data::ResultId::shear;
    if (result.shape == data::Shape::profile && !is_traction)
      integrals += static_cast<double>(data::count_of(*problem.profile));
    searches |= result.needs == data::Needs::inside_all;
  }
  if (wants(scene, data::Shape::field)) inside += static_cast<double>(problem.field->size());
  if (searches) inside += searched;
  // With full friction there are pressure and shear, both complex; a contact that rolls is not symmetric.
  constexpr bool rolls = std::is_same_v<Problem, data::ViscoelasticNipProblem>;
  const double of_kind = rolls ? 2 : has_full_friction(problem) ? 1.5 : 1;
  return 0.02 * (1 + ratio / 4) * integrals + 0.1 * (1 + ratio) * of_kind * inside;
}

struct LikelySeconds {
  const data::Scene& scene;
  int digits;

  template <class Problem>
  double operator()(const Problem& problem) const {
    if (!std::holds_alternative<data::ConvergedMethod>(problem.method)) return 0;
    const auto* const load = std::get_if<data::GivenLoad>(&problem.given);
    return with_nip(problem, [&](const auto&... nip) {
      const double length =
          load != nullptr
              ? fast::converged_for_load(nip..., load->per_length, rough_enough).contact_length().value
              : std::get<data::GivenLength>(problem.given).contact_length;
      return likely_seconds(nip..., length, digits) * (load != nullptr ? of_load : 1) +
             seconds_for_places(scene, problem, length);
    });
  }
  /// Zones are divided into panels of at most one and a half thicknesses.
  double operator()(const data::PartialSlipProblem& problem) const {
    if (!std::holds_alternative<data::ConvergedMethod>(problem.method)) return 0;
    const auto* const load = std::get_if<data::GivenLoad>(&problem.given);
    const auto contact =
        load != nullptr
            ? fast::partial_slip_for_load(problem.nip, load->per_length, rough_enough)
            : fast::partial_slip_for_length(
                  problem.nip, std::get<data::GivenLength>(problem.given).contact_length, rough_enough);
    const double longest_panel = 1.5 * problem.nip.sheet_thickness;
    const std::vector<fast::Estimate> ends = contact.zone_boundaries();
    double panels = 0;
    for (std::size_t i = 1; i < ends.size(); ++i)
      panels += std::max(1.0, std::ceil(std::fabs(ends[i].value - ends[i - 1].value) / longest_panel));
    return 4 * std::pow(panels / 2, 2.3) * std::pow(digits / 16.0, 3.5);
  }
  /// The displacements at a place, computed together, need the responses of about 2500 lines at 20 digits.
  double operator()(const data::HalfSpaceProblem& problem) const {
    const bool displaced = std::ranges::any_of(scene.wanted, [](data::ResultId id) {
      const data::Scale scale = data::scene_result(id).scale;
      return scale == data::Scale::roller_rise || scale == data::Scale::distance_times_creep;
    });
    return displaced ? 2.0 * static_cast<double>(data::count_of(*problem.profile)) : 0;
  }
};

}  // namespace

double likely_seconds_by_ref(const data::Scene& scene, int digits) {
  return unless_refused([&] { return std::visit(LikelySeconds{scene, digits}, scene.system); }).value_or(0);
}

std::string warning_of_time(double seconds) {
  return seconds > long_time
             ? fmt::format("nipref: the reference needs about {:.0f} s for this scene\n", seconds)
             : "";
}

}  // namespace nipref::verify
