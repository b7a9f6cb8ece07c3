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

/// The subject's numbers are the thickness and, of a rolling sheet, F0 tau.
std::vector<Panel> inner_stresses(const FigureSubject& subject) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  const double thickness = subject.number(0);
  if (subject.words.size() == 1) {
    const auto contact = fast::converged_for_load({data::seed::roller_radius, thickness, at_once},
                                                  data::Friction::full, field_load, field_accuracy);
    return StressGrid(contact, thickness).panels();
  }
  const auto solid =
      data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, subject.number(1));
  const auto contact =
      fast::converged_for_load({data::seed::roller_radius, thickness, solid, 1}, field_load, field_accuracy);
  return StressGrid(contact, thickness).panels();
}

}  // namespace

Drawings stress_drawing() { return {{"stresses", inner_stresses}}; }

}  // namespace nipref::verify
