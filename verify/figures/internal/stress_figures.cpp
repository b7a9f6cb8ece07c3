#include <algorithm>
#include <string>
#include <utility>

#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/figures/internal/nip_at.hpp>

// Stresses inside the sheet of a nip. (thesis 3.19, 3.20, 4.3, 4.14: the seed derives them and draws none)

namespace nipref::verify {
namespace {

struct StressPart {
  const char* name;
  double (*of)(const fast::InnerStresses& stresses);
  double step;  ///< from contour to contour
};

constexpr StressPart stress_parts[] = {
    {"sigma_x", [](const fast::InnerStresses& s) { return s.across.value; }, 0.1},
    {"sigma_y", [](const fast::InnerStresses& s) { return s.along.value; }, 0.1},
    {"tau_xy", [](const fast::InnerStresses& s) { return s.shear.value; }, 0.05},
    {"maximum shear", [](const fast::InnerStresses& s) { return s.maximum_shear().value; }, 0.05}};

/// Everything over the largest pressure, along the sheet in half contact lengths.
std::vector<Panel> stress_panels(const auto& contact, double thickness) {
  const double half = contact.contact_length().value / 2, peak = contact.peak_pressure().value;
  const double reach = std::max(1.6, thickness / 2 / half);
  const std::vector<double> along = evenly(-reach, reach, 161), depths = evenly(-1, 1, 61);
  std::vector<fast::InnerPoint> points;
  for (const double depth : depths) {
    for (const double place : along) points.push_back({place * half, depth});
  }
  const std::vector<fast::InnerStresses> stresses = contact.inner_stresses(points);
  std::vector<Panel> panels;
  for (const StressPart& part : stress_parts) {
    Contours contours{std::string(part.name) + " over the largest pressure", along, depths, {}, part.step};
    for (const fast::InnerStresses& here : stresses) contours.values.push_back(part.of(here) / peak);
    panels.push_back({{"distance from the middle over half the contact length"},
                      {"x/b, from face to face"},
                      {},
                      false,
                      std::move(contours)});
  }
  const fast::GreatestShear greatest = contact.greatest_shear();
  panels.back().series.push_back(
      {"maximum shear", at_largest, Mark::star, {greatest.y.value / half}, {greatest.depth.value}});
  return panels;
}

std::vector<Panel> inner_stresses(const FigureSubject& subject) {
  constexpr double accuracy = 1e-6;
  const NipAt nip{subject.number("thickness"), subject.number("load"), subject.number("memory"),
                  subject.number("memory") == 0 ? data::Friction::full : data::Friction::none};
  return with_contact(nip, accuracy,
                      [&](const auto& contact) { return stress_panels(contact, nip.thickness); });
}

}  // namespace

Drawings stress_drawing() { return {{"stresses", inner_stresses}}; }

}  // namespace nipref::verify
