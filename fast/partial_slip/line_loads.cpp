#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/elastic_sheet.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/partial_slip/internal/element_contact.hpp>
#include <nipref/fast/partial_slip/line_loads.hpp>

namespace nipref::fast {

double PartialSlipLineLoads::traction() const {
  double sum = 0;
  for (const FaceLoad& load : loads) sum += load.shear;
  return sum;
}

double PartialSlipLineLoads::dissipation() const {
  return load() * rolling_resistance() - traction() * creep_ratio();
}

PartialSlipLineLoads line_loads_for_load(const data::PartialSlipNip& nip, int elements_per_side,
                                         double load) {
  internal::check_range("elements_per_side", elements_per_side, 1, 1000);
  const PartialSlipTask task = task_for_load(nip, load);
  const ContactUnits units = units_of(nip);
  // A load at an element's centre moves the mean of another element as a load spread over the other moves that centre.
  ElementContact contact =
      element_contact(task, 2 * static_cast<int>(std::ceil(element_reach * elements_per_side)));
  if (!contact.settled)
    throw data::BadInput(
        "elements_per_side", elements_per_side,
        "must be another number: these meet no conditions of stick and slip, or friction moves the "
        "contact beyond them");
  // The mean of e^2 over an element is e^2 of its middle plus width^2/12.
  const double approach = contact.approach + contact.width * contact.width / 12;
  PartialSlipLineLoads result{{.roller_radius = nip.roller_radius,
                               .leading_elements = 0,
                               .leading_length = 0,
                               .indentation = approach * units.displacement,
                               .loads = {},
                               .is_symmetric = false,
                               .sheet = elastic_sheet(nip, LineLoadMethod(elements_per_side), true),
                               .spent = task.work,
                               .gripped_creep = contact.creep * units.creep},
                              {},
                              {}};
  while (!contact.elements.back().presses) contact.elements.pop_back();
  const double width = contact.width * units.length, force = contact.width * units.load;
  for (const ElementContact::Element& element : contact.elements) {
    if (result.loads.empty() && !element.presses) continue;
    const FaceLoad of{-element.e * units.length, element.pressure * force, 0 - element.shear * force};
    result.loads.push_back(of);
    if (of.y > 0) ++result.leading_elements;
    if (!result.zone_signs.empty() && result.zone_signs.back() == -element.sign) continue;
    result.zone_signs.push_back(-element.sign);
    result.zone_boundaries.push_back(of.y + width / 2);
  }
  result.zone_boundaries.push_back(result.loads.back().y - width / 2);
  result.leading_length = result.leading_elements * width;
  return result;
}

}  // namespace nipref::fast
