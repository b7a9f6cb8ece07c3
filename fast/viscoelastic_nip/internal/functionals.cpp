#include <algorithm>
#include <cmath>

#include <nipref/fast/number/internal/sampled_maximum.hpp>
#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>

namespace nipref::fast {
namespace {

constexpr int samples = 12;  ///< of a panel

}  // namespace

double indentation(const ViscoelasticPressure& contact) {
  return contact.edge_displacement() + std::pow(contact.leading_length(), 2);
}

double trailing_displacement(const ViscoelasticPressure& contact) {
  return contact.edge_displacement() + 4 * contact.offset() * contact.half_length();
}

double eccentricity(const ViscoelasticPressure& contact) {
  return contact.offset() + contact.moment() / contact.load();
}

ContactPlace place_of_peak(const ViscoelasticPressure& contact) {
  ContactPlace found{Half::leading, contact.half_length()};
  double largest = 0;
  for (const ViscoelasticPanel& panel : contact.layout().panels()) {
    for (int i = 1; i <= samples; ++i) {
      const ContactPlace place{panel.half, panel.left + panel.width * i / samples};
      const double pressure = contact.pressure(place);
      if (pressure <= largest) continue;
      largest = pressure;
      found = place;
    }
  }
  return found;
}

double peak_pressure(const ViscoelasticPressure& contact) {
  double largest = 0;
  for (const ViscoelasticPanel& panel : contact.layout().panels()) {
    const auto at = [&](double i) {
      return contact.pressure({panel.half, panel.left + panel.width * std::min(i / samples, 1.0)});
    };
    largest = std::max(largest, internal::sampled_maximum(at, samples, 0.9 * largest));
  }
  return largest;
}

}  // namespace nipref::fast
