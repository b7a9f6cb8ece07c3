#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>

namespace nipref::fast {

double indentation(const ViscoelasticPressure& contact) {
  return contact.edge_displacement() + std::pow(contact.leading_length(), 2);
}

double trailing_displacement(const ViscoelasticPressure& contact) {
  return contact.edge_displacement() + 4 * contact.offset() * contact.half_length();
}

double eccentricity(const ViscoelasticPressure& contact) {
  return contact.offset() + contact.moment() / contact.load();
}

double peak_pressure(const ViscoelasticPressure& contact) {
  // On each panel the best of a sample, then refined around it.
  constexpr int samples = 12;
  double largest = 0;
  for (const ViscoelasticPanel& panel : contact.layout().panels()) {
    const auto at = [&](double i) {
      return contact.pressure({panel.half, panel.left + panel.width * std::min(i / samples, 1.0)});
    };
    int best = 0;
    for (int i = 1; i <= samples; ++i) {
      if (at(i) > at(best)) best = i;
    }
    if (at(best) < 0.9 * largest) continue;
    const auto negative = [&](double i) { return -at(i); };
    const auto refined = boost::math::tools::brent_find_minima(negative, std::max(best - 1.0, 0.0),
                                                               std::min<double>(best + 1, samples), 30);
    largest = std::max({largest, at(best), -refined.second});
  }
  return largest;
}

}  // namespace nipref::fast
