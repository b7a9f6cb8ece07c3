#include <algorithm>
#include <string>
#include <utility>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>

// Stresses inside the sheet of a nip. (thesis 3.19, 3.20, 4.3, 4.14: the seed derives them and draws none)

namespace nipref::verify {
namespace {

constexpr double field_accuracy = 1e-6, field_load = 100;

/// Everything over the largest pressure, along the sheet in half contact lengths.
template <class Contact>
struct StressGrid {
  const Contact* contact;
  double half_length, peak;
  std::vector<double> along, depths = evenly(-1, 1, 61);
  std::vector<fast::InnerStresses> stresses;

  StressGrid(const Contact& the_contact, double thickness)
      : contact(&the_contact),
        half_length(the_contact.contact_length().value / 2),
        peak(the_contact.peak_pressure().value) {
    const double reach = std::max(1.6, thickness / 2 / half_length);
    along = evenly(-reach, reach, 161);
    std::vector<fast::InnerPoint> points;
    for (const double depth : depths) {
      for (const double place : along) points.push_back({place * half_length, depth});
    }
    stresses = the_contact.inner_stresses(points);
  }

  [[nodiscard]] Panel panel(const char* name, const auto& part, double step) const {
    Contours contours{std::string(name) + " over the largest pressure", along, depths, {}, step};
    for (const fast::InnerStresses& here : stresses) contours.values.push_back(part(here) / peak);
    return {{"distance from the middle over half the contact length"},
            {"x/b, from face to face"},
            {},
            false,
            std::move(contours)};
  }

  [[nodiscard]] std::vector<Panel> panels() const {
    using fast::InnerStresses;
    std::vector<Panel> all{
        panel(
            "sigma_x", [](const InnerStresses& s) { return s.across.value; }, 0.1),
        panel(
            "sigma_y", [](const InnerStresses& s) { return s.along.value; }, 0.1),
        panel(
            "tau_xy", [](const InnerStresses& s) { return s.shear.value; }, 0.05),
        panel(
            "maximum shear", [](const InnerStresses& s) { return s.maximum_shear().value; }, 0.05)};
    const fast::GreatestShear greatest = contact->greatest_shear();
    all.back().series.push_back(
        {"maximum shear", at_largest, Mark::star, {greatest.y.value / half_length}, {greatest.depth.value}});
    return all;
  }
};

std::vector<Panel> elastic_stresses(double thickness) {
  const auto contact =
      fast::converged_for_load({data::seed::roller_radius, thickness, data::seed::sheet_of_the_tables},
                               data::Friction::full, field_load, field_accuracy);
  return StressGrid(contact, thickness).panels();
}

std::vector<Panel> rolling_stresses(double thickness, double memory) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, memory);
  const auto contact =
      fast::converged_for_load({data::seed::roller_radius, thickness, solid, 1}, field_load, field_accuracy);
  return StressGrid(contact, thickness).panels();
}

}  // namespace

std::vector<FigurePlan> stress_figures() {
  const std::string shared = "R = 6 in, W = 100 lbf/in, E (at once) 1.40536e5 psi, nu = 1/3; ";
  return {
      {"thesis-III-thick", "Stresses inside a thick sheet without slip", shared + "B = 1 in",
       [] { return elastic_stresses(1); }},
      {"thesis-III-thin", "Stresses inside a thin sheet without slip", shared + "B = 0.0625 in",
       [] { return elastic_stresses(0.0625); }},
      {"thesis-III-rolling", "Stresses inside a viscoelastic sheet that rolls to the right without friction",
       shared + "B = 0.25 in, F0 tau = 0.1 in, theta2 as it is defined",
       [] { return rolling_stresses(0.25, 0.1); }}};
}

}  // namespace nipref::verify
