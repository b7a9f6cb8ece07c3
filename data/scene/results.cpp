#include <algorithm>
#include <array>

#include <nipref/data/scene/results.hpp>

namespace nipref::data {
namespace {

constexpr SceneResult of_field(std::string_view name, std::string_view meaning) {
  return {name, "stress", meaning, false, SceneKind::nip, false, true, true};
}

constexpr SceneResult of_shear(std::string_view name, std::string_view meaning, bool is_list) {
  SceneResult result{name, "length", meaning, false};
  result.is_list = is_list;
  result.needs = Needs::shear;
  return result;
}

constexpr SceneResult creep_range() {
  SceneResult result{"creep_range", "1",
                     "lowest, highest and chosen creep ratio, of those that the thesis's conditions leave",
                     false};
  result.is_list = true;
  result.needs = Needs::line_load_creep;
  return result;
}

constexpr SceneResult of_surface(std::string_view name, std::string_view meaning) {
  SceneResult result{name, "1", meaning, true};
  result.needs = Needs::converged;
  return result;
}

constexpr std::array results{
    SceneResult{"contact_length", "length", "length L of the contact", false},
    SceneResult{"leading_length", "length",
                "contact L1 ahead of the line through the rollers' centres, on the entry side", false},
    SceneResult{"trailing_length", "length",
                "contact L2 = L - L1 behind that line; negative if all of it is ahead", false},
    SceneResult{"load", "force/length", "load W per unit width", false},
    SceneResult{"indentation", "length", "approach d0 of roller and middle plane", false},
    SceneResult{"edge_displacement", "length",
                "normal displacement d1 = d0 - L1^2/(2R) at the leading end of the contact", false},
    SceneResult{"trailing_displacement", "length", "the same d2 = d0 - L2^2/(2R) at its trailing end", false},
    SceneResult{"rolling_resistance", "1", "moment of the pressure over W R: resistance over load", false},
    SceneResult{"eccentricity", "length",
                "of the resultant load, ahead of that line: R times rolling_resistance", false},
    SceneResult{"resistance_force", "force/length", "load times rolling_resistance", false},
    SceneResult{"power_loss", "power/length", "resistance_force times speed", false},
    SceneResult{"leading_moment", "force", "moment of the pressure ahead of that line about it", false},
    SceneResult{"trailing_moment", "force", "the same behind it, negative", false},
    SceneResult{"creep_ratio", "1",
                "strain v' of the surface in the contact; without friction its mean, (v(L1) - v(-L2))/L",
                false},
    creep_range(),
    SceneResult{"peak_pressure", "stress", "largest pressure", false, SceneKind::nip, true},
    SceneResult{"peak_pressure_position", "length", "Y of its place", false},
    SceneResult{"peak_shear", "stress", "largest magnitude of the shear", false},
    of_shear("peak_shear_position", "Y >= 0 of its place; the same size is at -Y", false),
    of_shear("shear_zeros",
             "places Y >= 0 where the shear surely changes its sign, as far as 1e-6 L/2 from the end", true),
    SceneResult{"span_along", "length",
                "extent of the contact along the motion, through the point of first touch", false,
                SceneKind::half_space},
    SceneResult{"span_across", "length", "the same across the motion", false, SceneKind::half_space},
    SceneResult{"span_ratio", "1", "span_across over span_along", false, SceneKind::half_space},
    SceneResult{"axis_ratio", "1", "minor over major axis of the elliptic contact; exact method", false,
                SceneKind::half_space},
    SceneResult{"orientation", "degree", "of its major axis from x1; exact method", false,
                SceneKind::half_space},
    SceneResult{"approach", "length", "approach of body and half-space; exact method", false,
                SceneKind::half_space},
    SceneResult{"normal_force", "force", "force that presses the body down", false, SceneKind::half_space},
    SceneResult{"friction_force", "force", "friction times normal_force", false, SceneKind::half_space},
    SceneResult{"centre_along", "length",
                "centre of pressure from the point of first touch, along the motion", false,
                SceneKind::half_space},
    SceneResult{"centre_across", "length", "the same across the motion, 90 degrees counterclockwise from it",
                false, SceneKind::half_space},
    SceneResult{"critical_speed", "speed", "smallest speed of this motion at which some line is critical",
                false, SceneKind::half_space},
    SceneResult{"greatest_shear", "stress", "largest maximum_shear inside the sheet", false, SceneKind::nip,
                false, false, true},
    SceneResult{"greatest_shear_position", "length", "Y of its place", false, SceneKind::nip, false, false,
                true},
    SceneResult{"greatest_shear_depth", "1", "depth of its place over half the thickness", false,
                SceneKind::nip, false, false, true},
    of_field("stress_across", "stress sigma_x across the sheet, tension positive"),
    of_field("stress_along", "stress sigma_y along the sheet"),
    of_field("stress_shear", "shear stress tau_xy inside the sheet"),
    of_field("highest_stress", "higher principal stress in the plane of rolling"),
    of_field("lowest_stress", "lower principal stress in the plane of rolling"),
    of_field("maximum_shear", "half the difference of the principal stresses"),
    SceneResult{"pressure", "stress", "pressure; on a half-space along the line of profile.direction", true,
                SceneKind::nip, true},
    SceneResult{
        "shear", "stress",
        "shear on the sheet along Y; on a half-space along the motion, under a rolling sphere along the line",
        true, SceneKind::nip, true},
    SceneResult{"normal_displacement", "length", "displacement u towards the middle plane", true},
    SceneResult{"tangential_displacement", "length",
                "displacement v along Y, relative to the line through the rollers' centres", true},
    of_surface("surface_strain", "strain v' of the surface along Y, also outside the contact"),
    of_surface("slip", "surface_strain less creep_ratio: how much faster than the rollers the surface moves"),
    SceneResult{"span", "length", "extent of the contact in this direction from the motion", true,
                SceneKind::half_space},
    SceneResult{"leading_end", "length",
                "end x+ of the contact in this direction, from the point of first touch", true,
                SceneKind::half_space},
    SceneResult{"trailing_end", "length", "the end x- on the other side, negative", true,
                SceneKind::half_space},
    SceneResult{"creep", "1",
                "V0 in this direction: the surface moves by du/dx = -V0 + x^2/(2 R^2); rolling sphere", true,
                SceneKind::half_space},
    SceneResult{"compressed_radius", "length",
                "r_C in this direction: farther out the pressure oscillates; rolling sphere", true,
                SceneKind::half_space},
    SceneResult{"compliance", "1/stress", "K of the lines of this direction, of both bodies", true,
                SceneKind::half_space},
    SceneResult{"coupling", "1/stress", "S of the lines of this direction, of both bodies", true,
                SceneKind::half_space},
};

}  // namespace

std::span<const SceneResult> scene_results() { return results; }

const SceneResult* find_scene_result(std::string_view name) {
  const auto found = std::ranges::find(results, name, &SceneResult::name);
  return found == results.end() ? nullptr : &*found;
}

}  // namespace nipref::data
