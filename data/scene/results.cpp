#include <algorithm>
#include <array>
#include <optional>

#include <nipref/data/scene/results.hpp>

namespace nipref::data {
namespace {

constexpr std::optional<SceneKind> every_scene;

constexpr auto results = std::to_array<SceneResult>({
    {ResultId::contact_length, "contact_length", "length", "full length L of the contact"},
    {ResultId::leading_length, "leading_length", "length",
     "contact L1 ahead of the line through the rollers' centres, on the entry side", Scale::half_contact},
    {ResultId::trailing_length, "trailing_length", "length",
     "contact L2 = L - L1 behind that line; negative if all of it is ahead", Scale::half_contact},
    {ResultId::load, "load", "force/length", "load W per unit width"},
    {ResultId::indentation, "indentation", "length", "approach d0 of roller and middle plane"},
    {ResultId::edge_displacement, "edge_displacement", "length",
     "normal displacement d1 = d0 - L1^2/(2R) at the leading end of the contact", Scale::roller_rise},
    {ResultId::trailing_displacement, "trailing_displacement", "length",
     "the same d2 = d0 - L2^2/(2R) at its trailing end", Scale::roller_rise},
    {ResultId::rolling_resistance, "rolling_resistance", "1",
     "moment of the pressure over W R: resistance over load", Scale::rounding_of_slope},
    {ResultId::eccentricity, "eccentricity", "length",
     "of the resultant load, ahead of that line: R times rolling_resistance", Scale::rolling_resistance},
    {ResultId::resistance_force, "resistance_force", "force/length", "load times rolling_resistance",
     Scale::rolling_resistance},
    {ResultId::power_loss, "power_loss", "power/length", "resistance_force times speed",
     Scale::rolling_resistance},
    {ResultId::leading_moment, "leading_moment", "force",
     "moment of the pressure ahead of that line about it", Scale::half_contact_times_load},
    {ResultId::trailing_moment, "trailing_moment", "force", "the same behind it, negative",
     Scale::half_contact_times_load},
    {ResultId::creep_ratio, "creep_ratio", "1",
     "strain v' of the surface in the contact; without friction its mean, (v(L1) - v(-L2))/L", Scale::creep},
    {ResultId::traction, "traction", "force/length",
     "resultant T of the shear on a face of the sheet, along Y", Scale::load, Shape::number, SceneKind::nip,
     Needs::partial_slip},
    {ResultId::dissipation, "dissipation", "force/length",
     "heat of a face's slip over the distance rolled, per unit width: integral of |shear slip|",
     Scale::itself, Shape::number, SceneKind::nip, Needs::partial_slip},
    {ResultId::zone_boundaries, "zone_boundaries", "length",
     "Y where zones of stick and slip begin and end, from the leading end of the contact to its trailing end",
     Scale::hundred_half_contacts, Shape::list, SceneKind::nip, Needs::partial_slip},
    {ResultId::zone_signs, "zone_signs", "1",
     "of each zone in the same order: 0 where it sticks, otherwise the sign of the shear along Y",
     Scale::itself, Shape::list, SceneKind::nip, Needs::partial_slip},
    {ResultId::creep_range, "creep_range", "1",
     "lowest, highest and chosen creep ratio, of those that the thesis's conditions leave", Scale::itself,
     Shape::list, SceneKind::nip, Needs::line_load_creep},
    {ResultId::peak_pressure, "peak_pressure", "stress", "largest pressure", Scale::itself, Shape::number,
     every_scene},
    {ResultId::peak_pressure_position, "peak_pressure_position", "length", "Y of its place",
     Scale::hundred_half_contacts},
    {ResultId::peak_shear, "peak_shear", "stress", "largest magnitude of the shear",
     Scale::tenth_of_pressure},
    {ResultId::peak_shear_position, "peak_shear_position", "length",
     "Y >= 0 of its place; the same size is at -Y", Scale::hundred_half_contacts, Shape::number,
     SceneKind::nip, Needs::shear},
    {ResultId::shear_zeros, "shear_zeros", "length",
     "places Y >= 0 where the shear surely changes its sign, as far as 1e-6 L/2 from the end",
     Scale::hundred_half_contacts, Shape::list, SceneKind::nip, Needs::shear},
    {ResultId::span_along, "span_along", "length",
     "extent of the contact along the motion, through the point of first touch", Scale::itself, Shape::number,
     SceneKind::half_space},
    {ResultId::span_across, "span_across", "length", "the same across the motion", Scale::itself,
     Shape::number, SceneKind::half_space},
    {ResultId::span_ratio, "span_ratio", "1", "span_across over span_along", Scale::itself, Shape::number,
     SceneKind::half_space},
    {ResultId::axis_ratio, "axis_ratio", "1", "minor over major axis of the elliptic contact; exact method",
     Scale::itself, Shape::number, SceneKind::half_space},
    {ResultId::orientation, "orientation", "degree", "of its major axis from x1; exact method", Scale::radian,
     Shape::number, SceneKind::half_space},
    {ResultId::approach, "approach", "length", "approach of body and half-space; exact method", Scale::itself,
     Shape::number, SceneKind::half_space},
    {ResultId::normal_force, "normal_force", "force", "force that presses the body down", Scale::itself,
     Shape::number, SceneKind::half_space},
    {ResultId::friction_force, "friction_force", "force", "friction times normal_force", Scale::itself,
     Shape::number, SceneKind::half_space},
    {ResultId::centre_along, "centre_along", "length",
     "centre of pressure from the point of first touch, along the motion", Scale::span_along, Shape::number,
     SceneKind::half_space},
    {ResultId::centre_across, "centre_across", "length",
     "the same across the motion, 90 degrees counterclockwise from it", Scale::span_along, Shape::number,
     SceneKind::half_space},
    {ResultId::critical_speed, "critical_speed", "speed",
     "smallest speed of this motion at which some line is critical", Scale::itself, Shape::number,
     SceneKind::half_space},
    {ResultId::greatest_shear, "greatest_shear", "stress", "largest maximum_shear inside the sheet",
     Scale::itself, Shape::number, SceneKind::nip, Needs::inside_all},
    {ResultId::greatest_shear_position, "greatest_shear_position", "length", "Y of its place",
     Scale::flat_maximum, Shape::number, SceneKind::nip, Needs::inside_all},
    {ResultId::greatest_shear_depth, "greatest_shear_depth", "1",
     "depth of its place over half the thickness", Scale::flat_maximum_depth, Shape::number, SceneKind::nip,
     Needs::inside_all},
    {ResultId::stress_across, "stress_across", "stress", "stress sigma_x across the sheet, tension positive",
     Scale::pressure, Shape::field, SceneKind::nip, Needs::inside},
    {ResultId::stress_along, "stress_along", "stress", "stress sigma_y along the sheet", Scale::pressure,
     Shape::field, SceneKind::nip, Needs::inside},
    {ResultId::stress_shear, "stress_shear", "stress", "shear stress tau_xy inside the sheet",
     Scale::pressure, Shape::field, SceneKind::nip, Needs::inside},
    {ResultId::highest_stress, "highest_stress", "stress", "higher principal stress in the plane of rolling",
     Scale::pressure, Shape::field, SceneKind::nip, Needs::inside},
    {ResultId::lowest_stress, "lowest_stress", "stress", "lower principal stress in the plane of rolling",
     Scale::pressure, Shape::field, SceneKind::nip, Needs::inside},
    {ResultId::maximum_shear, "maximum_shear", "stress", "half the difference of the principal stresses",
     Scale::pressure, Shape::field, SceneKind::nip, Needs::inside},
    {ResultId::displacement_across, "displacement_across", "length",
     "displacement u inside the sheet, towards the middle plane from both sides; at depths 1 and -1 "
     "normal_displacement",
     Scale::roller_rise, Shape::field, SceneKind::nip, Needs::inside_elastic},
    {ResultId::displacement_along, "displacement_along", "length",
     "displacement v inside the sheet along Y, relative to the line through the rollers' centres; at depths 1 "
     "and -1 tangential_displacement",
     Scale::roller_rise, Shape::field, SceneKind::nip, Needs::inside_elastic},
    {ResultId::pressure, "pressure", "stress",
     "pressure; on a half-space along the line of profile.direction", Scale::pressure, Shape::profile,
     every_scene},
    {ResultId::shear, "shear", "stress",
     "shear on the sheet along Y; on a half-space along the motion, under a rolling sphere along the line",
     Scale::shear, Shape::profile, every_scene},
    {ResultId::normal_displacement, "normal_displacement", "length",
     "displacement u towards the middle plane; u3 of a half-space into it, at profile.depth, exact method",
     Scale::roller_rise, Shape::profile, every_scene},
    {ResultId::tangential_displacement, "tangential_displacement", "length",
     "displacement v along Y, relative to the line through the rollers' centres; of a half-space along "
     "the motion, relative to what is far away, at profile.depth, exact method",
     Scale::distance_times_creep, Shape::profile, every_scene},
    {ResultId::transverse_displacement, "transverse_displacement", "length",
     "displacement of a half-space across the motion, 90 degrees counterclockwise from it, at profile.depth, exact "
     "method",
     Scale::roller_rise, Shape::profile, SceneKind::half_space},
    {ResultId::surface_strain, "surface_strain", "1",
     "strain v' of the surface along Y, also outside the contact", Scale::creep_next_to_end, Shape::profile,
     SceneKind::nip, Needs::converged},
    {ResultId::slip, "slip", "1",
     "surface_strain less creep_ratio: how much faster than the rollers the surface moves",
     Scale::creep_next_to_end, Shape::profile, SceneKind::nip, Needs::converged},
    {ResultId::heat, "heat", "stress", "heat of a face's slip, per area and over the speed: |shear slip|",
     Scale::tenth_of_pressure_times_creep, Shape::profile, SceneKind::nip, Needs::slip_heat},
    {ResultId::span, "span", "length", "extent of the contact in this direction from the motion",
     Scale::itself, Shape::profile, SceneKind::half_space},
    {ResultId::leading_end, "leading_end", "length",
     "end x+ of the contact in this direction, from the point of first touch", Scale::itself, Shape::profile,
     SceneKind::half_space},
    {ResultId::trailing_end, "trailing_end", "length", "the end x- on the other side, negative",
     Scale::itself, Shape::profile, SceneKind::half_space},
    {ResultId::peak_on_line, "peak_on_line", "stress", "largest pressure on the line of this direction",
     Scale::itself, Shape::profile, SceneKind::half_space},
    {ResultId::creep, "creep", "1",
     "V0 in this direction: the surface moves by du/dx = -V0 + x^2/(2 R^2); rolling sphere", Scale::itself,
     Shape::profile, SceneKind::half_space},
    {ResultId::compressed_radius, "compressed_radius", "length",
     "r_C in this direction: farther out the pressure oscillates; rolling sphere", Scale::itself,
     Shape::profile, SceneKind::half_space},
    {ResultId::compliance, "compliance", "1/stress", "K of the lines of this direction, of both bodies",
     Scale::itself, Shape::profile, SceneKind::half_space},
    {ResultId::coupling, "coupling", "1/stress", "S of the lines of this direction, of both bodies",
     Scale::compliance, Shape::profile, SceneKind::half_space},
});

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].id != static_cast<ResultId>(i)) return false;
  }
  return true;
}
static_assert(are_in_order());

/// In the order of Scale.
constexpr auto scale_texts = std::to_array<std::string_view>({
    "the result itself",
    "L/2",
    "the load",
    "L/2 times the load",
    "50 L, as a traction's slope is known less well than the traction",
    "(L/2)^2/(2R), the rise of the roller's parabola over L/2; on a half-space normal_displacement below the centre",
    "L/(4R)",
    "L/(4R), more next to an end of the contact",
    "L/(4R) times |Y|, outside the contact times L/2; on a half-space normal_displacement below the centre",
    "the pressure in the middle, more next to an end of the contact",
    "a tenth of the pressure in the middle, on a half-space all of it, more next to an end of the contact",
    "a tenth of the pressure in the middle",
    "a tenth of the pressure in the middle times L/(4R)",
    "1e-6/accuracy + 10/sqrt(accuracy), as a maximum is flat at its place",
    "L/2 times 1e-6/accuracy + 10/sqrt(accuracy), as a maximum is flat at its place",
    "L/(2R), of which it may lack 1e-14 at most",
    "L/(2R), of which it may lack 1e-14 at most, times the other factors of the product",
    "one radian",
    "the extent of the contact along the motion",
    "the compliance of the same line",
});

static_assert(scale_texts.size() == static_cast<std::size_t>(Scale::compliance) + 1);

}  // namespace

std::string_view text(Scale scale) { return scale_texts[static_cast<std::size_t>(scale)]; }

std::span<const SceneResult> scene_results() { return results; }

const SceneResult* find_scene_result(std::string_view name) {
  const auto found = std::ranges::find(results, name, &SceneResult::name);
  return found == results.end() ? nullptr : &*found;
}

const SceneResult& scene_result(ResultId id) { return results[static_cast<std::size_t>(id)]; }

}  // namespace nipref::data
