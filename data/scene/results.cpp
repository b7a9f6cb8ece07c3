#include <algorithm>
#include <array>

#include <nipref/data/scene/results.hpp>

namespace nipref::data {
namespace {

constexpr SceneResult as(Shape shape, SceneResult result) {
  result.shape = shape;
  result.is_inside = shape == Shape::field;
  return result;
}
constexpr SceneResult needing(Needs needs, SceneResult result) {
  result.needs = needs;
  return result;
}
constexpr SceneResult inside(SceneResult result) {
  result.is_inside = true;
  return result;
}
constexpr SceneResult of_half_space(SceneResult result) {
  result.kind = SceneKind::half_space;
  return result;
}
constexpr SceneResult in_every_scene(SceneResult result) {
  result.in_every_scene = true;
  return result;
}

constexpr auto results = std::to_array<SceneResult>({
    {ResultId::contact_length, "contact_length", "length", "length L of the contact"},
    {ResultId::leading_length, "leading_length", "length",
     "contact L1 ahead of the line through the rollers' centres, on the entry side"},
    {ResultId::trailing_length, "trailing_length", "length",
     "contact L2 = L - L1 behind that line; negative if all of it is ahead"},
    {ResultId::load, "load", "force/length", "load W per unit width"},
    {ResultId::indentation, "indentation", "length", "approach d0 of roller and middle plane"},
    {ResultId::edge_displacement, "edge_displacement", "length",
     "normal displacement d1 = d0 - L1^2/(2R) at the leading end of the contact"},
    {ResultId::trailing_displacement, "trailing_displacement", "length",
     "the same d2 = d0 - L2^2/(2R) at its trailing end"},
    {ResultId::rolling_resistance, "rolling_resistance", "1",
     "moment of the pressure over W R: resistance over load"},
    {ResultId::eccentricity, "eccentricity", "length",
     "of the resultant load, ahead of that line: R times rolling_resistance"},
    {ResultId::resistance_force, "resistance_force", "force/length", "load times rolling_resistance"},
    {ResultId::power_loss, "power_loss", "power/length", "resistance_force times speed"},
    {ResultId::leading_moment, "leading_moment", "force",
     "moment of the pressure ahead of that line about it"},
    {ResultId::trailing_moment, "trailing_moment", "force", "the same behind it, negative"},
    {ResultId::creep_ratio, "creep_ratio", "1",
     "strain v' of the surface in the contact; without friction its mean, (v(L1) - v(-L2))/L"},
    needing(Needs::line_load_creep,
            as(Shape::list,
               {ResultId::creep_range, "creep_range", "1",
                "lowest, highest and chosen creep ratio, of those that the thesis's conditions leave"})),
    in_every_scene({ResultId::peak_pressure, "peak_pressure", "stress", "largest pressure"}),
    {ResultId::peak_pressure_position, "peak_pressure_position", "length", "Y of its place"},
    {ResultId::peak_shear, "peak_shear", "stress", "largest magnitude of the shear"},
    needing(Needs::shear, {ResultId::peak_shear_position, "peak_shear_position", "length",
                           "Y >= 0 of its place; the same size is at -Y"}),
    needing(Needs::shear,
            as(Shape::list,
               {ResultId::shear_zeros, "shear_zeros", "length",
                "places Y >= 0 where the shear surely changes its sign, as far as 1e-6 L/2 from the end"})),
    of_half_space({ResultId::span_along, "span_along", "length",
                   "extent of the contact along the motion, through the point of first touch"}),
    of_half_space({ResultId::span_across, "span_across", "length", "the same across the motion"}),
    of_half_space({ResultId::span_ratio, "span_ratio", "1", "span_across over span_along"}),
    of_half_space({ResultId::axis_ratio, "axis_ratio", "1",
                   "minor over major axis of the elliptic contact; exact method"}),
    of_half_space(
        {ResultId::orientation, "orientation", "degree", "of its major axis from x1; exact method"}),
    of_half_space(
        {ResultId::approach, "approach", "length", "approach of body and half-space; exact method"}),
    of_half_space({ResultId::normal_force, "normal_force", "force", "force that presses the body down"}),
    of_half_space({ResultId::friction_force, "friction_force", "force", "friction times normal_force"}),
    of_half_space({ResultId::centre_along, "centre_along", "length",
                   "centre of pressure from the point of first touch, along the motion"}),
    of_half_space({ResultId::centre_across, "centre_across", "length",
                   "the same across the motion, 90 degrees counterclockwise from it"}),
    of_half_space({ResultId::critical_speed, "critical_speed", "speed",
                   "smallest speed of this motion at which some line is critical"}),
    inside({ResultId::greatest_shear, "greatest_shear", "stress", "largest maximum_shear inside the sheet"}),
    inside({ResultId::greatest_shear_position, "greatest_shear_position", "length", "Y of its place"}),
    inside({ResultId::greatest_shear_depth, "greatest_shear_depth", "1",
            "depth of its place over half the thickness"}),
    as(Shape::field, {ResultId::stress_across, "stress_across", "stress",
                      "stress sigma_x across the sheet, tension positive"}),
    as(Shape::field, {ResultId::stress_along, "stress_along", "stress", "stress sigma_y along the sheet"}),
    as(Shape::field,
       {ResultId::stress_shear, "stress_shear", "stress", "shear stress tau_xy inside the sheet"}),
    as(Shape::field, {ResultId::highest_stress, "highest_stress", "stress",
                      "higher principal stress in the plane of rolling"}),
    as(Shape::field, {ResultId::lowest_stress, "lowest_stress", "stress",
                      "lower principal stress in the plane of rolling"}),
    as(Shape::field,
       {ResultId::maximum_shear, "maximum_shear", "stress", "half the difference of the principal stresses"}),
    in_every_scene(as(Shape::profile, {ResultId::pressure, "pressure", "stress",
                                       "pressure; on a half-space along the line of profile.direction"})),
    in_every_scene(as(
        Shape::profile,
        {ResultId::shear, "shear", "stress",
         "shear on the sheet along Y; on a half-space along the motion, under a rolling sphere along the line"})),
    as(Shape::profile, {ResultId::normal_displacement, "normal_displacement", "length",
                        "displacement u towards the middle plane"}),
    as(Shape::profile, {ResultId::tangential_displacement, "tangential_displacement", "length",
                        "displacement v along Y, relative to the line through the rollers' centres"}),
    needing(Needs::converged,
            as(Shape::profile, {ResultId::surface_strain, "surface_strain", "1",
                                "strain v' of the surface along Y, also outside the contact"})),
    needing(Needs::converged,
            as(Shape::profile,
               {ResultId::slip, "slip", "1",
                "surface_strain less creep_ratio: how much faster than the rollers the surface moves"})),
    of_half_space(as(Shape::profile, {ResultId::span, "span", "length",
                                      "extent of the contact in this direction from the motion"})),
    of_half_space(
        as(Shape::profile, {ResultId::leading_end, "leading_end", "length",
                            "end x+ of the contact in this direction, from the point of first touch"})),
    of_half_space(as(Shape::profile, {ResultId::trailing_end, "trailing_end", "length",
                                      "the end x- on the other side, negative"})),
    of_half_space(
        as(Shape::profile,
           {ResultId::creep, "creep", "1",
            "V0 in this direction: the surface moves by du/dx = -V0 + x^2/(2 R^2); rolling sphere"})),
    of_half_space(
        as(Shape::profile, {ResultId::compressed_radius, "compressed_radius", "length",
                            "r_C in this direction: farther out the pressure oscillates; rolling sphere"})),
    of_half_space(as(Shape::profile, {ResultId::compliance, "compliance", "1/stress",
                                      "K of the lines of this direction, of both bodies"})),
    of_half_space(as(Shape::profile, {ResultId::coupling, "coupling", "1/stress",
                                      "S of the lines of this direction, of both bodies"})),
});

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].id != static_cast<ResultId>(i)) return false;
  }
  return true;
}
static_assert(are_in_order());

}  // namespace

std::span<const SceneResult> scene_results() { return results; }

const SceneResult* find_scene_result(std::string_view name) {
  const auto found = std::ranges::find(results, name, &SceneResult::name);
  return found == results.end() ? nullptr : &*found;
}

const SceneResult& scene_result(ResultId id) { return results[static_cast<std::size_t>(id)]; }

}  // namespace nipref::data
